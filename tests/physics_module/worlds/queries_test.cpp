// Queries: methods of World and Body.

#include "catch.h"
#include "game.h"

namespace queries_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Record;

namespace {

Value value_of(const property::Result& result) {
    return std::get<Value>(result);
}

}  // namespace

TEST_CASE_METHOD(Game, "a ray hits the nearest shape and returns the point") {
    const Handle near = body("Box", {3, 0}), far = body("Circle", {6, 0});
    const auto result = tree.call(world(), "raycast", {Vec2(0, 0), Vec2(10, 0)});
    const Record hit = std::get<Record>(result);
    CHECK(hit.get("body") == near);
    CHECK(hit.get("shape") == shape_of(near));
    CHECK((hit.get("point").vec2() - Vec2(2.5, 0)).length() < 1e-4);
    CHECK((hit.get("normal").vec2() - Vec2(-1, 0)).length() < 1e-4);
    CHECK(hit.get("fraction").number() == Approx(0.25));
    const auto all =
        std::get<std::vector<Record>>(tree.call(world(), "raycast_all", {Vec2(0, 0), Vec2(10, 0)}));
    REQUIRE(all.size() == 2);
    CHECK(all[0].get("body") == near);
    CHECK(all[1].get("body") == far);
    CHECK(value_of(tree.call(world(), "raycast", {Vec2(0, 5), Vec2(10, 5)})).is_nil());
}

TEST_CASE_METHOD(Game, "a ray finds a shape that was edited just before") {
    const Handle crate = body("Box", {3, 0});
    set(crate, "position", Vec2(3, 20));
    CHECK(value_of(tree.call(world(), "raycast", {Vec2(0, 0), Vec2(10, 0)})).is_nil());
    set(shape_of(crate), "height", 60);
    CHECK(std::get<Record>(tree.call(world(), "raycast", {Vec2(0, 0), Vec2(10, 0)})).get("body") ==
          crate);
}

TEST_CASE_METHOD(Game, "a ray finds only shapes of the given categories") {
    const Handle a = body("Box", {3, 0}), b = body("Box", {6, 0});
    set(shape_of(b), "category", 4);
    const auto hit = std::get<Record>(tree.call(world(), "raycast", {Vec2(0, 0), Vec2(10, 0), 4}));
    CHECK(hit.get("body") == b);
    CHECK(hit.get("body") != a);
}

TEST_CASE_METHOD(Game, "the body at a point is the smaller one of several") {
    const Handle large = body("Box", {0, 0});
    set(shape_of(large), "width", 10);
    const Handle small = body("Circle", {2, 0});
    const Handle sensor = body("Box", {-3, 0});
    set(shape_of(sensor), "sensor", true);
    const auto at = [&](const Vec2& p) { return value_of(tree.call(world(), "at", {p})); };
    CHECK(at({2, 0}) == small);
    CHECK(at({0, 0}) == large);
    CHECK(at({-3, 0}) == sensor);
    CHECK(at({50, 0}).is_nil());
}

TEST_CASE_METHOD(Game, "a box query returns each overlapping body once") {
    const Handle a = body("Box", {0, 0}), b = body("Circle", {3, 0});
    make("Circle", a);
    body("Box", {30, 0});
    const Value found = value_of(tree.call(world(), "overlap_box", {Vec2(4, 1), Vec2(-1, -1)}));
    REQUIRE(found.list().size() == 2);
    CHECK(std::count(found.list().begin(), found.list().end(), Value(a)) == 1);
    CHECK(std::count(found.list().begin(), found.list().end(), Value(b)) == 1);
}

TEST_CASE_METHOD(Game, "contacts list the points and impulses of touching shapes") {
    const Handle ground = floor();
    const Handle crate = body("Box", {0, 0.5});
    step(20);
    const auto contacts = std::get<std::vector<Record>>(tree.call(world(), "contacts", {}));
    REQUIRE(contacts.size() == 2);
    double force = 0;
    for (const Record& contact : contacts) {
        CHECK((contact.get("body_a") == ground || contact.get("body_b") == ground));
        CHECK((contact.get("shape_a") == shape_of(crate) ||
               contact.get("shape_b") == shape_of(crate)));
        CHECK(contact.get("point").vec2().y == Approx(0).margin(0.02));
        force += contact.get("force").number();
    }
    CHECK(force == Approx(10).epsilon(0.02));
}

TEST_CASE_METHOD(Game, "points are converted from a body to the world and back") {
    const Handle crate = body("Box", {3, 4});
    set(crate, "angle", 3.14159265 / 2);
    const Value there = value_of(tree.call(crate, "to_world", {Vec2(1, 0)}));
    CHECK((there.vec2() - Vec2(3, 5)).length() < 1e-5);
    CHECK((value_of(tree.call(crate, "to_local", {there})).vec2() - Vec2(1, 0)).length() < 1e-5);
    set(crate, "angular_velocity", 2);
    CHECK((value_of(tree.call(crate, "velocity_at", {Vec2(3, 5)})).vec2() - Vec2(-2, 0)).length() <
          1e-5);
}

TEST_CASE_METHOD(Game, "impulses and forces move a sleeping body") {
    floor();
    const Handle crate = body("Box", {0, 0.5});
    REQUIRE(falls_asleep(crate));
    SECTION("an impulse") {
        tree.call(crate, "apply_impulse", {Vec2(0, 5)});
        CHECK(vec(crate, "velocity") == Vec2(0, 5));
    }
    SECTION("an impulse at a point") {
        tree.call(crate, "apply_impulse", {Vec2(0, 5), Vec2(0.5, 0.5)});
        CHECK(number(crate, "angular_velocity") > 1);
    }
    SECTION("a force for one step") {
        tree.call(crate, "apply_force", {Vec2(0, 300)});
    }
    step();
    CHECK(vec(crate, "velocity").y > 2);
    CHECK(vec(crate, "force") == Vec2(0, 0));
}

TEST_CASE_METHOD(Game, "invalid arguments are refused by name") {
    const Handle crate = body("Box", {0, 0});
    CHECK_THROWS_WITH(tree.call(crate, "apply_impulse", {5}), contains("impulse"));
    CHECK_THROWS_WITH(tree.call(crate, "apply_impulse", {Vec2(1e300, 0)}),
                      contains("expected a vec2 from -3.4"));
    CHECK_THROWS_AS(tree.call(world(), "raycast", {Vec2(0, 0)}), property::Error);
    CHECK_THROWS_WITH(tree.call(world(), "explode_surfaces", {Vec2(0, 0), 1, 1e300, 1}),
                      contains("falloff: "));
    CHECK_THROWS_WITH(tree.call(world(), "explode_surfaces", {Vec2(0, 0), 1, 1, 1e300}),
                      contains("impulse_per_length: "));
    CHECK_THROWS_WITH(tree.call(world(), "explode", {Vec2(0, 0), 1e300, 1}), contains("radius: "));
    CHECK_THROWS_AS(tree.call(world(), "at", {Vec2(1e200, 0)}), property::Error);
    CHECK_THROWS_AS(tree.call(world(), "at", {Vec2(1e30, 0)}), property::Error);
}

}  // namespace queries_test
