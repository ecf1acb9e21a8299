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

TEST_CASE_METHOD(Layered, "a repeated layer covers the visible area") {
    tree.set(layer, "repeat_x", Value(4.0));
    std::set<long> at;
    for (const Drawn& d : draw(moved)) {
        CHECK(d.lower_left.y == -1);
        at.insert(std::lround(d.lower_left.x + 1));
    }
    for (long x = 88; x <= 108; x += 4) CHECK(at.contains(x));
    CHECK(at.size() < 12);
    tree.set(layer, "repeat_y", Value(1e-9));  // limited
    CHECK(draw(moved).size() <= 10'000);
}

TEST_CASE_METHOD(Layered, "a repeated layer covers the visible area from far away") {
    moved.view.lower = {-900, -500}, moved.view.upper = {1100, 500};
    tree.set(layer, "repeat_x", Value(4.0));
    double left = 0, right = 0;
    for (const Drawn& d : draw(moved)) {
        left = std::min(left, d.lower_left.x);
        right = std::max(right, d.lower_right.x);
    }
    CHECK(left <= -900);
    CHECK(right >= 1100);
    // Of too many copies, those in the middle are drawn.
    tree.set(layer, "repeat_x", Value(1e-9));
    const auto drawn = draw(moved);
    CHECK(drawn.size() <= 10'000);
    CHECK(near(drawn[drawn.size() / 2].lower_left, {99, -1}, 0.01));
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
    auto drawn = draw();
    REQUIRE(drawn.size() == 2);
    CHECK(near(drawn[0].lower_right, {0.725, 0}));  // and the half circle at its end
    CHECK(near(drawn[1].lower_left, {1, 0.525}));
    CHECK(near(drawn[1].lower_right, {1, 0.975}));
    tree.set(line, "dashed", Value(0.8));
    tree.set(line, "points", Value(List{Vec2(0, 0), Vec2(0, 0), Vec2(0.5, 0), Vec2(0.5, 1)}));
    drawn = draw();
    REQUIRE(drawn.size() == 2);  // one dash around the corner; then a gap to the end
    CHECK(near(drawn[0].lower_right, {0.5, 0}));
    CHECK(near(drawn[1].lower_right, {0.5, 0.275}));
}

TEST_CASE_METHOD(Gallery, "dashes and gaps are as long as each other however thick the line is") {
    const Handle line = make(
        "Line", {{"points", Value(List{Vec2(0, 0), Vec2(3, 0)})}, {"dashed", 0.5}, {"width", 0.2}});
    const auto spans = [&] {
        std::vector<double> all;
        for (const Drawn& d : draw()) {
            all.push_back(std::min(d.lower_left.x, d.lower_right.x) - d.area.width);
            all.push_back(std::max(d.lower_left.x, d.lower_right.x) + d.area.width);
        }
        return all;
    };
    for (const double width : {0.1, 0.2, 0.5, 1.5}) {
        CAPTURE(width);
        tree.set(line, "width", Value(width));
        const std::vector<double> found = spans();
        REQUIRE(found.size() == 6);
        for (std::size_t i = 0; i < 6; ++i)
            CHECK(std::abs(found[i] - 0.5 * static_cast<double>(i)) < 1e-9);
    }
    CHECK(std::abs(draw()[0].lower_left.y) + 0.25 == 0.75);  // across the line, 1.5 thick
}

TEST_CASE_METHOD(Gallery,
                 "a dash that the end of the line cuts off is left out if it is too short") {
    const Handle line =
        make("Line",
             {{"points", Value(List{Vec2(0, 0), Vec2(1.1, 0)})}, {"dashed", 0.5}, {"width", 0.2}});
    CHECK(draw().size() == 1);
    tree.set(line, "points", Value(List{Vec2(0, 0), Vec2(1.3, 0)}));
    CHECK(draw().size() == 2);
}

TEST_CASE_METHOD(Gallery, "dashes that are too short to be seen become a paler line") {
    const Handle line = make("Line", {{"points", Value(List{Vec2(0, 0), Vec2(1, 0)})},
                                      {"color", Value(Color{1, 1, 1, 0.5f})},
                                      {"dashed", 1e-12}});
    auto drawn = draw();
    REQUIRE(drawn.size() == 1);
    CHECK(near(drawn[0].lower_right, {1, 0}));
    CHECK(drawn[0].color.a == 0.25f);
    tree.set(line, "dashed", Value(0.1));
    tree.set(line, "points", Value(List{Vec2(0, 0), Vec2(1e8, 0)}));  // too many, all seen
    drawn = draw();
    REQUIRE(drawn.size() == 1);
    CHECK(drawn[0].color.a == 0.25f);
}

TEST_CASE_METHOD(Gallery, "of a long line with dashes only those are made that are seen") {
    struct Far : Sheet {
        bool sees(const Vec2& lower, const Vec2& upper) const override {
            return upper.x >= 9e5 && lower.x <= 9e5 + 10;
        }
    };
    make("Line", {{"points", Value(List{Vec2(-1e6, 0), Vec2(1e6, 0)})}, {"dashed", 0.5}});
    Far sheet;
    tree.draw(tree.root(), sheet, 1);
    double left = 1e9, right = -1e9;
    for (const Drawn& d : sheet.all) {
        left = std::min(left, d.lower_left.x);
        right = std::max(right, d.lower_right.x);
    }
    CHECK(left < 9e5 + 1);
    CHECK(right > 9e5 + 9);
    CHECK(sheet.all.size() < 100);
}

}  // namespace layer_test
