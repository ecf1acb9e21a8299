// Maps: their layers, cells and pictures.

#include <catch.h>

#include <random>

#include <fettle/property/storage/scene.h>

#include "levels.h"

namespace tilemap_test {

using namespace fettle::visuals::test;

TEST_CASE_METHOD(Land, "the layers of a map become its children in order") {
    write("layers.tmj",
          level(floor_cells,
                R"(, {"type": "group", "id": 1, "name": "far", "opacity": 0.5, "offsetx": 16,
                   "layers": [{"type": "tilelayer", "id": 2, "name": "hills", "width": 4,
                   "height": 3, "opacity": 0.5, "offsety": 32, "parallaxx": 0.5,
                   "data": [0,0,0,0,0,0,0,0,0,0,0,4],
                   "properties": [{"name": "z", "type": "float", "value": -3},
                                  {"name": "weather", "type": "string", "value": "fog"}]}]},
                   {"type": "imagelayer", "id": 3, "name": "sky", "image": "hero.tga",
                    "repeatx": true, "offsetx": 8, "visible": false})"));
    const Handle top = map("layers.tmj");
    std::string names;
    for (const Handle child : tree.children(top)) names += tree.name(child) + " ";
    CHECK(names == "ground hills sky ");
    CHECK(tree.get(top, "music") == Value("cave"));
    const Handle hills = find(top, "hills");
    CHECK(tree.get(hills, "opacity") == Value(0.25));
    CHECK(tree.get(hills, "offset") == Value(Vec2(1, -2)));
    CHECK(tree.get(hills, "parallax") == Value(Vec2(0.5, 1)));
    CHECK(tree.get(hills, "z") == Value(-3.0));
    CHECK(tree.get(hills, "weather") == Value("fog"));
    const Handle sky = find(top, "sky");
    CHECK(tree.get(sky, "visible") == Value(false));
    CHECK(tree.get(sky, "repeat_x") == Value(0.5));
    const Handle image = find(sky, "image");
    CHECK(tree.get(image, "position") == Value(Vec2(0.5, 3)));
    CHECK(tree.get(image, "image") == Value("hero.tga"));
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Land, "a map without a file has empty cells and the tiles of an image") {
    const Handle top = tree.create(tree.class_named("Tilemap"));
    tree.set(top, "tileset", Value("tiles.tga"));
    tree.set(top, "cells", Value(Vec2(6, 3)));
    tree.set(top, "pixels_per_unit", Value(16.0));
    tree.move(top, tree.root(), "map");
    CHECK(tree.get(top, "columns") == Value(6));
    CHECK(tree.get(top, "size") == Value(Vec2(6, 3)));
    CHECK(tile(top, 5, 2) == 0);
    call(top, "set_tile", {Value(5), Value(2), Value(4)});
    call(top, "set_tile", {Value(0), Value(0), Value(1), Value("tiles"), Value("x")});
    CHECK(tile(top, 5, 2) == 4);
    CHECK_THROWS_WITH(call(top, "set_tile", {Value(0), Value(0), Value(5)}), contains("1 to 4"));
    CHECK_THROWS_WITH(call(top, "set_tile", {Value(6), Value(0), Value(1)}), contains("0 to 5"));
    CHECK(draw().size() == 2);
    // It grows, and a saved copy has the same cells.
    tree.set(top, "cells", Value(Vec2(8, 4)));
    step(1);
    CHECK(tree.get(top, "rows") == Value(4));
    CHECK(tile(top, 5, 2) == 4);
    call(top, "set_tile", {Value(7), Value(3), Value(2)});
    const Handle copy = load_scene_text(tree, scene_text(tree, top), "level.json", tree.root());
    CHECK(tile(copy, 7, 3) == 2);
    CHECK(tile(copy, 5, 2) == 4);
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Land, "many cells that are changed at once are as cells that are changed singly") {
    const auto make = [&](const char* name) {
        const Handle top = tree.create(tree.class_named("Tilemap"));
        tree.set(top, "tileset", Value("tiles.tga"));
        tree.set(top, "cells", Value(Vec2(6, 5)));
        tree.move(top, tree.root(), name);
        call(top, "set_tile", {Value(5), Value(4), Value(4)});
        return top;
    };
    const Handle singly = make("singly"), at_once = make("at_once");
    const auto changes = [&](Handle top) { return tree.get(find(top, "tiles"), "changes"); };
    std::mt19937 random(7);
    const auto below = [&](int n) { return static_cast<int>(random() % unsigned(n)); };
    for (int round = 0; round < 300; ++round) {
        const int x = below(6), y = below(5);
        List rows;
        for (int row = y; row < 1 + y + below(5 - y); ++row) {
            List tiles;
            const int end = x + below(7 - x);
            for (int column = x; column < end; ++column) {
                const int tile = below(3) == 0 ? below(6) - 1 : 0;
                tiles.push_back(Value(tile));
                if (tile >= 0) call(singly, "set_tile", {Value(column), Value(row), Value(tile)});
            }
            rows.push_back(Value(tiles));
        }
        call(at_once, "set_tiles", {Value(x), Value(y), Value(rows)});
        CHECK(changes(at_once) == changes(singly));
        if (below(20) > 0) continue;
        // A script writes the list in another form.
        const List other{Value("3: 2=1"), Value("0: 4=2 1=3")};
        for (const Handle top : {singly, at_once})
            tree.set(find(top, "tiles"), "changes", Value(other));
    }
    const Value before = changes(at_once);
    const auto set = [&](int x, int y, List rows) {
        call(at_once, "set_tiles", {Value(x), Value(y), Value(std::move(rows))});
    };
    const Value one(List{Value(1), Value(1)});
    CHECK_THROWS_WITH(set(0, 0, {one, Value(List{Value(1), Value(9)})}),
                      contains("tile 9: the map has"));
    CHECK_THROWS_WITH(set(0, 0, {Value(List{Value("wall")})}),
                      contains("row 1, element 1: expected the number of a tile, got \"wall\""));
    CHECK_THROWS_WITH(set(5, 0, {one}), contains("cell (6, 0) is outside of the layer \"tiles\""));
    CHECK_THROWS_WITH(set(0, 4, {one, one}), contains("cell (1, 5) is outside"));
    CHECK_THROWS_WITH(set(-1, 0, {one}), contains("cell (-1, 0) is outside"));
    CHECK_THROWS_WITH(set(0, 0, {Value(1)}), contains("list"));
    CHECK(changes(at_once) == before);
}

TEST_CASE_METHOD(Land, "bodies meet the solid tiles of a map without a file") {
    define_bodies();
    const auto make = [&](const char* name, const char* tiles) {
        const Handle top = tree.create(tree.class_named("Tilemap"));
        tree.set(top, "tileset", Value(tiles));
        tree.set(top, "solid_tiles", Value(List{Value(1), Value(3)}));
        tree.set(top, "cells", Value(Vec2(4, 3)));
        tree.move(top, tree.root(), name);
        for (int x = 0; x < 4; ++x) call(top, "set_tile", {Value(x), Value(2), Value(1)});
        step(1);
        return top;
    };
    CHECK(chains(make("of_image", "tiles.tga")).size() == 1);
    CHECK(chains(make("of_file", "tiles.tsj")).size() == 1);
    tree.set(find(tree.root(), "of_image"), "solid_tiles", Value(List{}));
    step(1);
    CHECK(chains(find(tree.root(), "of_image")).empty());
    CHECK(problems.empty());
    CHECK_THROWS_WITH(make("none", "nothing.png"), contains("tileset could not be read"));
    CHECK_FALSE(problems.empty());
}

TEST_CASE_METHOD(Land, "cells are read and written") {
    const Handle top = map();
    CHECK(tree.get(top, "columns") == Value(4));
    CHECK(tree.get(top, "rows") == Value(3));
    CHECK(tree.get(top, "size") == Value(Vec2(4, 3)));
    CHECK(tile(top, 0, 2) == 1);
    CHECK(tile(top, 0, 1) == 0);
    CHECK(tile(top, -1, 2) == 0);
    CHECK(tile(top, 0, 99) == 0);
    call(top, "set_tile", {Value(1), Value(2), Value(0)});
    call(top, "set_tile", {Value(3), Value(0), Value(2), Value("ground"), Value("xd")});
    CHECK(tile(top, 1, 2) == 0);
    CHECK(tile(top, 3, 0) == 2);
    CHECK(call(top, "tile_flips", {Value(3), Value(0)}) == Value("xd"));
    const Handle ground = find(top, "ground");
    CHECK(tree.get(ground, "changes") == Value(List{"0: 3=2xd", "2: 1=0"}));
    call(top, "set_tile", {Value(1), Value(2), Value(1)});
    CHECK(tree.get(ground, "changes") == Value(List{"0: 3=2xd"}));
    tree.reset(ground, tree.property(ground, "changes"));
    CHECK(tile(top, 3, 0) == 0);
}

TEST_CASE_METHOD(Land, "changes in any form are understood") {
    const Handle top = map();
    const Handle ground = find(top, "ground");
    tree.set(ground, "changes",
             Value(List{"2: 1=0 99=1", "nonsense", "", "0:", "0: 1=x", "0: 2=4 3=", "2: 0=3",
                        "77: 1=1", "1: 1=-1"}));
    CHECK(tile(top, 1, 2) == 0);
    CHECK(tile(top, 0, 2) == 3);
    CHECK(tile(top, 2, 0) == 4);
    CHECK(tile(top, 1, 0) == 0);
    call(top, "set_tile", {Value(0), Value(0), Value(1)});
    CHECK(tree.get(ground, "changes") == Value(List{"0: 0=1 2=4", "2: 0=3 1=0"}));
    CHECK(tile(top, 1, 2) == 0);
}

TEST_CASE_METHOD(Land, "points of the world and cells of a map are converted both ways") {
    const Handle top = map("level.tmj", 8);
    tree.set(top, "corner", Value(Vec2(10, 100)));
    CHECK(call(top, "cell_at", {Value(Vec2(10.1, 100.1))}) == Value(Vec2(0, 2)));
    CHECK(call(top, "cell_at", {Value(Vec2(9.9, 106.1))}) == Value(Vec2(-1, -1)));
    CHECK(call(top, "cell_center", {Value(0), Value(2)}) == Value(Vec2(11, 101)));
    CHECK(call(top, "cell_center", {Value(3), Value(0)}) == Value(Vec2(17, 105)));
}

TEST_CASE_METHOD(Land, "the properties of a tile can be read") {
    const Handle top = map();
    CHECK(call(top, "tile_property", {Value(1), Value("gold")}) == Value(5));
    CHECK(call(top, "tile_property", {Value(1), Value("silver")}).is_nil());
    CHECK(call(top, "tile_property", {Value(4), Value("gold")}).is_nil());
    CHECK(call(top, "tile_property", {Value(2), Value("class")}) == Value("Slope"));
}

TEST_CASE_METHOD(Land, "wrong calls on a map name the allowed values") {
    const Handle top = map();
    CHECK_THROWS_WITH(call(top, "set_tile", {Value(4), Value(0), Value(1)}),
                      contains("cell (4, 0) is outside") && contains("x goes from 0 to 3"));
    CHECK_THROWS_WITH(call(top, "set_tile", {Value(0), Value(0), Value(5)}),
                      contains("tiles 1 to 4"));
    CHECK_THROWS_WITH(call(top, "set_tile", {Value(0), Value(0), Value(-1)}),
                      contains("tiles 1 to 4"));
    CHECK_THROWS_WITH(
        call(top, "set_tile", {Value(0), Value(0), Value(1), Value("ground"), Value("q")}),
        contains("\"x\", \"y\", \"d\""));
    CHECK_THROWS_WITH(call(top, "tile", {Value(0), Value(0), Value("grund")}),
                      contains("did you mean \"ground\""));
    tree.set(top, "map", Value(""));
    CHECK_THROWS_WITH(call(top, "tile", {Value(0), Value(0)}), contains("no map file"));
}

TEST_CASE_METHOD(Land, "a missing file is reported once with the nearest name") {
    const Handle top = map("levle.tmj");
    step(3);
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems.front(), contains("level.tmj"));
    CHECK(tree.children(top).empty());
    tree.set(top, "map", Value("level.tmj"));
    step(1);
    CHECK(tile(top, 0, 2) == 1);
}

TEST_CASE_METHOD(Land, "an unsuitable map is refused with the reason") {
    std::string hexagons = level(floor_cells);
    hexagons.replace(hexagons.find("orthogonal"), 10, "hexagonal");
    write("hexagons.tmj", hexagons);
    map("hexagons.tmj");
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems.front(), contains("is not an orthogonal map"));
}

TEST_CASE_METHOD(Land, "another file takes the place of the first") {
    write("other.tmj", level("0,0,0,0, 0,0,0,0, 0,0,0,2", R"(, {"type": "objectgroup", "id": 9,
        "name": "things", "objects": [{"id": 1, "x": 0, "y": 0, "point": true}]})"));
    const Handle top = map();
    const Handle own = make("Sprite", {}, top);
    call(top, "set_tile", {Value(0), Value(0), Value(1)});
    tree.set(top, "map", Value("other.tmj"));
    step(1);
    CHECK(tree.alive(own));
    CHECK(tile(top, 0, 2) == 0);
    CHECK(tile(top, 3, 2) == 2);
    CHECK(tile(top, 0, 0) == 0);
    CHECK(tree.child(top, "things"));
    tree.set(top, "map", Value(""));
    step(1);
    CHECK(tree.children(top).size() == 1);
}

TEST_CASE_METHOD(Land, "reading the file again keeps the changed cells") {
    const Handle top = map();
    call(top, "set_tile", {Value(0), Value(0), Value(3)});
    write("level.tmj", level("0,0,0,0, 4,4,4,4, 1,1,1,1"));
    tree.call(top, "reload", {});
    CHECK(tile(top, 0, 1) == 4);
    CHECK(tile(top, 0, 0) == 3);
    write("level.tmj", "{");
    tree.call(top, "reload", {});
    CHECK(problems.size() == 1);
    CHECK(tile(top, 0, 1) == 4);
}

TEST_CASE_METHOD(Land, "a file of a map that changes is read again") {
    const Handle top = map();
    call(top, "set_tile", {Value(0), Value(0), Value(3)});
    write("level.tmj", level("0,0,0,0, 4,4,4,4, 1,1,1,1"));
    visuals.renew("other.tmj");
    CHECK(tile(top, 0, 1) != 4);
    visuals.renew("level.tmj");
    CHECK(tile(top, 0, 1) == 4);
    CHECK(tile(top, 0, 0) == 3);
    write("level.tmj", level("0,0,0,0, 2,4,4,4, 1,1,1,1"));
    visuals.renew("any.tsj");  // a tileset may belong to each map
    CHECK(tile(top, 0, 1) == 2);
}

// --- State

TEST_CASE_METHOD(Land, "cells are in snapshots") {
    const Handle top = map();
    call(top, "set_tile", {Value(0), Value(0), Value(1)});
    const Snapshot before = Snapshot::from_bytes(tree.snapshot().to_bytes());
    call(top, "set_tile", {Value(0), Value(0), Value(0)});
    call(top, "set_tile", {Value(1), Value(1), Value(2)});
    step(2);
    tree.restore(before);
    CHECK(tile(top, 0, 0) == 1);
    CHECK(tile(top, 1, 1) == 0);
    CHECK(tree.children(top).size() == 1);
    tree.destroy(top);
    tree.restore(before);
    CHECK(tile(top, 0, 0) == 1);
    step(2);
    CHECK(tree.children(top).size() == 1);
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Land, "a change of cells can be undone") {
    const Handle top = map();
    {
        const Tree::CauseScope person(tree, Writer::console);
        call(top, "set_tile", {Value(0), Value(0), Value(1)});
        call(top, "set_tile", {Value(1), Value(0), Value(1)});
    }
    tree.undo();
    CHECK(tile(top, 0, 0) == 1);
    CHECK(tile(top, 1, 0) == 0);
    tree.undo();
    CHECK(tile(top, 0, 0) == 0);
    tree.redo();
    CHECK(tile(top, 0, 0) == 1);
}

TEST_CASE_METHOD(Land, "making a map can be undone") {
    {
        const Tree::CauseScope person(tree, Writer::console);
        tree.begin_edit("map");
        map();
        tree.end_edit();
    }
    CHECK(tree.size() == 3);
    tree.undo();
    CHECK(tree.size() == 1);
    tree.redo();
    step(2);
    CHECK(tree.size() == 3);
    CHECK(tile(find(tree.root(), "map"), 0, 2) == 1);
}

TEST_CASE_METHOD(Land, "a scene file with a map has every instance once") {
    define_bodies();
    write("level.tmj", level(floor_cells, R"(, {"type": "objectgroup", "id": 9, "name": "things",
        "objects": [{"id": 1, "name": "door", "x": 0, "y": 0, "point": true}]})"));
    const Handle top = map();
    step(1);
    call(top, "set_tile", {Value(0), Value(2), Value(0)});
    step(1);
    const std::size_t size = tree.size();
    const std::string text = scene_text(tree, top);
    tree.destroy(top);
    const Handle again = load_scene_text(tree, text, "level.json", tree.root());
    step(2);
    CHECK(tree.size() == size);
    CHECK(tile(again, 0, 2) == 0);
    CHECK(scene_text(tree, again).size() == text.size());
    CHECK(find(find(again, "things"), "door"));
}

// --- Pictures

TEST_CASE_METHOD(Land, "only cells in view are drawn") {
    std::string cells;
    for (int i = 0; i < 200 * 200; ++i) cells += i == 0 ? "1" : ",1";
    std::string large = level(cells);
    for (const char* key : {"\"width\": 4", "\"height\": 3"})
        for (std::size_t at = 0; (at = large.find(key, at)) != std::string::npos; ++at)
            large.replace(at, std::string(key).size(),
                          std::string(key).substr(0, std::string(key).find(':')) + ": 200");
    write("large.tmj", large);
    map("large.tmj");
    Sheet sheet;
    sheet.view = {{100, 100}, {95, 98}, {105, 102}, {800, 320}};
    CHECK(draw(sheet).size() >= 10 * 4);
    CHECK(draw(sheet).size() <= 15 * 8);
    sheet.view = {{-100, 100}, {-105, 98}, {-95, 102}, {800, 320}};
    CHECK(draw(sheet).empty());
}

TEST_CASE_METHOD(Land, "tiles are drawn where they are") {
    write("level.tmj", level("0,0,0,0, 0,0,0,0, 0,2,0,0"));
    const Handle top = map();
    tree.set(top, "corner", Value(Vec2(-1, -2)));
    auto drawn = draw();
    REQUIRE(drawn.size() == 1);
    CHECK(near(drawn[0].lower_left, {0, -2}));
    CHECK(near(drawn[0].lower_right, {1, -2}));
    CHECK(near(drawn[0].upper_left, {0, -1}));
    CHECK(drawn[0].area.left == 16);
    CHECK_FALSE(drawn[0].smooth);
    const Handle ground = find(top, "ground");
    tree.set(ground, "offset", Value(Vec2(0.5, 1)));
    tree.set(ground, "opacity", Value(0.5));
    tree.set(ground, "tint", Value(Color{1, 0, 0, 1}));
    tree.set(ground, "blend", Value("add"));
    drawn = draw();
    CHECK(near(drawn[0].lower_left, {0.5, -1}));
    CHECK(drawn[0].opacity == 0.5f);
    CHECK(drawn[0].color == Color{1, 0, 0, 1});
    CHECK(drawn[0].blend == Blend::add);
    tree.set(ground, "visible", Value(false));
    CHECK(draw().empty());
}

TEST_CASE_METHOD(Land, "pixels of the transparent color of a tileset or an image are not seen") {
    // Two tiles of one pixel: red and green.
    std::string image = tga(2, 1);
    REQUIRE(image.size() >= 26);
    image.replace(18, 8, std::string("\0\0\xff\xff\0\xff\0\xff", 8));
    write("dots.tga", image);
    write("sky.tga", image);
    const auto level_of = [](const std::string& tileset, const std::string& layer) {
        return R"(<map version="1.0" orientation="orthogonal" width="1" height="1" tilewidth="1" tileheight="1">
            <tileset firstgid="1" name="dots" tilewidth="1" tileheight="1"><image source="dots.tga")" +
               tileset + R"(/></tileset><layer name="ground" width="1" height="1">
            <data encoding="csv">2</data></layer><imagelayer name="sky"><image source="sky.tga")" +
               layer + "/></imagelayer></map>";
    };
    const auto opaque = [&](const char* name) {
        const Picture& picture = visuals.media().picture([] { return std::string("test"); }, name);
        return std::pair(picture.rgba().at(3) == 255, picture.rgba().at(7) == 255);
    };
    write("level.tmx", level_of("", R"( trans="#00ff00")"));
    const Handle made = map("level.tmx");
    const auto drawn = draw();
    CHECK(opaque("dots.tga") == std::pair(true, true));
    CHECK(opaque("sky.tga") == std::pair(true, false));
    // The file does not say how large the image is; the second tile is its right half.
    REQUIRE_FALSE(drawn.empty());
    CHECK(drawn.front().area.left == 1);
    CHECK(drawn.front().area.width == 1);
    write("level.tmx", level_of(R"( trans="ff0000")", ""));
    call(made, "reload", {});
    CHECK(opaque("dots.tga") == std::pair(false, true));
    CHECK(opaque("sky.tga") == std::pair(true, true));
}

TEST_CASE_METHOD(Land, "a layer with parallax moves with the view") {
    write("level.tmj", level("0,0,0,0, 0,0,0,0, 2,0,0,0"));
    tree.set(find(map(), "ground"), "parallax", Value(Vec2(0, 1)));
    Sheet sheet;
    sheet.view = {{50, 0}, {40, -5}, {60, 5}, {800, 400}};
    const auto drawn = draw(sheet);
    REQUIRE(drawn.size() == 1);
    CHECK(near(drawn[0].lower_left, {50, 0}));
}

TEST_CASE_METHOD(Land, "flipped tiles are drawn flipped") {
    const Handle top = map();
    for (int x = 0; x < 4; ++x) call(top, "set_tile", {Value(x), Value(2), Value(0)});
    const auto drawn_with = [&](const char* flips) {
        call(top, "set_tile", {Value(0), Value(2), Value(2), Value("ground"), Value(flips)});
        return draw().at(0);
    };
    // Where the lower left, lower right and upper left corner of the picture are.
    const auto corners = [&](const char* flips, Vec2 a, Vec2 b, Vec2 c) {
        INFO(flips);
        const Drawn d = drawn_with(flips);
        CHECK(near(d.lower_left, a));
        CHECK(near(d.lower_right, b));
        CHECK(near(d.upper_left, c));
    };
    corners("", {0, 0}, {1, 0}, {0, 1});
    corners("x", {1, 0}, {0, 0}, {1, 1});
    corners("y", {0, 1}, {1, 1}, {0, 0});
    corners("xy", {1, 1}, {0, 1}, {1, 0});
    // The editor turns a tile a quarter clockwise with d and x.
    corners("xd", {0, 1}, {0, 0}, {1, 1});
    corners("d", {1, 1}, {1, 0}, {0, 1});
}

TEST_CASE_METHOD(Land, "animated tiles move on with the steps") {
    write("level.tmj", level("4,0,0,0, 0,0,0,0, 0,0,0,0"));
    const Handle top = map();
    CHECK(draw().at(0).area.left == 48);
    step(6);
    CHECK(draw().at(0).area.left == 0);
    const Snapshot then = tree.snapshot();
    step(6);
    CHECK(draw().at(0).area.left == 48);
    tree.restore(then);
    CHECK(draw().at(0).area.left == 0);
    tree.set(top, "animation_time", Value(0.25));
    CHECK(draw().at(0).area.left == 48);
}

// --- Objects

TEST_CASE_METHOD(Land, "a name of a layer or an object that cannot be one is reported") {
    write("names.tmj", level(floor_cells, R"(, {"type": "objectgroup", "id": 9, "name": "corner",
        "objects": [{"id": 1, "name": "delete", "x": 0, "y": 0, "point": true},
                    {"id": 2, "name": "coin", "x": 0, "y": 0, "point": true},
                    {"id": 3, "name": "coin", "x": 0, "y": 0, "point": true},
                    {"id": 4, "name": ")" + std::string(2000, 'n') +
                                              R"(", "x": 0, "y": 0, "point": true}]})"));
    const Handle top = map("names.tmj");
    const Handle things = find(top, "corner_2");
    CHECK(tree.child(things, "coin_2"));
    REQUIRE(problems.size() == 2);
    CHECK_THAT(problems[0],
               contains("layer \"corner\": ") &&
                   contains("a child cannot be called \"corner\", which is a property of "
                            "Tilemap; it is called \"corner_2\""));
    CHECK_THAT(problems[1], contains("has 2000 bytes") && contains("; it is called \"object"));
}

}  // namespace tilemap_test
