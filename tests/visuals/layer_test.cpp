// Layers and lines.

#include <catch.h>

#include "gallery.h"

namespace layer_test {

using namespace fettle::visuals::test;

namespace {

struct Layered : Gallery {
    Handle layer = make("Layer");
    Handle sprite = make("Sprite", {{"image", "hero.tga"}, {"size", Value(Vec2(2, 2))}}, layer);
    Sheet moved;

    Layered() {
        moved.view.center = {100, 0}, moved.view.lower = {90, -5}, moved.view.upper = {110, 5};
    }
};

}  // namespace

TEST_CASE_METHOD(Layered, "a layer scrolls at its own rate") {
    CHECK(near(draw(moved)[0].lower_left, {-1, -1}));
    tree.set(layer, "parallax", Value(Vec2(0.25, 1)));
    CHECK(near(draw(moved)[0].lower_left, {74, -1}));
    tree.set(layer, "parallax", Value(Vec2(0, 0)));
    CHECK(near(draw(moved)[0].lower_left, {99, -1}));
}

TEST_CASE_METHOD(Layered, "opacity and visibility hold for all below a layer") {
    tree.set(layer, "opacity", Value(0.5));
    CHECK(draw()[0].opacity == 0.5f);
    make("Sprite", {{"image", "hero.tga"}});
    CHECK(draw()[1].opacity == 1);
    const Handle inner = make("Layer", {{"opacity", 0.5}, {"blend", "multiply"}}, layer);
    tree.move(sprite, inner);
    CHECK(draw()[0].opacity == 0.25f);
    CHECK(draw()[0].blend == Blend::multiply);
    tree.set(layer, "visible", Value(false));
    CHECK(draw().size() == 1);
}

TEST_CASE_METHOD(Layered, "a layer on the screen counts pixels from its anchor") {
    tree.set(layer, "space", Value("screen"));
    tree.set(sprite, "size", Value());
    tree.set(sprite, "position", Value(Vec2(10, 20)));
    tree.set(sprite, "origin", Value(Vec2(0, 1)));
    auto drawn = draw(moved);
    CHECK(drawn[0].on_screen);
    CHECK(near(drawn[0].upper_left, {10, 20}));
    CHECK(near(drawn[0].lower_left, {10, 24}));
    tree.set(layer, "anchor", Value("bottom_right"));
    tree.set(sprite, "position", Value(Vec2(-8, -4)));
    drawn = draw(moved);
    CHECK(near(drawn[0].upper_left, {792, 396}));
    // Angles are counter-clockwise as seen, though y points down.
    tree.set(sprite, "angle", Value(std::acos(0.0)));
    drawn = draw(moved);
    CHECK(near(drawn[0].upper_left, {792, 396}));
    CHECK(near(drawn[0].lower_left, {796, 396}));
}

TEST_CASE_METHOD(Layered, "the scale of a layer enlarges what is below it from its anchor") {
    tree.set(layer, "scale", Value(3.0));
    tree.set(sprite, "position", Value(Vec2(2, 0)));
    CHECK(near(draw()[0].lower_left, {3, -3}));
    tree.set(layer, "parallax", Value(Vec2(0, 0)));
    CHECK(near(draw(moved)[0].lower_left, {103, -3}));
    tree.set(layer, "space", Value("screen"));
    tree.set(layer, "anchor", Value("bottom_right"));
    tree.set(sprite, "position", Value(Vec2(-8, -4)));
    CHECK(near(draw(moved)[0].upper_left, {800 - 3 * 9, 400 - 3 * 5}));
    // Copies are as far from each other as their enlarged content needs.
    tree.set(layer, "space", Value("world"));
    tree.set(layer, "parallax", Value(Vec2(1, 1)));
    tree.set(layer, "repeat_x", Value(4.0));
    tree.set(sprite, "position", Value(Vec2(0, 0)));
    std::set<long> at;
    for (const Drawn& d : draw(moved)) at.insert(std::lround(d.lower_left.x + 3));
    for (long x = 96; x <= 108; x += 12) CHECK(at.contains(x));
    CHECK_FALSE(at.contains(100));
}

TEST_CASE_METHOD(Layered, "a repeated layer covers what is seen") {
    tree.set(layer, "repeat_x", Value(4.0));
    std::set<long> at;
    for (const Drawn& d : draw(moved)) {
        CHECK(d.lower_left.y == -1);
        at.insert(std::lround(d.lower_left.x + 1));
    }
    for (long x = 88; x <= 108; x += 4) CHECK(at.contains(x));
    CHECK(at.size() < 12);
    tree.set(layer, "repeat_y", Value(1e-9));  // limited
    CHECK(draw(moved).size() <= 100 * 12);
}

TEST_CASE_METHOD(Gallery, "a line goes through its points") {
    const Handle line = make("Line", {{"points", Value(List{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)})},
                                      {"width", 0.5},
                                      {"position", Value(Vec2(5, 0))}});
    auto drawn = draw();
    REQUIRE(drawn.size() == 2);
    CHECK(drawn[0].kind == "polygon");
    CHECK(near(drawn[1].lower_left, {6, 0}));
    CHECK(near(drawn[1].lower_right, {6, 1}));
    CHECK(drawn[0].area.width == 0.25);
    tree.set(line, "closed", Value(true));
    CHECK(near(draw()[2].lower_right, {5, 0}));
    tree.set(line, "width", Value(0.0));
    CHECK(draw()[0].kind == "line");
    CHECK(draw()[0].area.width == 1);
    tree.set(line, "points", Value(List{Vec2(0, 0)}));
    CHECK(draw().empty());
}

TEST_CASE_METHOD(Gallery, "dashes go around corners") {
    const Handle line = make(
        "Line", {{"points", Value(List{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)})}, {"dashed", 0.75}});
    const auto drawn = draw();
    REQUIRE(drawn.size() == 2);
    CHECK(near(drawn[0].lower_right, {0.75, 0}));
    CHECK(near(drawn[1].lower_left, {1, 0.5}));
    CHECK(near(drawn[1].lower_right, {1, 1}));
    tree.set(line, "dashed", Value(1e-12));
    CHECK(draw().size() <= 20'000);
}

}  // namespace layer_test
