// Maps: the outlines of solid tiles as chains of a static body.

#include <catch.h>

#include <cstring>

#include "levels.h"

namespace tilemap_collisions_test {

using namespace fettle::visuals::test;

TEST_CASE_METHOD(Land, "solid tiles have one outline") {
    define_bodies();
    const Handle top = map();
    tree.set(top, "corner", Value(Vec2(5, 6)));
    tree.barrier();
    REQUIRE(chains(top).size() == 1);
    const Handle chain = chains(top)[0];
    CHECK(points(chain).size() == 4);
    CHECK(tree.get(chain, "closed") == Value(true));
    CHECK(tree.get(chain, "friction").as_double() == Approx(0.6));
    // Bodies stay on its left side: around an island, it runs clockwise.
    double area = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 a = points(chain)[i].vec2(), b = points(chain)[(i + 1) % 4].vec2();
        area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    CHECK(area == Approx(-4));
    const Handle body = find(top, "collisions");
    CHECK(tree.get(body, "type") == Value("static"));
    CHECK(tree.get(body, "position") == Value(Vec2(5, 9)));
}

TEST_CASE_METHOD(Land, "collisions follow the cells at the next barrier") {
    define_bodies();
    write("level.tmj", level("0,0,0,0, 0,0,0,0, 1,0,1,1"));
    const Handle top = map();
    tree.barrier();
    REQUIRE(chains(top).size() == 2);
    const auto all = chains(top);
    const Handle kept = points(all[0])[0].vec2().x <= 1 ? all[0] : all[1];
    call(top, "set_tile", {Value(3), Value(2), Value(0)});
    tree.barrier(false);
    REQUIRE(chains(top).size() == 2);
    CHECK(tree.alive(kept));
    const Handle ground = find(top, "ground");
    tree.set(ground, "solid", Value(false));
    step(1);
    CHECK(chains(top).empty());
    tree.set(ground, "solid", Value(true));
    tree.set(ground, "friction", Value(0.25));
    step(1);
    REQUIRE(chains(top).size() == 2);
    CHECK(tree.get(chains(top)[0], "friction") == Value(0.25));
}

TEST_CASE_METHOD(Land, "a map with too many separate tiles is not solid and reports it") {
    define_bodies();
    std::string cells;
    for (int y = 0; y < 320; ++y)
        for (int x = 0; x < 320; ++x) cells += (y + x) % 2 == 0 ? "1," : "0,";
    cells.pop_back();
    std::string file = level(cells);
    for (const char* old : {"\"width\": 4", "\"width\": 4"})
        file.replace(file.find(old), std::strlen(old), "\"width\": 320");
    for (const char* old : {"\"height\": 3,", "\"height\": 3,"})
        file.replace(file.find(old), std::strlen(old), "\"height\": 320,");
    write("level.tmj", file);
    const Handle top = map();
    tree.barrier();
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].find("collisions: the solid tiles have 51200 separate outlines, and a map "
                           "may have 50000") != std::string::npos);
    CHECK_FALSE(tree.child(top, "collisions"));
}

TEST_CASE_METHOD(Land, "a slope joins the ground beside it") {
    define_bodies();
    write("level.tmj", level("0,0,0,0, 0,2,1,1, 1,1,1,1"));
    const Handle top = map();
    tree.barrier();
    REQUIRE(chains(top).size() == 1);
    // Around the ground, up the slope: no point where the tiles meet.
    CHECK(points(chains(top)[0]).size() == 6);
}

TEST_CASE_METHOD(Land, "collision lines of neighboring tiles become one line") {
    define_bodies();
    write("level.tmj", level("0,0,0,0, 3,3,3,0, 0,0,0,0"));
    const Handle top = map();
    tree.barrier();
    REQUIRE(chains(top).size() == 1);
    const Handle chain = chains(top)[0];
    CHECK(tree.get(chain, "closed") == Value(false));
    CHECK(points(chain) == List{Vec2(0, -1), Vec2(3, -1)});
    call(top, "set_tile", {Value(1), Value(1), Value(3), Value("ground"), Value("x")});
    tree.barrier();
    // Mirrored, it is still solid from above.
    REQUIRE(chains(top).size() == 1);
    CHECK(points(chains(top)[0]) == List{Vec2(0, -1), Vec2(3, -1)});
}

TEST_CASE_METHOD(Land, "a map with a tile outline too far away is not solid and reports it") {
    define_bodies();
    std::string far = tileset;
    const std::string corner = R"({"x": 16, "y": 0}]})";
    far.replace(far.find(corner), corner.size(), R"({"x": 1e300, "y": 0}]})");
    write("tiles.tsj", far);
    write("level.tmj", level("0,0,0,0, 0,0,0,0, 2,1,0,0"));
    const Handle top = map();
    tree.barrier();
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems[0], contains("map: collisions: an outline has a vertex at vec(1e+300"));
    CHECK_THAT(problems[0], contains("; nothing of it is solid"));
    CHECK(chains(top).empty());
}

TEST_CASE_METHOD(Land, "a restored map has the collisions of its cells") {
    define_bodies();
    const Handle top = map();
    tree.barrier();
    const Snapshot before = tree.snapshot();
    call(top, "set_tile", {Value(1), Value(2), Value(0)});
    const Snapshot between = tree.snapshot();  // before the barrier
    step(1);
    CHECK(chains(top).size() == 2);
    tree.restore(before);
    CHECK(chains(top).size() == 1);
    step(2);
    CHECK(chains(top).size() == 1);
    tree.restore(between);
    step(1);
    CHECK(chains(top).size() == 2);
}

TEST_CASE_METHOD(Land, "going back in time does not undo what a game did to the outlines") {
    define_bodies();
    write("level.tmj", level("0,0,0,0, 0,0,0,0, 1,0,1,1"));
    const Handle top = map();
    tree.barrier();
    REQUIRE(chains(top).size() == 2);
    tree.destroy(chains(top)[0]);
    step(1);
    const Snapshot without = tree.snapshot();
    step(1);
    tree.restore(without);
    step(1);
    CHECK(chains(top).size() == 1);
    // Other cells are followed again, and so is a file that is read again.
    call(top, "set_tile", {Value(1), Value(0), Value(1)});
    tree.barrier();
    CHECK(chains(top).size() == 3);
    call(top, "reload", {});
    tree.barrier();
    CHECK(chains(top).size() == 3);
    for (const int x : {0, 1, 2, 3})
        for (const int y : {0, 2}) call(top, "set_tile", {Value(x), Value(y), Value(0)});
    tree.barrier();
    CHECK(chains(top).empty());
    tree.destroy(find(top, "collisions"));
    call(top, "set_tile", {Value(1), Value(0), Value(1)});
    tree.barrier();
    CHECK(chains(top).size() == 1);
}

TEST_CASE_METHOD(Land, "collisions follow layers that come and go") {
    define_bodies();
    const Handle top = map();
    tree.barrier();
    REQUIRE(chains(top).size() == 1);
    const Handle ground = find(top, "ground");
    tree.move(ground, tree.root(), "ground");
    step(1);
    CHECK(chains(top).empty());
    tree.move(ground, top, "ground");
    step(1);
    CHECK(chains(top).size() == 1);
    tree.destroy(ground);
    step(1);
    CHECK(chains(top).empty());
    tree.destroy(top);
    step(1);
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Land, "a map without one of its layers gets a body") {
    define_bodies();
    write("level.tmj", level("0,0,0,0, 0,0,0,0, 0,0,0,0",
                             R"(, {"type": "tilelayer", "id": 8, "name": "more", "width": 4,
                                  "height": 3, "data": [0,0,0,0, 0,0,0,0, 0,0,0,0]})"));
    const Handle top = map();
    tree.barrier();
    tree.destroy(find(top, "more"));
    call(top, "set_tile", {Value(1), Value(0), Value(1)});
    tree.barrier();
    CHECK(chains(top).size() == 1);
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Land, "a map that is too large for its body leaves nothing half made") {
    define_bodies();
    const Handle top = map("level.tmj", 1e-3);
    step(2);
    REQUIRE(problems.size() == 1);
    CHECK_THAT(problems.front(), contains("collisions"));
    CHECK(chains(top).empty());
    CHECK(tree.size() == 4);  // the game, the map, its layer, its body
    tree.set(top, "pixels_per_unit", Value(16.0));
    step(1);
    CHECK(chains(top).size() == 1);
}

}  // namespace tilemap_collisions_test
