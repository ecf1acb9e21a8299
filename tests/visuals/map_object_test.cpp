// Objects of maps: the instances that are made of them.

#include <catch.h>

#include "levels.h"

namespace map_object_test {

using namespace fettle::visuals::test;

TEST_CASE_METHOD(Land, "objects become instances of their class") {
    define_bodies();
    tree.define({.name = "Door",
                 .properties = {{.name = "position", .type = Type::vec2},
                                {.name = "angle", .type = Type::number},
                                {.name = "locked", .type = Type::boolean},
                                {.name = "leads_to", .type = Type::reference}}});
    write("level.tmj", level(floor_cells, R"(, {"type": "objectgroup", "id": 9, "name": "things",
        "objects": [
        {"id": 1, "name": "in", "type": "Door", "x": 16, "y": 16, "width": 16, "height": 32,
         "properties": [{"name": "locked", "type": "bool", "value": true},
                        {"name": "leads_to", "type": "object", "value": 2},
                        {"name": "note", "type": "string", "value": "knock"}]},
        {"id": 2, "name": "out", "type": "Door", "x": 32, "y": 0, "point": true, "rotation": 90},
        {"id": 3, "x": 48, "y": 48, "point": true, "type": "Spawn"},
        {"id": 4, "name": "crate", "type": "Body", "x": 0, "y": 0, "width": 16, "height": 8},
        {"id": 5, "name": "path", "x": 16, "y": 16,
         "polyline": [{"x": 0, "y": 0}, {"x": 16, "y": 16}]},
        {"id": 6, "gid": 2147483652, "x": 32, "y": 48, "width": 32, "height": 16},
        {"id": 7, "name": "out", "x": 0, "y": 0, "point": true}]})"));
    const Handle things = find(map(), "things");
    const Handle in = find(things, "in"), out = find(things, "out");
    CHECK(tree.class_of(in).name() == "Door");
    CHECK(tree.get(in, "position") == Value(Vec2(1.5, 1)));
    CHECK(tree.get(in, "locked") == Value(true));
    CHECK(tree.get(in, "leads_to") == Value(out));
    CHECK(tree.get(in, "note") == Value("knock"));
    CHECK(tree.get(out, "angle").number() == Approx(-1.5707963));
    const Handle spawn = find(things, "object_1");
    CHECK(tree.get(spawn, "kind") == Value("Spawn"));
    CHECK(tree.get(spawn, "position") == Value(Vec2(3, 0)));
    const Handle crate = find(things, "crate");
    CHECK(tree.get(crate, "position") == Value(Vec2(0.5, 2.75)));
    CHECK(tree.get(find(crate, "shape"), "height") == Value(0.5));
    CHECK(tree.get(find(things, "path"), "points") == Value(List{Vec2(0, 0), Vec2(1, -1)}));
    const Handle sprite = find(things, "sprite_1");
    CHECK(tree.get(sprite, "image") == Value("tiles.tga"));
    CHECK(tree.get(sprite, "frame") == Value(4));
    CHECK(tree.get(sprite, "size") == Value(Vec2(2, 1)));
    CHECK(tree.get(sprite, "flip_x") == Value(true));
    CHECK(tree.get(sprite, "position") == Value(Vec2(3, 0.5)));
    CHECK(find(things, "out_2"));
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Land, "a tile as an object is cut out of its image as the tiles of cells are") {
    // Tiles of 4 pixels with a distance of 1; the image has room for two and a half.
    write("dots.tga", tga(13, 6));
    write("level.tmx",
          R"(<map orientation="orthogonal" width="1" height="1" tilewidth="4" tileheight="4">
        <tileset firstgid="1" name="dots" tilewidth="4" tileheight="4" spacing="1" margin="1" columns="2" tilecount="2">
        <image source="dots.tga" width="13" height="6"/></tileset>
        <objectgroup name="things"><object id="1" gid="2" x="0" y="4" width="4" height="4"/></objectgroup></map>)");
    map("level.tmx");
    const auto drawn = draw();
    REQUIRE(drawn.size() == 1);
    CHECK(drawn[0].area.left == 6);
    CHECK(drawn[0].area.top == 1);
    CHECK(drawn[0].area.width == 4);
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Land, "an object that cannot be made is reported with its place") {
    write("level.tmj", level(floor_cells, R"(, {"type": "objectgroup", "id": 9, "name": "things",
        "objects": [
        {"id": 1, "name": "hero", "type": "Sprit", "x": 0, "y": 0, "point": true},
        {"id": 2, "type": "Sprite", "x": 0, "y": 0, "point": true,
         "properties": [{"name": "scale", "type": "string", "value": "big"}]},
        {"id": 3, "type": "Tilemap", "x": 0, "y": 0, "point": true,
         "properties": [{"name": "map", "type": "string", "value": "level.tmj"}]}]})"));
    map();
    REQUIRE(problems.size() == 3);
    std::string all;
    for (const std::string& problem : problems) all += problem + "\n";
    CHECK_THAT(all, contains("level.tmj: object 1 \"hero\"") &&
                        contains("did you mean \"Sprite\"") && contains("object 2") &&
                        contains("scale") && contains("a map cannot make a Tilemap"));
}

TEST_CASE_METHOD(Land, "cells whose tile no tileset has are reported") {
    write("level.tmj", R"({"type":"map","orientation":"orthogonal","width":2,"height":2,
        "tilewidth":8,"tileheight":8,"tilesets":[],
        "layers":[{"type":"tilelayer","id":1,"name":"ground","width":2,"height":2,
                   "data":[7,0,8,0]}]})");
    map();
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0],
               contains("layer \"ground\": no tileset has the tile 7; 2 cells stay empty"));
}

}  // namespace map_object_test
