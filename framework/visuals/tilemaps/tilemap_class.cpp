// The properties and events of Tilemap.

#include <properties/properties.h>
#include <tilemaps/tilemaps.h>

namespace fettle::visuals {

using property::accessor;
using property::Handle;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

std::vector<Property> Tilemaps::map_properties() {
    // A write takes effect in `report`. The hook only writes this class's own memory.
    const auto followed = [this](Property property) {
        property.binding.context = this;
        property.binding.invalidate = [](void* context, property::Row row) {
            Row& written = static_cast<Tilemaps*>(context)->rows_[row];
            written.outdated = true;
            written.source.clear();
        };
        return property;
    };
    const auto derived = [](Property property) {
        property.read_only = property.transient = true;
        property.derives_from = {"map", "tileset", "cells"};
        return property;
    };
    return {
        followed({.name = "map",
                  .type = Type::text,
                  .doc =
                      "A map file of the Tiled editor in the game's folder (TMJ or TMX). Another "
                      "name makes the instances of that file in place of those that were made."}),
        followed({.name = "tileset",
                  .type = Type::text,
                  .doc = "For a map without a file: an image with tiles, or a tileset file of the "
                         "Tiled editor (TSJ or TSX). The map has one layer, `tiles`, of empty "
                         "cells, for `set_tile`."}),
        followed({.name = "tile_size",
                  .type = Type::vec2,
                  .default_value = Vec2(16, 16),
                  .unit = "px",
                  .range = {1, 4096},
                  .doc = "Width and height of a tile in the image `tileset`. A tileset file and a "
                         "map file have their own."}),
        followed({.name = "cells",
                  .type = Type::vec2,
                  .range = {0, 2048},
                  .doc = "For a map without a file: the number of cells side by side, and of "
                         "rows. Cells that were written stay when it changes."}),
        followed({.name = "solid_tiles",
                  .type = Type::list,
                  .range = {1, 1e6},
                  .doc = "For an image `tileset`: the numbers of the solid tiles.",
                  .element = Type::integer}),
        followed({.name = "corner",
                  .type = Type::vec2,
                  .unit = "m",
                  .range = {-1e6, 1e6},
                  .doc = "Where the lower left corner of the map is in the world; of an infinite "
                         "map, the upper left corner of cell (0, 0). Objects are placed once, "
                         "when they are made."}),
        followed({.name = "pixels_per_unit",
                  .type = Type::number,
                  .default_value = 32.0,
                  .unit = "px/m",
                  .range = {1e-3, 1e6},
                  .doc = "Pixels of the map in a meter."}),
        {.name = "smooth",
         .type = Type::boolean,
         .default_value = images_.smooth.value_or(false),
         .doc = "Whether pixels are mixed when tiles are enlarged; otherwise each is a square."},
        {.name = "animation_time",
         .type = Type::number,
         .unit = "s",
         .range = {0, 1e9},
         .doc = "Time since the animations of the tiles began.",
         .binding = accessor(
             *this, [](Tilemaps& t, property::Row row) { return t.rows_[row].time; },
             [](Tilemaps& t, property::Row row, const Value& value) {
                 t.rows_[row].time = value.number();
             }),
         .simulated = true},
        {.name = "made_from",
         .type = Type::text,
         .doc = "The map file, or the values of a map without one, that the instances below it "
                "were made from.",
         .hidden = true},
        {.name = "made",
         .type = Type::list,
         .doc = "The instances that were made from the map file, without those below them.",
         .hidden = true,
         .element = Type::reference},
        {.name = "followed",
         .type = Type::integer,
         .doc = "What its collisions were made of last, as a number; 0: of nothing.",
         .hidden = true},
        derived({.name = "columns",
                 .type = Type::integer,
                 .doc = "Number of cells side by side; 0 for an infinite map.",
                 .binding = accessor(*this,
                                     [](Tilemaps& t, property::Row row) {
                                         const auto file = t.loaded(t.rows_[row].self);
                                         return Value(
                                             file && !file->map().infinite ? file->map().width : 0);
                                     })}),
        derived({.name = "rows",
                 .type = Type::integer,
                 .doc = "Number of rows of cells; 0 for an infinite map.",
                 .binding = accessor(*this,
                                     [](Tilemaps& t, property::Row row) {
                                         const auto file = t.loaded(t.rows_[row].self);
                                         return Value(file && !file->map().infinite
                                                          ? file->map().height
                                                          : 0);
                                     })}),
        [&] {
            Property size = derived(
                {.name = "size",
                 .type = Type::vec2,
                 .unit = "m",
                 .doc = "Width and height of the map; 0 for an infinite map.",
                 .binding = accessor(*this, [](Tilemaps& t, property::Row row) {
                     const Handle self = t.rows_[row].self;
                     const auto file = t.loaded(self);
                     if (file == nullptr || file->map().infinite) return Vec2(0, 0);
                     const maps::Map& map = file->map();
                     return Vec2(Vec2(map.width * map.tile_width, map.height * map.tile_height) /
                                 t.pixels_per_unit(self));
                 })});
            size.derives_from.insert(size.derives_from.end(), {"tile_size", "pixels_per_unit"});
            return size;
        }(),
    };
}

property::Lifecycle Tilemaps::map_lifecycle() {
    property::Lifecycle made;
    made.context = this;
    made.create = [](void* context, property::Tree&, Handle self) {
        return static_cast<Tilemaps*>(context)->rows_.add(self);
    };
    made.place = [](void* context, property::Tree& tree, Handle self, property::Row row) {
        auto& maps = *static_cast<Tilemaps*>(context);
        maps.rows_[row].outdated = true;
        if (!tree.parent(self)) return row;
        maps.make_if_new(self);
        return row;
    };
    made.destroy = [](void* context, property::Tree&, Handle, property::Row row) {
        static_cast<Tilemaps*>(context)->rows_.remove(row);
    };
    return made;
}

void Tilemaps::define_map(property::Tree& tree) {
    property::ClassDescriptor described{
        .name = "Tilemap",
        .doc =
            "A map of the Tiled editor, or one that a script makes of a `tileset`. Its tile "
            "layers, "
            "image layers and objects become instances below it, and solid tiles a body with "
            "smooth outlines. Belongs below a World if bodies are to collide with it.",
        .properties = map_properties(),
        .methods = methods(),
        .events = {
            {.name = "loaded",
             .doc =
                 "It has instances for its map file. Its collisions follow at the same barrier."},
            {.name = "cell_changed",
             .fields = {{.name = "layer",
                         .type = Type::reference,
                         .doc = "The layer of the cell.",
                         .reference_class = "TileLayer"},
                        {.name = "x", .type = Type::integer, .doc = "Column, from 0."},
                        {.name = "y", .type = Type::integer, .doc = "Row from the top, from 0."},
                        {.name = "tile", .type = Type::integer, .doc = "The tile there now."},
                        {.name = "before", .type = Type::integer, .doc = "The tile before."}},
             .doc = "set_tile changed a cell."}}};
    described.lifecycle = map_lifecycle();
    const property::Class& made = tree.define(std::move(described));
    map_class_ = &made;
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("map"),         of("tileset"), of("tile_size"),       of("cells"),
           of("solid_tiles"), of("corner"),  of("pixels_per_unit"), of("smooth"),
           of("made_from"),   of("made"),    of("followed")};
    loaded_event_ = made.event("loaded");
    cell_changed_ = made.event("cell_changed");
}

}  // namespace fettle::visuals
