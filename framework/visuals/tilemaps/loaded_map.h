#pragma once
// A map file that was read: the pictures and the solid outlines of its tiles.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/maps/map.h>
#include <fettle/maps/outlines.h>
#include <fettle/property/picture.h>

#include <images/images.h>

namespace fettle::visuals {

/// The picture of a tile. Lengths in pixels, y down.
struct TileLook {
    std::shared_ptr<const Sheet> sheet{};  // null: the tile has no picture
    property::PictureArea area{};
    property::Vec2 size{0, 0};
    property::Vec2 offset{0, 0};  // from the lower left corner of the cell to that of the tile
    std::vector<maps::Frame> frames{};  // `tile`: number in the map; empty: not animated
    double seconds = 0;                 // of all frames
};

/// Where a tile is solid, in pixels from the lower left corner of its cell, y up.
struct TileShape {
    bool whole = false;  // the whole cell
    std::vector<maps::Outline> polygons{};
    std::vector<maps::Outline> lines{};  // solid from their left side only
};

/// A map file, with the images of its tilesets.
class LoadedMap {
  public:
    /// `user`: the property that names the map, for messages about its images.
    LoadedMap(maps::Map map, std::string user, Images& images);

    const maps::Map& map() const { return map_; }
    /// Null for a tile that does not exist.
    const TileLook* look(std::uint32_t tile) const;
    /// Null for a tile that is not solid.
    const TileShape* shape(std::uint32_t tile) const;
    /// The shapes of a tile, flipped.
    static TileShape flipped(const TileShape& shape, std::uint32_t flips,
                             const property::Vec2& size);
    /// The frame of an animated tile that is shown at that time; the tile itself if it has none.
    std::uint32_t frame(std::uint32_t tile, double seconds) const;
    /// The layer with that id, also inside of groups; null if there is none.
    const maps::Layer* layer(std::int64_t id) const;
    /// Pixels by which a drawn tile may reach beyond its cell.
    const property::Vec2& reach() const { return reach_; }
    /// The largest number of a tile.
    std::uint32_t last_tile() const;

  private:
    TileLook make_look(std::uint32_t tile) const;
    /// Transparent colors, and the numbers of tiles of files that do not say them.
    void prepare_images();
    void prepare_images(const std::vector<maps::Layer>& layers);
    void add_shapes(const maps::Tileset& set);

    maps::Map map_;
    std::string user_;
    Images& images_;
    property::Vec2 reach_{0, 0};
    mutable std::unordered_map<std::uint32_t, TileLook> looks_{};
    std::unordered_map<std::uint32_t, TileShape> shapes_{};
};

}  // namespace fettle::visuals
