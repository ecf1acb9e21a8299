// Drawing of bodies, shapes and overlays.

#include <cmath>

#include <fettle/property/drawing.h>

#include "catch.h"
#include "game.h"
#include "picture.h"

namespace drawing_test {

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

TEST_CASE_METHOD(Drawn, "a round shape has a radius line that turns with it if it is asked for") {
    const Handle ball = body("Circle", {2, 3});
    set(ball, "angle", 3.14159265 / 2);
    CHECK(draw().figures.size() == 1);
    set(shape_of(ball), "orientation_mark", true);
    const Picture picture = draw();
    REQUIRE(picture.figures.size() == 2);
    CHECK(picture.figures[0].kind == "circle");
    CHECK(picture.figures[0].points[0] == Vec2(2, 3));
    CHECK(picture.figures[0].size == 0.5);
    CHECK(picture.figures[1].kind == "line");
    CHECK((picture.figures[1].points[1] - Vec2(2, 3.5)).length() < 1e-5);
    CHECK(picture.figures[1].paint.fill == picture.figures[0].paint.border);
}

TEST_CASE_METHOD(Drawn, "bodies are drawn between their last two poses") {
    const Handle ball = body("Circle", {0, 0});
    set(ball, "gravity_scale", 0);
    set(ball, "velocity", Vec2(60, 0));
    step();
    CHECK(draw(0.0).figures[0].points[0].x == Approx(0).margin(1e-5));
    CHECK(draw(0.5).figures[0].points[0].x == Approx(0.5));
    CHECK(draw(1.0).figures[0].points[0].x == Approx(1));
    set(ball, "position", Vec2(9, 9));
    CHECK(draw(0.5).figures[0].points[0] == Vec2(9, 9));
}

TEST_CASE_METHOD(Drawn, "every shape is drawn with its own figure") {
    const Handle crate = make("Body", world(), {{"position", Vec2(10, 0)}});
    make("Box", crate, {{"rounding", 0.1}});
    make("Segment", crate);
    make("Capsule", crate);
    make("Polygon", crate);
    const Picture picture = draw();
    REQUIRE(picture.figures.size() == 4);
    CHECK(picture.figures[0].kind == "polygon");
    CHECK(picture.figures[0].points.size() == 4);
    CHECK((picture.figures[0].points[0] - Vec2(9.6, -0.4)).length() <
          1e-5);  // the corner without rounding
    CHECK(picture.figures[0].size == Approx(0.1));
    CHECK(picture.figures[1].kind == "line");
    CHECK(picture.figures[1].points[0] == Vec2(9.5, 0));
    CHECK(picture.figures[2].points.size() == 2);
    CHECK(picture.figures[2].size == Approx(0.25));
    CHECK(picture.figures[3].points.size() == 3);
}

TEST_CASE_METHOD(Drawn, "round and concave shapes are drawn with their own figures") {
    const Handle egg = make("Body", world(), {{"position", Vec2(1, 2)}, {"angle", 0.5}});
    make("Ellipse", egg, {{"radius_x", 3}, {"radius_y", 1}, {"angle", 0.25}});
    const Handle star = make("Body", world(), {{"position", Vec2(20, 0)}});
    const Handle form = make("Concave", star);
    set(form, "vertices", List{Vec2(-1, -1), Vec2(1, -1), Vec2(0, 0), Vec2(1, 1), Vec2(-1, 1)});
    const Picture picture = draw();
    REQUIRE(picture.figures.size() == 2);
    CHECK(picture.figures[0].kind == "ellipse");
    CHECK(picture.figures[0].points[0] == Vec2(1, 2));
    CHECK(picture.figures[0].points[1] == Vec2(3, 1));
    CHECK(picture.figures[0].size == Approx(0.75));
    CHECK(picture.figures[1].kind == "polygon");
    CHECK(picture.figures[1].points.size() == 5);
}

TEST_CASE_METHOD(Drawn, "the shapes of one body are parts of one figure") {
    const Handle alone = body("Circle", {0, 0});
    const Handle pair = body("Circle", {5, 0});
    make("Box", pair);
    const Handle other = body("Box", {9, 0});
    make("Box", other);
    const Picture picture = draw();
    std::vector<std::uint64_t> wholes;
    for (const Figure& figure : picture.figures) wholes.push_back(figure.whole);
    REQUIRE(wholes.size() == 5);
    CHECK(wholes[0] == 0);
    CHECK((wholes[1] != 0 && wholes[1] == wholes[2]));
    CHECK((wholes[3] != wholes[2] && wholes[3] == wholes[4]));
    CHECK(tree.alive(alone));
}

TEST_CASE_METHOD(Drawn, "a polygon of many corners is drawn completely") {
    const Handle stone = body("Polygon", {0, 0});
    List corners;
    for (int i = 0; i < 50; ++i)
        corners.push_back(Vec2(std::cos(0.1256 * i), std::sin(0.1256 * i)));
    set(shape_of(stone), "vertices", corners);
    CHECK(draw().figures.at(0).points.size() == 50);
}

TEST_CASE_METHOD(Drawn, "the color is that of the shape or else of the body or else of the type") {
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

TEST_CASE_METHOD(Drawn, "the look of a deleted shape is not used by the next one") {
    const Handle ball = body("Circle", {0, 0});
    set(shape_of(ball), "visible", false);
    set(shape_of(ball), "color", "red");
    set(ball, "color", "blue");
    CHECK(draw().figures.empty());
    tree.destroy(ball);
    // The next shapes get the slots but not the looks.
    const Handle next = body("Circle", {0, 0});
    CHECK(get(shape_of(next), "visible").boolean());
    CHECK_FALSE(tree.overridden(shape_of(next), tree.property(shape_of(next), "color")));
    CHECK(get(next, "color").is_nil());
}

TEST_CASE_METHOD(Drawn, "shapes outside the view are not drawn") {
    body("Circle", {0, 0});
    const Handle mover = body("Circle", {40, 0});
    Picture picture;
    picture.right = 10;
    tree.draw(tree.root(), picture, 1.0);
    CHECK(picture.count("circle") == 1);
    // The drawn pose on the way out of the view is still visible.
    set(mover, "position", Vec2(9, 0));
    set(mover, "velocity", Vec2(600, 0));
    step();
    Picture later;
    later.right = 10;
    tree.draw(tree.root(), later, 0.0);
    CHECK(later.count("circle") == 2);
}

TEST_CASE_METHOD(Drawn, "overlays are drawn on demand and after everything else") {
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
    CHECK(with(property::Overlay::islands).count("text") == 0);
    tree.destroy(joint);
    REQUIRE(falls_asleep(crate));
    CHECK(with(property::Overlay::islands).count("text") == 1);
}

TEST_CASE_METHOD(Drawn, "a sensor is drawn so that shapes inside stay visible") {
    const Handle gate = body("Box", {0, 0});
    const float before = draw().figures.at(0).paint.fill.a;
    set(shape_of(gate), "sensor", true);
    CHECK(draw().figures.at(0).paint.fill.a < 0.5f * before);
    // The color of a body is that of all its shapes, also of what it sees.
    set(gate, "color", property::Color{1, 0, 0, 1});
    CHECK(draw().figures.at(0).paint.fill.a < 0.5f * before);
}

TEST_CASE_METHOD(Drawn, "a sensor with a color of its own is drawn in that color") {
    const Handle coin = body("Circle", {0, 0});
    set(shape_of(coin), "sensor", true);
    const property::Color gold{1, 0.8f, 0.2f, 1};
    set(shape_of(coin), "color", gold);
    CHECK(draw().figures.at(0).paint.fill == gold);
    const property::Color glass{1, 0.8f, 0.2f, 0.3f};
    set(shape_of(coin), "color", glass);
    CHECK(draw().figures.at(0).paint.fill == glass);
}

// --- The drawn pose ---------------------------------------------------------------------------

namespace {

/// A body that moved by a meter and turned in the last step, and a static body.
struct Moving : Drawn {
    Handle ship = body("Box", {0, 0});

    Moving() {
        set(ship, "gravity_scale", 0);
        set(ship, "velocity", Vec2(60, 0));
        set(ship, "angular_velocity", 30);
        step();
    }
    Value drawn(Handle which, const char* method, std::initializer_list<Value> arguments = {}) {
        return std::get<Value>(tree.call(which, method, arguments));
    }
    /// The figures that an overlay adds to the picture.
    Picture overlay(property::Overlay which, double alpha) {
        const std::size_t plain = draw(alpha).figures.size();
        Picture picture;
        picture.overlays = {which};
        tree.draw(tree.root(), picture, alpha);
        picture.figures.erase(picture.figures.begin(),
                              picture.figures.begin() + static_cast<std::ptrdiff_t>(plain));
        return picture;
    }
};

}  // namespace

TEST_CASE_METHOD(Moving, "the drawn pose of a body is available while a picture is drawn") {
    const double alpha = GENERATE(0.0, 0.25, 1.0);
    const property::Drawing drawing(alpha);
    const double angle = 0.5 * alpha;
    CHECK((drawn(ship, "drawn_position").vec2() - Vec2(alpha, 0)).length() < 1e-5);
    CHECK(drawn(ship, "drawn_angle").number() == Approx(angle).margin(1e-5));
    const Vec2 nose = drawn(ship, "to_drawn", {Vec2(2, 0)}).vec2();
    CHECK(nose.x == Approx(alpha + 2 * std::cos(angle)).margin(1e-5));
    CHECK(nose.y == Approx(2 * std::sin(angle)).margin(1e-5));
    // The corner is drawn there.
    CHECK((draw(alpha).figures.at(0).points[2] - drawn(ship, "to_drawn", {Vec2(0.5, 0.5)}).vec2())
              .length() < 1e-5);
}

TEST_CASE_METHOD(Moving, "the drawn pose of a body is its pose while no picture is drawn") {
    { const property::Drawing over(0.25); }
    CHECK(drawn(ship, "drawn_position").vec2() == get(ship, "position").vec2());
    CHECK(drawn(ship, "drawn_angle").number() == get(ship, "angle").number());
    CHECK((drawn(ship, "to_drawn", {Vec2(1, 1)}).vec2() -
           std::get<Value>(tree.call(ship, "to_world", {Vec2(1, 1)})).vec2())
              .length() < 1e-6);
}

TEST_CASE_METHOD(Moving, "a body without a pose before the last step is drawn at its pose") {
    const property::Drawing drawing(0.25);
    SECTION("moved by an edit") {
        set(ship, "position", Vec2(50, 50));
        CHECK(drawn(ship, "drawn_position").vec2() == Vec2(50, 50));
    }
    SECTION("turned by an edit") {
        set(ship, "angle", 3);
        CHECK(drawn(ship, "drawn_angle").number() == Approx(3));
    }
    SECTION("made since the last step") {
        CHECK(drawn(body("Circle", {7, 7}), "drawn_position").vec2() == Vec2(7, 7));
    }
    SECTION("static") {
        set(ship, "type", "static");
        CHECK((drawn(ship, "drawn_position").vec2() - Vec2(1, 0)).length() < 1e-5);
    }
    SECTION("in no world") {
        tree.move(ship, {});
        CHECK((drawn(ship, "drawn_position").vec2() - Vec2(1, 0)).length() < 1e-5);
    }
    SECTION("asleep") {
        set(ship, "awake", false);
        CHECK((drawn(ship, "drawn_position").vec2() - Vec2(1, 0)).length() < 1e-5);
    }
    SECTION("deleted") {
        tree.destroy(ship);
        CHECK_THROWS(drawn(ship, "drawn_position"));
    }
}

TEST_CASE_METHOD(Moving,
                 "a kinematic body and one inside another are drawn at interpolated poses too") {
    const Handle lift = body("Box", {0, 20});
    set(lift, "type", "kinematic");
    set(lift, "velocity", Vec2(0, 60));
    const Handle child = make("Body", ship, {{"position", Vec2(5, 5)}, {"velocity", Vec2(60, 0)}});
    make("Circle", child);
    set(child, "gravity_scale", 0);
    step();
    const property::Drawing drawing(0.5);
    CHECK((drawn(lift, "drawn_position").vec2() - Vec2(0, 20.5)).length() < 1e-4);
    CHECK(drawn(child, "drawn_position").vec2().x == Approx(5.5).epsilon(1e-3));
}

TEST_CASE_METHOD(Moving, "a body that turned by more than half a turn is not drawn turning back") {
    set(ship, "angle", 3.1);
    set(ship, "angular_velocity", 30);
    step();
    const property::Drawing drawing(0.5);
    CHECK(std::remainder(drawn(ship, "drawn_angle").number() - 3.35, 6.283185307) ==
          Approx(0).margin(1e-3));
}

TEST_CASE_METHOD(Moving, "a restored snapshot is drawn as it was") {
    const property::Snapshot then = tree.snapshot();
    step(5);
    tree.restore(then);
    const property::Drawing drawing(0.25);
    CHECK((drawn(ship, "drawn_position").vec2() - Vec2(0.25, 0)).length() < 1e-5);
}

TEST_CASE_METHOD(Moving, "every overlay is drawn at the drawn poses of the shapes") {
    const double alpha = 0.25;
    const Picture shapes = draw(alpha);
    SECTION("boxes") {
        const Picture boxes = overlay(property::Overlay::aabbs, alpha);
        REQUIRE(boxes.figures.size() == 1);
        Vec2 lower = shapes.figures[0].points[0], upper = lower;
        for (const Vec2& corner : shapes.figures[0].points) {
            lower = lower.min(corner);
            upper = upper.max(corner);
        }
        CHECK((boxes.figures[0].points[0] - lower).length() < 1e-6);
        CHECK((boxes.figures[0].points[2] - upper).length() < 1e-6);
    }
    SECTION("centers and velocities") {
        CHECK((overlay(property::Overlay::centers, alpha).figures.at(0).points[0] - Vec2(0.25, 0))
                  .length() < 1e-5);
        CHECK(
            (overlay(property::Overlay::velocities, alpha).figures.at(0).points[0] - Vec2(0.25, 0))
                .length() < 1e-5);
    }
    SECTION("names") {
        const Picture names = overlay(property::Overlay::names, alpha);
        // The last one is the text, over its outline.
        REQUIRE(names.figures.size() == 5);
        CHECK(names.figures[4].text == tree.name(ship));
        CHECK((names.figures[4].points[0] - Vec2(0.25, 0)).length() < 1e-5);
    }
    SECTION("joints") {
        make("MouseJoint", world(), {{"body", ship}, {"target", Vec2(1, 0)}});
        step();
        const Picture joints = overlay(property::Overlay::joints, alpha);
        REQUIRE(joints.count("line") == 1);
        const property::Drawing drawing(alpha);
        const Vec2 grip = drawn(ship, "to_drawn", {Vec2(0, 0)}).vec2();
        CHECK((joints.figures[0].points[1] - grip).length() < 0.3);
    }
}

TEST_CASE_METHOD(Moving, "no name is drawn over another one") {
    const auto names = [&] { return overlay(property::Overlay::names, 1).count("text"); };
    const std::size_t one = names();
    const Handle other = body("Box", {0.25, 0});
    CHECK(names() == one);
    set(other, "position", Vec2(0.25, 100));
    CHECK(names() == 2 * one);
}

TEST_CASE_METHOD(Drawn, "a contact is drawn at the drawn pose of the moving body") {
    floor();
    const Handle crate = body("Box", {0, 0.5});
    step(10);
    set(crate, "velocity", Vec2(6, 0));
    step(2);
    const double alpha = 0.25;
    Picture picture;
    picture.overlays = {property::Overlay::contacts};
    tree.draw(tree.root(), picture, alpha);
    const property::Drawing drawing(alpha);
    const double middle = std::get<Value>(tree.call(crate, "drawn_position", {})).vec2().x;
    double sum = 0;
    int points = 0;
    for (const Figure& figure : picture.figures)
        if (figure.kind == "point") sum += figure.points[0].x, ++points;
    REQUIRE(points == 2);
    CHECK(sum / 2 == Approx(middle).margin(0.01));
}

TEST_CASE_METHOD(Drawn, "the box of each kind of shape encloses the drawn figure") {
    const char* kind =
        GENERATE("Circle", "Ellipse", "Box", "Capsule", "Segment", "Polygon", "Concave", "Chain");
    const Handle thing = make("Body", world(), {{"position", Vec2(3, 4)}, {"angle", 0.7}});
    const Handle shape = make(kind, thing);
    if (std::string(kind) == "Ellipse") set(shape, "radius_x", 2);
    if (std::string(kind) == "Box") set(shape, "rounding", 0.2);
    Picture picture;
    picture.overlays = {property::Overlay::aabbs};
    tree.draw(tree.root(), picture, 1.0);
    const List box = get(shape, "aabb").list();
    INFO(kind);
    CHECK((picture.figures.back().points[0] - box[0].vec2()).length() < 0.02);
    CHECK((picture.figures.back().points[2] - box[1].vec2()).length() < 0.02);
}

}  // namespace drawing_test
