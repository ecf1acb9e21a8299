// Bodies whose pose is written in a step are drawn between the last two steps, as other instances
// are.

#include <catch.h>

#include <fettle/property/between_steps.h>
#include <fettle/property/drawing.h>

#include "game.h"

namespace written_poses_test {

using namespace fettle::physics_module::testing;
using namespace fettle;

namespace {

/// A kinematic body, 20 m of the world in the height of the picture.
struct Written : Game {
    Handle lift = body("Box", {0, 0});

    Written() { set(lift, "type", "kinematic"); }
    /// A step in which `write` is called before the world is stepped.
    template <class Write>
    void step_with(Write write) {
        property::note_step_begins(tree);
        write();
        step();
        property::note_step_ended(tree, {.world = 2, .screen = 72});
    }
    void put(double x) { set(lift, "position", Vec2(x, 0)); }
    double drawn_x(Handle which) {
        const property::Drawing drawing(0.25);
        return std::get<Value>(tree.call(which, "drawn_position", {})).vec2().x;
    }
};

}  // namespace

TEST_CASE_METHOD(Written, "a body that a step puts elsewhere is drawn between the two places") {
    step_with([&] { put(1); });
    CHECK(drawn_x(lift) == Approx(0.25));
    step_with([&] {
        put(5);
        put(2);
    });
    CHECK(drawn_x(lift) == Approx(1.25));
    step_with([&] { set(lift, "angle", 1.0); });
    const property::Drawing drawing(0.25);
    CHECK(std::get<Value>(tree.call(lift, "drawn_angle", {})).number() == Approx(0.25));
    CHECK(get(lift, "position").vec2() == Vec2(2, 0));
}

TEST_CASE_METHOD(Written, "a body that no step writes any more is drawn where it is") {
    step_with([&] { put(1); });
    step_with([] {});
    CHECK(drawn_x(lift) == Approx(1));
}

TEST_CASE_METHOD(Written, "a body that is put elsewhere between steps is drawn there at once") {
    step_with([&] { put(1); });
    put(1.5);
    CHECK(drawn_x(lift) == Approx(1.5));
    step_with([&] { put(2); });
    CHECK(drawn_x(lift) == Approx(1.625));
}

TEST_CASE_METHOD(Written, "a jump of a body in a step is drawn at once") {
    step_with([&] { put(1); });
    step_with([&] { put(11); });
    CHECK(drawn_x(lift) == Approx(11));
    step_with([&] { put(21); });  // it moves steadily
    CHECK(drawn_x(lift) == Approx(13.5));
}

TEST_CASE_METHOD(Written, "a body that a step makes is drawn where it is") {
    Handle made;
    step_with([&] {
        made = body("Circle", {0, 9}, "kinematic");
        set(made, "position", Vec2(1, 9));
    });
    CHECK(drawn_x(made) == Approx(1));
}

TEST_CASE_METHOD(Written, "after a restore a body is drawn where it is") {
    const property::Snapshot then = tree.snapshot();
    step_with([&] { put(1); });
    tree.restore(then);
    CHECK(drawn_x(lift) == Approx(0));
}

TEST_CASE_METHOD(Written, "shapes of a body that a step puts elsewhere are drawn with it") {
    step_with([&] { put(1); });
    const property::Drawing drawing(0.25);
    const Value corner = std::get<Value>(tree.call(lift, "to_drawn", {Vec2(0.5, 0.5)}));
    CHECK(corner.vec2().x == Approx(0.75));
}

}  // namespace written_poses_test
