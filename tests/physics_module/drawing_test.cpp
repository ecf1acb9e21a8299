// What is drawn.

#include "catch.h"
#include "game.h"
#include "picture.h"

using namespace fettle::physics_module::testing;
using namespace fettle;

namespace {

struct Drawn : Game {
    Picture draw(double alpha = 1.0) {
        Picture picture;
        tree.draw(tree.root(), picture, alpha);
        return picture;
    }
};

}  // namespace

TEST_CASE_METHOD(Drawn, "a circle is drawn with a line to its rim that turns with it") {
    const Handle ball = body("Circle", {2, 3});
    set(ball, "angle", 3.14159265 / 2);
    const Picture picture = draw();
    REQUIRE(picture.figures.size() == 2);
    CHECK(picture.figures[0].kind == "circle");
    CHECK(picture.figures[0].points[0] == Vec2(2, 3));
    CHECK(picture.figures[0].size == 0.5);
    CHECK(picture.figures[1].kind == "line");
    CHECK(picture.figures[1].points[1].isApprox(Vec2(2, 3.5), 1e-5));
    CHECK(picture.figures[1].paint.fill == picture.figures[0].paint.border);
}

TEST_CASE_METHOD(Drawn, "bodies are drawn between their last two poses") {
    const Handle ball = body("Circle", {0, 0});
    set(ball, "gravity_scale", 0);
    set(ball, "velocity", Vec2(60, 0));
    step();
    CHECK(draw(0.0).figures[0].points[0].x() == Approx(0).margin(1e-5));
    CHECK(draw(0.5).figures[0].points[0].x() == Approx(0.5));
    CHECK(draw(1.0).figures[0].points[0].x() == Approx(1));
    set(ball, "position", Vec2(9, 9));
    CHECK(draw(0.5).figures[0].points[0] == Vec2(9, 9));
}

TEST_CASE_METHOD(Drawn, "every shape is drawn as what it is") {
    const Handle crate = make("Body", world(), {{"position", Vec2(10, 0)}});
    make("Box", crate, {{"rounding", 0.1}});
    make("Segment", crate);
    make("Capsule", crate);
    make("Polygon", crate);
    const Picture picture = draw();
    REQUIRE(picture.figures.size() == 4);
    CHECK(picture.figures[0].kind == "polygon");
    CHECK(picture.figures[0].points.size() == 4);
    CHECK(picture.figures[0].points[0].isApprox(Vec2(9.6, -0.4), 1e-5));  // without rounding
    CHECK(picture.figures[0].size == Approx(0.1));
    CHECK(picture.figures[1].kind == "line");
    CHECK(picture.figures[1].points[0] == Vec2(9.5, 0));
    CHECK(picture.figures[2].points.size() == 2);
    CHECK(picture.figures[2].size == Approx(0.25));
    CHECK(picture.figures[3].points.size() == 3);
}

TEST_CASE_METHOD(Drawn, "a polygon of many corners is drawn whole") {
    const Handle stone = body("Polygon", {0, 0});
    List corners;
    for (int i = 0; i < 50; ++i)
        corners.push_back(Vec2(std::cos(0.1256 * i), std::sin(0.1256 * i)));
    set(shape_of(stone), "vertices", corners);
    CHECK(draw().figures.at(0).points.size() == 50);
}

TEST_CASE_METHOD(Drawn, "colors come from the shape or else its body or else its type") {
    const property::Color red{1, 0, 0, 1}, blue{0, 0, 1, 1};
    const Handle ball = body("Circle", {0, 0});
    const auto fill = [&] { return draw().figures.at(0).paint.fill; };
    const property::Color dynamic = fill();
    set(ball, "type", "static");
    CHECK_FALSE(fill() == dynamic);
    set(ball, "color", "red");
    CHECK(fill() == red);
    set(shape_of(ball), "color", blue);
    CHECK(fill() == blue);
    set(shape_of(ball), "color", Value());
    CHECK(fill() == red);
    CHECK(get(shape_of(ball), "color") == red);
    set(ball, "color", Value());
    CHECK(get(ball, "color").is_nil());
    set(ball, "type", "dynamic");
    CHECK(fill() == dynamic);
}

TEST_CASE_METHOD(Drawn, "looks belong to their shape alone") {
    const Handle ball = body("Circle", {0, 0});
    set(shape_of(ball), "visible", false);
    set(shape_of(ball), "color", "red");
    set(ball, "color", "blue");
    CHECK(draw().figures.empty());
    tree.destroy(ball);
    // The next ones take over the slots, not the looks.
    const Handle next = body("Circle", {0, 0});
    CHECK(get(shape_of(next), "visible").boolean());
    CHECK_FALSE(tree.overridden(shape_of(next), tree.property(shape_of(next), "color")));
    CHECK(get(next, "color").is_nil());
}

TEST_CASE_METHOD(Drawn, "what cannot be seen is not drawn") {
    body("Circle", {0, 0});
    const Handle mover = body("Circle", {40, 0});
    Picture picture;
    picture.right = 10;
    tree.draw(tree.root(), picture, 1.0);
    CHECK(picture.count("circle") == 1);
    // On its way out of the view it is still seen.
    set(mover, "position", Vec2(9, 0));
    set(mover, "velocity", Vec2(600, 0));
    step();
    Picture later;
    later.right = 10;
    tree.draw(tree.root(), later, 0.0);
    CHECK(later.count("circle") == 2);
}

TEST_CASE_METHOD(Drawn, "overlays are drawn on demand and over everything else") {
    floor();
    const Handle crate = body("Box", {0, 0.5});
    const Handle joint = make("MouseJoint", world(), {{"body", crate}, {"target", Vec2(0, 1)}});
    step(20);
    const std::size_t plain = draw().figures.size();
    const auto with = [&](property::Overlay overlay) {
        Picture picture;
        picture.overlays = {overlay};
        tree.draw(tree.root(), picture, 1.0);
        picture.figures.erase(picture.figures.begin(),
                              picture.figures.begin() + static_cast<std::ptrdiff_t>(plain));
        return picture;
    };
    CHECK(with(property::Overlay::contacts).count("point") == 2);
    CHECK(with(property::Overlay::contacts).count("line") == 2);
    CHECK(with(property::Overlay::aabbs).count("polygon") == 2);
    CHECK(with(property::Overlay::centers).count("point") == 2);
    CHECK(with(property::Overlay::velocities).count("line") == 1);
    CHECK(with(property::Overlay::joints).count("line") == 1);
    CHECK(with(property::Overlay::islands).figures.empty());
    tree.destroy(joint);
    REQUIRE(falls_asleep(crate));
    CHECK(with(property::Overlay::islands).count("text") == 1);
}

TEST_CASE_METHOD(Drawn, "a sensor is drawn so that one sees what is in it") {
    const Handle gate = body("Box", {0, 0});
    const float before = draw().figures.at(0).paint.fill.a;
    set(shape_of(gate), "sensor", true);
    CHECK(draw().figures.at(0).paint.fill.a < 0.5f * before);
}
