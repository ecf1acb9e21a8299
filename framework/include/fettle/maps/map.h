#pragma once
// Maps of the Tiled editor (https://doc.mapeditor.org): JSON (.tmj, .tsj, .tj) and XML (.tmx, .tsx,
// .tx), with embedded and external tilesets, templates, infinite maps and all compressions of
// cells. Lengths and positions are those of the editor: pixels, y down.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fettle/maps/export.h>
#include <fettle/property/value.h>

FETTLE_MAPS_BEGIN

namespace fettle::maps {

/// Custom properties by name. Boolean, integer, number, text, color; a file is a text, an object
/// its id. A member of a class has the name "property.member".
using Properties = std::map<std::string, property::Value>;

/// A cell of a layer, or the tile of an object.
struct Cell {
    std::uint32_t gid = 0;  // number of the tile in the map, from 1; 0: empty
    bool flip_x = false, flip_y = false;
    bool flip_diagonal = false;  // exchanges x and y; applied before the other two

    bool empty() const { return gid == 0; }
    bool operator==(const Cell&) const = default;
};

enum class ObjectKind : std::uint8_t { rectangle, ellipse, point, polygon, polyline, text, tile };

struct Object {
    std::int64_t id = 0;
    std::string name{}, class_name{};
    ObjectKind kind = ObjectKind::rectangle;
    /// The upper left corner; of a tile the lower left one, unless its tileset says otherwise.
    property::Vec2 position{0, 0};
    property::Vec2 size{0, 0};
    double rotation = 0;  // degrees, clockwise, about `position`
    bool visible = true;
    std::vector<property::Vec2> points{};  // of a polygon or a polyline, relative to `position`
    Cell tile{};
    std::string text{};
    Properties properties{};
};

struct Frame {
    std::uint32_t tile = 0;  // number in the tileset, from 0
    double seconds = 0;
};

/// A tile with more than its picture in the image of the tileset.
struct Tile {
    std::string class_name{};
    std::string image{};  // of its own, in a tileset that is a collection of images
    property::Vec2 image_size{0, 0};
    std::vector<Object> collision{};  // shapes, relative to the upper left corner of the tile
    std::vector<Frame> animation{};
    Properties properties{};
};

struct Tileset {
    std::uint32_t first_gid = 1;
    std::string name{}, class_name{};
    int tile_width = 0, tile_height = 0;
    int count = 0, columns = 0;       // columns 0: a collection of images
    int spacing = 0, margin = 0;      // px between tiles; px around all tiles
    std::string image{};              // relative to the folder of the game, as all files of a map
    property::Vec2 image_size{0, 0};  // px; 0 if the file does not say it
    std::optional<property::Color> transparent{};  // pixels of the image of this color are not seen
    property::Vec2 offset{0, 0};                   // px, added to the position of each drawn tile
    std::string alignment{};                       // of tile objects: "topleft", "center", ...
    std::map<std::uint32_t, Tile> tiles{};         // by number in the tileset
    Properties properties{};

    /// Counts the tiles by the size of the image, if the file does not say how many there are.
    void count_tiles();
    bool contains(std::uint32_t gid) const {
        return gid >= first_gid && gid - first_gid < static_cast<std::uint32_t>(count);
    }
};

enum class LayerKind : std::uint8_t { tiles, objects, image, group };

/// A rectangle of cells, row by row.
struct Cells {
    int x = 0, y = 0;  // of the first cell, in cells
    int width = 0, height = 0;
    std::vector<Cell> cells{};
};

struct Layer {
    LayerKind kind = LayerKind::tiles;
    std::int64_t id = 0;
    std::string name{}, class_name{};
    bool visible = true;
    double opacity = 1;
    property::Color tint{1, 1, 1, 1};
    property::Vec2 offset{0, 0};    // px
    property::Vec2 parallax{1, 1};  // 1: moves with the camera; 0: stays on the screen
    std::vector<Cells> cells{};     // several in an infinite map
    std::vector<Object> objects{};
    std::string image{};
    std::optional<property::Color> transparent{};  // as of a tileset
    bool repeat_x = false, repeat_y = false;       // of an image
    std::vector<Layer> layers{};                   // of a group
    Properties properties{};
};

enum class Orientation : std::uint8_t { orthogonal, isometric, staggered, hexagonal };

struct Map {
    std::string class_name{};
    Orientation orientation = Orientation::orthogonal;
    int width = 0, height = 0;            // in cells
    int tile_width = 0, tile_height = 0;  // px
    bool infinite = false;
    property::Color background{0, 0, 0, 0};
    int hex_side = 0;         // px
    bool stagger_x = false;   // staggered columns instead of rows
    bool stagger_odd = true;  // the odd rows or columns are moved
    std::vector<Tileset> tilesets{};
    std::vector<Layer> layers{};
    Properties properties{};

    /// The tileset of a tile; null for 0 and for numbers that no tileset has.
    const Tileset* tileset_of(std::uint32_t gid) const;
    /// The description of the tile in its tileset; null if there is none.
    const Tile* tile(std::uint32_t gid) const;
};

/// Returns the text of a file. Its name is relative to the folder of the game.
using ReadFile = std::function<std::string(const std::string& name)>;

/// Reads a map and all tilesets and templates that it names. Throws Error(damaged) with file, place
/// and reason, and what `read` throws.
Map read_map(const std::string& file, const ReadFile& read);

/// Reads a tileset file. Its first tile has the number 1. Throws as `read_map` does.
Tileset read_tileset(const std::string& file, const ReadFile& read);

}  // namespace fettle::maps

FETTLE_MAPS_END
