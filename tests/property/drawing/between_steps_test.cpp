// Instances are drawn between where they were before the last step and where they are after it.

#include <cmath>
#include <numbers>

#include <fettle/property/between_steps.h>
#include <fettle/property/drawing.h>
#include <fettle/property/error.h>
#include <fettle/property/pose.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

#include "catch.h"

namespace between_steps_test {

using namespace fettle::property;

namespace {

struct Pictures {
    Tree tree;
    Handle self;
    Pictures() {
        tree.define(
            {.name = "Place",
             .properties = {{.name = "position", .type = Type::vec2, .default_value = Vec2(0, 0)},
                            {.name = "angle", .type = Type::number, .default_value = 0.0},
                            {.name = "scale", .type = Type::number, .default_value = 1.0},
                            {.name = "visible", .type = Type::boolean, .default_value = true},
                            {.name = "points", .type = Type::list, .element = Type::vec2}}});
        self = make();
    }
    Handle make(Handle above = {}) {
        return tree.create(tree.class_named("Place"), above ? above : tree.root());
    }
    template <class Moves>
    void step(Moves moves) {
        note_step_begins(tree);
        moves();
        note_step_ended(tree, {.world = 2, .screen = 100});
    }
    void move(Handle instance, const Vec2& to) { tree.set(instance, "position", Value(to)); }
    void step_to(const Vec2& to) {
        step([&] { move(self, to); });
    }
    Transform at(Handle instance, double alpha = 0.5, bool on_screen = false) const {
        return place_below(tree, instance, on_screen, alpha).value();
    }
    double x(Handle instance, double alpha = 0.5) const { return at(instance, alpha).origin.x; }
    double angle(double alpha = 0.5) const {
        const Vec2 right = at(self, alpha).direction({1, 0});
        return std::atan2(right.y, right.x);
    }
};

}  // namespace

TEST_CASE_METHOD(Pictures, "a place that a step has moved is drawn between two steps") {
    step_to({1, 0});
    CHECK(x(self, 0) == Approx(0).margin(1e-12));
    CHECK(x(self, 0.25) == Approx(0.25));
    CHECK(x(self, 1) == 1);
    step_to({1, 0});
    CHECK(x(self, 0.25) == 1);
}

TEST_CASE_METHOD(Pictures, "without notes an instance is drawn where it is") {
    move(self, {1, 0});
    CHECK(x(self) == 1);
}

TEST_CASE_METHOD(Pictures, "angle and scale are drawn between two steps") {
    step([&] {
        tree.set(self, "angle", Value(1.0));
        tree.set(self, "scale", Value(3.0));
    });
    CHECK(angle() == Approx(0.5));
    CHECK(at(self).scale() == Approx(2));
}

TEST_CASE_METHOD(Pictures, "an angle goes the shorter way") {
    tree.set(self, "angle", Value(3.1));
    step([&] { tree.set(self, "angle", Value(-3.1)); });
    CHECK(std::abs(angle()) == Approx(std::numbers::pi));
}

TEST_CASE_METHOD(Pictures, "a flip by a negative scale is drawn at once") {
    step([&] { tree.set(self, "scale", Value(-1.0)); });
    CHECK(at(self).scale() == Approx(1));
}

TEST_CASE_METHOD(Pictures, "a place below a moving one follows it") {
    const Handle below = make(self);
    move(below, {0, 5});
    step_to({1, 0});
    CHECK(x(below) == Approx(0.5));
    CHECK(at(below).origin.y == Approx(5));
}

TEST_CASE_METHOD(Pictures, "a plain node with a position of its own is drawn between two steps") {
    const Handle node = tree.create(tree.object_class(), tree.root());
    tree.set_or_add(node, "position", Value(Vec2(0, 0)));
    step([&] { move(node, {1, 0}); });
    CHECK(x(node) == Approx(0.5));
    move(node, {7, 0});
    CHECK(x(node) == 7);
}

TEST_CASE_METHOD(Pictures, "a write between two steps is drawn at once") {
    step_to({1, 0});
    move(self, {5, 0});
    CHECK(x(self) == 5);
    step_to({5.5, 0});
    CHECK(x(self) == Approx(5.25));
}

TEST_CASE_METHOD(Pictures, "an angle that is written each frame does not stop the motion") {
    step_to({1, 0});
    tree.set(self, "angle", Value(0.7));
    CHECK(x(self) == Approx(0.5));
    CHECK(angle() == Approx(0.7));
}

TEST_CASE_METHOD(Pictures, "a jump in a step is drawn at once") {
    step_to({0.5, 0});
    step_to({100, 0});
    CHECK(x(self) == 100);
    step_to({100.5, 0});
    CHECK(x(self) == Approx(100.25));
}

TEST_CASE_METHOD(Pictures, "a steady fast motion is no jump") {
    step_to({3, 0});
    step_to({6, 0});
    CHECK(x(self) == Approx(4.5));
}

TEST_CASE_METHOD(Pictures, "what was made in a step is drawn where it is") {
    Handle made;
    step([&] {
        made = make();
        move(made, {1, 0});
    });
    CHECK(x(made) == 1);
    step([&] { move(made, {2, 0}); });
    CHECK(x(made) == Approx(1.5));
}

TEST_CASE_METHOD(Pictures, "what takes the row of a deleted instance is drawn where it is") {
    step_to({1, 0});
    Handle made;
    step([&] {
        tree.destroy(self);
        made = make();
        move(made, {2, 0});
    });
    CHECK(x(made) == 2);
}

TEST_CASE_METHOD(Pictures, "what becomes visible in a step is drawn where it is") {
    tree.set(self, "visible", Value(false));
    step([&] {
        move(self, {1, 0});
        tree.set(self, "visible", Value(true));
    });
    CHECK(x(self) == 1);
}

TEST_CASE_METHOD(Pictures, "what gets another parent in a step is drawn where it is") {
    const Handle above = make();
    move(above, {1, 0});
    const Handle node = tree.create(tree.object_class(), tree.root());
    tree.set_or_add(node, "position", Value(Vec2(0, 0)));
    step([&] {
        for (const Handle each : {self, node}) {
            tree.move(each, above);
            move(each, {0.5, 0});
        }
    });
    CHECK(x(self) == 1.5);
    CHECK(x(node) == 1.5);
}

TEST_CASE_METHOD(Pictures, "after a restore everything is drawn where it is") {
    step_to({1, 0});
    const Snapshot here = tree.snapshot();
    step_to({2, 0});
    tree.restore(here);
    CHECK(x(self) == 1);
}

TEST_CASE_METHOD(Pictures, "a formula that a step changes is drawn between two steps") {
    const Handle source = make();
    Formula twice;
    twice.function = [source](const Tree& in) {
        return Value(Vec2(2 * in.get(source, "position").vec2()));
    };
    tree.set_formula(self, "position", twice);
    tree.barrier();
    step([&] {
        move(source, {0.5, 0});
        tree.barrier();
    });
    CHECK(x(self) == Approx(0.5));
}

TEST_CASE_METHOD(Pictures, "a formula that asks where an instance is drawn follows it") {
    const Handle below = make(self);
    const Handle mark = make();
    Formula there;
    there.function = [below](const Tree& in) {
        return std::get<Value>(const_cast<Tree&>(in).call(below, "drawn_position", {}));
    };
    tree.set_formula(mark, "position", there);
    move(self, {3, 0});
    CHECK(tree.get(mark, "position").vec2() == Vec2(3, 0));
    move(below, {0, 1});
    CHECK(tree.get(mark, "position").vec2() == Vec2(3, 1));
}

TEST_CASE_METHOD(Pictures, "a list of points is drawn between two steps") {
    const Property& points = *tree.find(self, "points");
    const auto drawn = [&] { return drawn_points(tree, self, points, false, 0.5).list(); };
    const auto set = [&](List list) { tree.set(self, points, Value(std::move(list))); };
    set({Vec2(0, 0), Vec2(0, 1)});
    step([&] { set({Vec2(1, 0), Vec2(0, 1)}); });
    CHECK(drawn().at(0).vec2() == Vec2(0.5, 0));
    CHECK(drawn().at(1).vec2() == Vec2(0, 1));
    step([&] { set({Vec2(2, 0), Vec2(0, 1), Vec2(0, 2)}); });
    CHECK(drawn().at(0).vec2() == Vec2(2, 0));
    step([&] { set({Vec2(50, 0), Vec2(0, 1), Vec2(0, 2)}); });
    CHECK(drawn().at(0).vec2() == Vec2(50, 0));
    set({Vec2(3, 0)});
    CHECK(drawn().size() == 1);
}

TEST_CASE_METHOD(Pictures, "every instance says where it is drawn") {
    const Handle below = make(self);
    move(below, {0, 2});
    tree.set(self, "angle", Value(0.5));
    step([&] {
        move(self, {1, 0});
        tree.set(self, "angle", Value(0.7));
    });
    const auto asked = [&](Handle instance, const char* method) {
        return std::get<Value>(tree.call(instance, method, {}));
    };
    CHECK(asked(self, "drawn_position").vec2() == Vec2(1, 0));
    CHECK(asked(self, "drawn_angle").number() == Approx(0.7));
    const Drawing drawing(0.5);
    CHECK(asked(self, "drawn_position").vec2().x == Approx(0.5));
    CHECK(asked(below, "drawn_angle").number() == Approx(0.6));
    const Vec2 point = std::get<Value>(tree.call(self, "to_drawn", {Value(Vec2(0, 2))})).vec2();
    CHECK((point - asked(below, "drawn_position").vec2()).length() < 1e-12);
}

}  // namespace between_steps_test
