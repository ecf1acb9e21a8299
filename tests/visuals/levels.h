#pragma once
// Small maps as the editor Tiled writes them, and stand-ins for the classes of a physics module.

#include "gallery.h"

namespace fettle::visuals::test {

/// Tiles of 16 pixels, four of them: 1 is solid, 2 is a slope that rises to the right, 3 is solid
/// from above, 4 is animated and not solid.
inline const char* const tileset = R"({"type": "tileset", "name": "tiles", "tilewidth": 16,
    "tileheight": 16, "tilecount": 4, "columns": 4, "image": "tiles.tga", "imagewidth": 64,
    "imageheight": 16, "tiles": [
    {"id": 0, "properties": [{"name": "solid", "type": "bool", "value": true},
                             {"name": "gold", "type": "int", "value": 5}]},
    {"id": 1, "type": "Slope", "objectgroup": {"objects": [{"id": 1, "x": 0, "y": 0,
        "polygon": [{"x": 0, "y": 16}, {"x": 16, "y": 16}, {"x": 16, "y": 0}]}]}},
    {"id": 2, "objectgroup": {"objects": [{"id": 1, "x": 0, "y": 0,
        "polyline": [{"x": 0, "y": 0}, {"x": 16, "y": 0}]}]}},
    {"id": 3, "animation": [{"tileid": 3, "duration": 100}, {"tileid": 0, "duration": 100}]}]})";

/// A map of 4 by 3 cells with one tile layer `ground`. `more`: other layers, `of_ground`: other
/// members of the layer `ground`; both are JSON and begin with a comma.
inline std::string level(const std::string& cells, const std::string& more = "",
                         const std::string& of_ground = "") {
    return R"({"type": "map", "orientation": "orthogonal", "width": 4, "height": 3,
        "tilewidth": 16, "tileheight": 16, "infinite": false,
        "properties": [{"name": "music", "type": "string", "value": "cave"}],
        "tilesets": [{"firstgid": 1, "source": "tiles.tsj"}],
        "layers": [{"type": "tilelayer", "id": 7, "name": "ground", "width": 4, "height": 3)" +
           of_ground + R"(, "data": [)" + cells + "]}" + more + "]}";
}

inline const char* const floor_cells = "0,0,0,0, 0,0,0,0, 1,1,1,1";

struct Land : Gallery {
    Land() {
        write("tiles.tga", tga(64, 16));
        write("tiles.tsj", tileset);
        write("level.tmj", level(floor_cells));
    }
    /// `Body`, `Box` and `Chain` with some properties of the physics module, without any physics.
    void define_bodies() {
        tree.define(
            {.name = "Body",
             .properties = {{.name = "type", .type = Type::text, .default_value = "dynamic"},
                            {.name = "position", .type = Type::vec2}}});
        tree.define({.name = "Box",
                     .properties = {{.name = "width", .type = Type::number},
                                    {.name = "height", .type = Type::number}}});
        tree.define({.name = "Chain",
                     .properties = {{.name = "points",
                                     .type = Type::list,
                                     .range = {-1e3, 1e3},
                                     .element = Type::vec2},
                                    {.name = "closed", .type = Type::boolean},
                                    {.name = "friction", .type = Type::number},
                                    {.name = "restitution", .type = Type::number},
                                    {.name = "visible", .type = Type::boolean}}});
    }
    Handle map(const std::string& file = "level.tmj", double pixels_per_unit = 16) {
        const Handle made = tree.create(tree.class_named("Tilemap"));
        tree.set(made, "map", Value(file));
        tree.set(made, "pixels_per_unit", Value(pixels_per_unit));
        tree.move(made, tree.root(), "map");
        return made;
    }
    Handle find(Handle below, std::string_view name) {
        const Handle found = tree.child(below, name);
        std::string names;
        for (const Handle child : tree.children(below)) names += " " + tree.name(child);
        INFO(name << " among" << names);
        REQUIRE(found);
        return found;
    }
    Value call(Handle map, const char* method, std::initializer_list<Value> given) {
        return std::get<Value>(tree.call(map, method, given));
    }
    std::int64_t tile(Handle map, int x, int y) {
        return call(map, "tile", {Value(x), Value(y)}).integer();
    }
    std::vector<Handle> chains(Handle map) {
        const Handle body = tree.child(map, "collisions");
        return body ? tree.children(body) : std::vector<Handle>();
    }
    List points(Handle chain) { return tree.get(chain, "points").list(); }
};

}  // namespace fettle::visuals::test
