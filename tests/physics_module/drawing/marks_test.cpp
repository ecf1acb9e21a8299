// Overlays that explain the solver.

#include <set>
#include <tuple>

#include "catch.h"
#include "game.h"
#include "picture.h"

namespace marks_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Overlay;

namespace {

/// A picture with 40 pixels a meter.
struct FinePicture : Picture {
    double scale = 1;
    double pixels_per_unit() const override { return 40; }
    double label_scale() const override { return scale; }
};

struct Marked : Game {
    double scale = 1;  // of texts
    /// The figures that an overlay adds to the picture.
    std::vector<Figure> marks(Overlay which) {
        FinePicture plain, picture;
        picture.scale = scale;
        tree.draw(tree.root(), plain, 1.0);
        picture.overlays = {which};
        tree.draw(tree.root(), picture, 1.0);
        return {picture.figures.begin() + static_cast<std::ptrdiff_t>(plain.figures.size()),
                picture.figures.end()};
    }
    static auto color_of(const Figure& figure) {
        const auto& fill = figure.paint.fill;
        return std::tuple(fill.r, fill.g, fill.b);
    }
};

}  // namespace

TEST_CASE_METHOD(Marked, "each island has a color of its own") {
    floor();
    const Handle a = body("Box", {0, 0.5}), b = body("Box", {0, 1.5}), c = body("Box", {9, 0.5});
    step(10);
    const auto marks = this->marks(Overlay::islands);
    REQUIRE(marks.size() == 3);
    CHECK(color_of(marks[0]) == color_of(marks[1]));
    CHECK(color_of(marks[0]) != color_of(marks[2]));
    make("WeldJoint", world(), {{"body_a", b}, {"body_b", c}});
    step();
    std::set<std::tuple<float, float, float>> colors;
    for (const Figure& mark : this->marks(Overlay::islands)) colors.insert(color_of(mark));
    CHECK(colors.size() == 1);
    CHECK(tree.alive(a));
}

TEST_CASE_METHOD(Marked, "impulses are drawn to one scale") {
    floor();
    const Handle light = body("Box", {-3, 0.5}), heavy = body("Box", {3, 0.5});
    set(heavy, "mass", 4);
    set(light, "mass", 1);
    step(20);
    double by_side[2] = {0, 0};
    std::size_t texts = 0;
    for (const Figure& mark : marks(Overlay::impulses)) {
        texts += mark.kind == "text";
        // The shafts begin at the floor; heads and the scale do not.
        if (mark.kind != "line" || std::abs(mark.points[0].y) > 0.05 || mark.points[1].y < 0.05)
            continue;
        by_side[mark.points[0].x > 0] += (mark.points[1] - mark.points[0]).length();
    }
    CHECK(texts == 1);
    CHECK(by_side[0] > 0);
    CHECK(by_side[1] / by_side[0] == Approx(4).epsilon(0.1));
}

TEST_CASE_METHOD(Marked, "texts of overlays are as large as the texts of the console") {
    floor();
    body("Box", {0, 0.5});
    step(20);
    const Overlay which = GENERATE(Overlay::names, Overlay::impulses);
    const auto heights = [&] {
        std::vector<double> all;
        for (const Figure& mark : marks(which))
            if (mark.kind == "text") all.push_back(mark.size);
        return all;
    };
    const std::vector<double> usual = heights();
    REQUIRE_FALSE(usual.empty());
    scale = 2;
    const std::vector<double> large = heights();
    REQUIRE(large.size() == usual.size());
    for (std::size_t i = 0; i < usual.size(); ++i) CHECK(large[i] == Approx(2 * usual[i]));
}

TEST_CASE_METHOD(Marked, "outlines of shapes are also those of hidden ones") {
    const Handle ball = make("Body", world(), {{"position", Vec2(3, 1)}});
    const Handle hidden = make("Circle", ball, {{"radius", 0.5}, {"visible", false}});
    make("Circle", ball, {{"radius", 0.25}, {"sensor", true}});
    const auto drawn_before = [&] {
        FinePicture picture;
        picture.overlays = {Overlay::shapes};
        tree.draw(hidden, picture, 1.0);
        return picture.figures;
    }();
    // The picture of the game stays as it is below the outlines.
    REQUIRE(drawn_before.size() == 1);
    CHECK(drawn_before[0].paint.fill.a == 0);
    CHECK(drawn_before[0].paint.border.a == 0);
    std::vector<Figure> outlines;
    for (const Figure& mark : marks(Overlay::shapes))
        if (mark.paint.fill.a == 0 && mark.paint.border.a > 0) outlines.push_back(mark);
    REQUIRE(outlines.size() == 2);
    CHECK(outlines[0].kind == "circle");
    CHECK(outlines[0].paint.border.r != outlines[1].paint.border.r);
    set(hidden, "visible", true);
    CHECK(marks(Overlay::shapes).size() == 2);
    // A chain has no inside: its lines are seen.
    make("Chain", make("Body", world(), {{"type", "static"}}),
         {{"points", property::List{Vec2(0, 0), Vec2(3, 0), Vec2(5, 1)}}});
    const auto lines = marks(Overlay::shapes);
    REQUIRE(lines.size() == 4);
    for (std::size_t i = 0; i < 2; ++i) {
        CHECK(lines[i + 2].kind == "line");
        CHECK(lines[i + 2].paint.fill.a == 1);
    }
}

TEST_CASE_METHOD(Marked, "the limits of a joint are drawn and those it does not have are not") {
    const Handle arm = make("Body", world(), {{"position", Vec2(1, 0)}});
    make("Box", arm);
    const Handle hinge =
        make("RevoluteJoint", world(),
             {{"body_b", arm}, {"anchor_a", Vec2(0, 0)}, {"anchor_b", Vec2(-1, 0)}});
    step();
    CHECK(marks(Overlay::limits).empty());
    set(hinge, "lower_angle", -0.5);
    set(hinge, "upper_angle", 1.0);
    const auto arc = marks(Overlay::limits);
    CHECK(arc.size() > 10);
    // Each point of the arc has the same distance from the anchor.
    for (const Figure& mark : arc) {
        REQUIRE(mark.kind == "line");
        CHECK(mark.points[1].length() == Approx(arc.front().points[1].length()).margin(1e-4));
    }
    tree.destroy(hinge);
    const Handle rail = make("PrismaticJoint", world(),
                             {{"body_b", arm}, {"anchor_a", Vec2(1, 0)}, {"axis", Vec2(1, 0)}});
    set(rail, "lower_translation", -2);
    set(rail, "upper_translation", 3);
    step();
    const auto way = marks(Overlay::limits);
    REQUIRE(way.size() == 4);
    CHECK((way[0].points[1] - way[0].points[0]).length() == Approx(5).epsilon(1e-3));
}

}  // namespace marks_test
