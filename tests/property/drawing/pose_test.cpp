// Where instances are in the world.

#include <cmath>
#include <numbers>

#include <fettle/property/pose.h>
#include <fettle/property/tree.h>

#include "catch.h"

namespace pose_test {

using namespace fettle::property;

namespace {

/// `Place` has a position, an angle and a scale; `Rider` has its place in the world, at (10,
/// alpha).
struct Places {
    Tree tree;
    Places() {
        tree.define(
            {.name = "Place",
             .properties = {{.name = "position", .type = Type::vec2, .default_value = Vec2(0, 0)},
                            {.name = "angle", .type = Type::number, .default_value = 0.0},
                            {.name = "scale", .type = Type::number, .default_value = 1.0}}});
        ClassDescriptor rider{.name = "Rider"};
        rider.lifecycle.pose = [](void*, const Tree&, Handle, Row, double alpha) {
            return Transform::moved({10, alpha});
        };
        tree.define(rider);
    }
    Handle make(const char* of, Handle above, const Vec2& position = {0, 0}) {
        const Handle made = tree.create(tree.class_named(of), above, "");
        if (tree.find(made, "position") != nullptr) tree.set(made, "position", Value(position));
        return made;
    }
    Vec2 at(Handle instance, double alpha = 1, bool on_screen = false) const {
        return place_below(tree, instance, on_screen, alpha).value()(Vec2(1, 0));
    }
};

bool near(const Vec2& a, const Vec2& b) {
    return (a - b).length() < 1e-12;
}

}  // namespace

TEST_CASE_METHOD(Places, "an instance places everything below it by scale and angle and position") {
    const Handle outer = make("Place", tree.root(), {5, 0});
    const Handle group = make("Object", outer);
    const Handle inner = make("Place", group, {1, 1});
    CHECK(near(at(inner), {7, 1}));
    tree.set(outer, "angle", Value(std::numbers::pi / 2));
    CHECK(near(at(inner), {4, 2}));
    tree.set(outer, "scale", Value(2.0));
    CHECK(near(at(inner), {3, 4}));
    CHECK(near(at(inner, 1, true), {7, -4}));
}

TEST_CASE_METHOD(Places, "an instance with a place in the world keeps it below another one") {
    const Handle outer = make("Place", tree.root(), {5, 0});
    const Handle rider = make("Rider", outer);
    const Handle second = make("Rider", rider);
    CHECK(near(at(rider, 0.25), {11, 0.25}));
    CHECK(near(at(second, 0.25), {11, 0.25}));
    CHECK(near(at(make("Place", second, {0, 2}), 0), {11, 2}));
}

TEST_CASE_METHOD(Places, "an instance without a placed ancestor has no place") {
    CHECK_FALSE(place_below(tree, make("Object", tree.root()), false, 1).has_value());
    CHECK_FALSE(place_below(tree, tree.root(), false, 1).has_value());
    CHECK(place_below(tree, make("Place", tree.root()), false, 1).has_value());
}

}  // namespace pose_test
