// The properties of TileLayer.

#include <utility>

#include <properties/properties.h>
#include <tilemaps/tilemaps.h>

namespace fettle::visuals {

using property::Handle;
using property::Property;
using property::Type;
using property::Vec2;

std::vector<Property> Tilemaps::layer_properties() {
    // After a write, `report` updates the body of the map. The hook only writes this class's
    // memory.
    const auto followed = [this](Property property) {
        property.binding.context = this;
        property.binding.invalidate = [](void* context, property::Row row) {
            auto& maps = *static_cast<Tilemaps*>(context);
            maps.outdate(maps.tree_->parent(maps.layer_rows_[row].self));
        };
        return property;
    };
    return {
        followed({.name = "layer",
                  .type = Type::integer,
                  .range = {0, 1e9},
                  .doc = "Number of the layer in the map file, as the editor gave it."}),
        followed({.name = "changes",
                  .type = Type::list,
                  .doc = "The cells that differ from the map file, a text for each row, such as "
                         "\"3: 7=12 8=0\": in row 3, column 7 has tile 12 and column 8 none.",
                  .element = Type::text}),
        followed({.name = "offset",
                  .type = Type::vec2,
                  .unit = "m",
                  .range = {-1e6, 1e6},
                  .doc = "Moves the whole layer, its collisions too."}),
        {.name = "parallax",
         .type = Type::vec2,
         .default_value = Vec2(1, 1),
         .range = {-1e3, 1e3},
         .doc = "How fast it moves past when the view moves: 1 as the world, 0.5 half as fast, 0 "
                "not at all."},
        {.name = "opacity",
         .type = Type::number,
         .default_value = 1.0,
         .range = {0, 1},
         .doc = "Multiplies the opacity of its tiles."},
        {.name = "tint",
         .type = Type::color,
         .default_value = property::Color{1, 1, 1, 1},
         .range = {0, 1},
         .doc = "The colors of its tiles are multiplied by it."},
        blend_property(),
        visible_property(),
        followed(
            {.name = "solid",
             .type = Type::boolean,
             .default_value = true,
             .doc = "Whether bodies collide with its solid tiles: those with collision shapes, and "
                    "those with the custom property `solid`."}),
        followed({.name = "friction",
                  .type = Type::number,
                  .default_value = 0.6,
                  .range = {0, 1e6},
                  .doc = "Friction of its solid tiles."}),
        followed({.name = "restitution",
                  .type = Type::number,
                  .range = {0, 1},
                  .doc = "Share of the speed with which bodies bounce off its solid tiles."}),
    };
}

void Tilemaps::define_layer(property::Tree& tree) {
    property::ClassDescriptor described{
        .name = "TileLayer",
        .doc =
            "A layer of tiles of the Tilemap that it is below. The map makes one for each tile "
            "layer of its file.",
        .properties = layer_properties(),
        .stem = "layer"};
    property::Lifecycle& lifecycle = described.lifecycle;
    lifecycle.context = this;
    lifecycle.create = [](void* context, property::Tree&, Handle self) {
        return static_cast<Tilemaps*>(context)->layer_rows_.add(self);
    };
    // Both the map that the layer leaves and the one that it enters need other collisions.
    lifecycle.place = [](void* context, property::Tree& of, Handle self, property::Row row) {
        auto& maps = *static_cast<Tilemaps*>(context);
        const Handle now = of.parent(self);
        maps.outdate(std::exchange(maps.layer_rows_[row].map, now));
        maps.outdate(now);
        return row;
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle, property::Row row) {
        auto& maps = *static_cast<Tilemaps*>(context);
        const Handle map = maps.layer_rows_[row].map;
        maps.layer_rows_.remove(row);
        maps.outdate(map);
    };
    lifecycle.draw = [](void* context, const property::Tree&, Handle self, property::Row,
                        property::Painter& painter,
                        double) { static_cast<Tilemaps*>(context)->draw(self, painter); };
    const property::Class& made = tree.define(std::move(described));
    layer_class_ = &made;
    const auto of = [&](const char* name) { return made.property(name); };
    in_layer_ = {of("layer"),   of("changes"),  of("offset"),     of("parallax"),
                 of("opacity"), of("tint"),     of("blend"),      of("visible"),
                 of("solid"),   of("friction"), of("restitution")};
}

}  // namespace fettle::visuals
