#pragma once
// The classes Tilemap and TileLayer: a map of the Tiled editor as instances.

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <fettle/module/rows.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <images/images.h>
#include <tilemaps/empty_map.h>
#include <tilemaps/grid.h>
#include <tilemaps/loaded_map.h>

namespace fettle::visuals {

struct WantedChain;

class Tilemaps {
  public:
    explicit Tilemaps(Images& images) : images_(images) {}
    ~Tilemaps();
    Tilemaps(const Tilemaps&) = delete;
    void define(property::Tree& tree);
    void step(double dt);
    /// Applies writes of properties: another map, other collisions.
    void report();
    /// Marks all maps for `report`: a snapshot may have been made between a write and the update of
    /// the collisions.
    void restored();
    std::uint64_t hash() const;

    // --- tilemap_methods.cpp: what the methods do. They throw std::invalid_argument with a reason.
    PackedCell cell(property::Handle map, const property::Value& x, const property::Value& y,
                    const property::Value& layer);
    void set_tile(property::Handle map, std::span<const property::Value> given);
    void set_tiles(property::Handle map, std::span<const property::Value> given);
    void change_cells(property::Handle map, property::Handle layer,
                      std::span<const Grid::Cell> cells);
    property::Vec2 cell_at(property::Handle map, const property::Vec2& point);
    property::Vec2 cell_center(property::Handle map, const property::Value& x,
                               const property::Value& y);
    /// A list of points, or nil.
    property::Value path(property::Handle map, const property::Vec2& from, const property::Vec2& to,
                         bool diagonals);
    property::Value tile_property(property::Handle map, const property::Value& tile,
                                  const std::string& name);
    // --- map_layers.cpp
    void reload(property::Handle map);
    /// A file of the game has changed: maps that are made of it are made again.
    void renew(const std::string& file);

  private:
    struct Row {
        property::Handle self{};  // null: the row is free
        double time = 0;          // s, of the animations of tiles
        bool outdated = false;    // a property was written from which its instances are made
        std::string source{};     // of `source()`; "": not known
    };
    struct LayerRow {
        property::Handle self{};
        property::Handle map{};  // its parent, which need not be a map
        // The data from which `grid` was made.
        std::shared_ptr<const LoadedMap> file{};
        std::int64_t id = 0;
        property::Value changes{};
        Grid grid{};
    };
    struct MapProperties {
        const property::Property *map, *tileset, *tile_size, *cells, *solid_tiles, *corner,
            *pixels_per_unit, *smooth, *made_from, *made, *followed;
    };
    struct LayerProperties {
        const property::Property *layer, *changes, *offset, *parallax, *opacity, *tint, *blend,
            *visible, *solid, *friction, *restitution;
    };

    // --- tilemap_class.cpp, tile_layer_class.cpp
    void define_map(property::Tree& tree);
    void define_layer(property::Tree& tree);
    std::vector<property::Property> map_properties();
    std::vector<property::Property> layer_properties();

    // --- tilemap_methods.cpp
    std::vector<property::Method> methods();
    std::vector<property::Method> cell_methods();
    std::shared_ptr<const LoadedMap> required(property::Handle map);
    property::Handle layer_named(property::Handle map, const property::Value& name);

    // --- tilemaps.cpp
    bool is_map(property::Handle instance) const;
    bool is_layer(property::Handle instance) const;
    /// Null if the instance has no map, or its file cannot be read; this is reported once.
    std::shared_ptr<const LoadedMap> loaded(property::Handle map);
    std::shared_ptr<const LoadedMap> read(property::Handle map);
    /// What the map is made of: the name of its file, the key of an EmptyMap, or "".
    const std::string& source(property::Handle map);
    EmptyMap empty_map(property::Handle map) const;
    /// The cells of a layer as they are now; null if it has no map.
    Grid* grid(property::Handle layer);
    std::vector<property::Handle> tile_layers(property::Handle map) const;
    std::vector<property::Handle> solid_layers(property::Handle map) const;
    /// The upper left corner of cell (0, 0) in the world.
    property::Vec2 upper_left(property::Handle map, const maps::Map& of) const;
    double pixels_per_unit(property::Handle map) const;
    void report(property::Handle map, const std::string& problem);
    /// Marks the map for `report`; no effect if the instance is not alive or not a map.
    void outdate(property::Handle map);
    property::Lifecycle map_lifecycle();

    // --- map_layers.cpp
    /// Makes the instances of the map file unless they were made before.
    void make_if_new(property::Handle map);
    void make(property::Handle map, std::map<std::int64_t, property::Value> changes);
    /// The changed cells of each layer, by its number.
    std::map<std::int64_t, property::Value> changes_of(property::Handle map) const;

    // --- map_bodies.cpp
    /// Gives the body below the map the outlines of the solid cells, unless it got these already.
    void update_bodies(property::Handle map);
    std::vector<WantedChain> wanted_chains(property::Handle map);
    property::Handle make_body(property::Handle map, const property::Class& of);

    // --- tile_drawing.cpp
    void draw(property::Handle layer, property::Painter& painter);

    Images& images_;
    property::Tree* tree_ = nullptr;
    const property::Class *map_class_ = nullptr, *layer_class_ = nullptr;
    MapProperties of_{};
    LayerProperties in_layer_{};
    const property::Event *loaded_event_ = nullptr, *cell_changed_ = nullptr;
    module::Rows<Row> rows_;
    module::Rows<LayerRow> layer_rows_;
    std::vector<property::Connection> handlers_{};
    // By `source`. Null: it cannot be read.
    std::map<std::string, std::shared_ptr<const LoadedMap>> files_{};
};

}  // namespace fettle::visuals
