#include <variant>

#include "catch.h"
#include "game.h"

namespace disabled_test {

// Disabled bodies in a tree: live, in snapshots, and on their way between worlds.

using namespace fettle::physics_module::testing;
namespace property = fettle::property;

namespace {

struct Shelf : Game {
    Handle ground = floor();
    Handle shelf = body("Box", Vec2(0, 3), "static");
    Handle crate = body("Circle", Vec2(0, 4));

    bool sound() { return !physics.world(world()).validate(); }
};

}  // namespace

TEST_CASE_METHOD(Shelf, "a support that is disabled lets a sleeping body fall and returns") {
    REQUIRE(falls_asleep(crate));
    set(shelf, "enabled", false);
    step(120);
    CHECK(y(crate) < 0.6);
    CHECK_FALSE(get(shelf, "enabled").boolean());
    CHECK(std::get<Value>(tree.call(world(), "at", {Vec2(0, 3)})).is_nil());
    set(crate, "position", Vec2(0, 5));
    set(shelf, "enabled", true);
    step(120);
    CHECK(y(crate) > 3.9);
    CHECK(sound());
}

TEST_CASE_METHOD(Shelf, "a disabled body keeps a velocity that is written to it") {
    set(crate, "enabled", false);
    set(crate, "velocity", Vec2(2, 0));
    set(crate, "angular_velocity", 1);
    step(30);
    CHECK(x(crate) == 0);
    CHECK(vec(crate, "velocity") == Vec2(2, 0));
    CHECK_FALSE(awake(crate));
    set(crate, "position", Vec2(5, 9));
    set(crate, "enabled", true);
    step(30);
    CHECK(x(crate) == Approx(6).margin(0.01));
    CHECK(awake(crate));
    CHECK(sound());
}

TEST_CASE_METHOD(Shelf,
                 "a snapshot has what is disabled and the rare values of bodies and shapes") {
    step(30);
    const property::Snapshot before = tree.snapshot();
    set(shelf, "enabled", false);
    set(crate, "max_speed", 2);
    set(crate, "sleep_speed", 0.5);
    set(shape_of(crate), "material", 7);
    set(shape_of(crate), "contact_events", false);
    step(20);
    const property::Snapshot after = tree.snapshot();
    step(20);
    const auto hash = physics.hash();
    tree.restore(before);
    CHECK(get(shelf, "enabled").boolean());
    CHECK(number(crate, "sleep_speed") == number(world(), "sleep_speed"));
    CHECK(get(shape_of(crate), "material").integer() == 0);
    step(60);
    CHECK(y(crate) > 3.9);
    tree.restore(after);
    CHECK_FALSE(get(shelf, "enabled").boolean());
    CHECK(number(crate, "max_speed") == 2);
    CHECK(number(crate, "sleep_speed") == 0.5);
    CHECK_FALSE(get(shape_of(crate), "contact_events").boolean());
    step(20);
    CHECK(physics.hash() == hash);
    CHECK(sound());
}

TEST_CASE_METHOD(Shelf, "a disabled body stays disabled on its way between worlds") {
    set(crate, "enabled", false);
    set(crate, "velocity", Vec2(0, 3));
    const Handle other = make("World", tree.root(), "other");
    tree.move(crate, other);
    step(10);
    CHECK(y(crate) == 4);
    CHECK(vec(crate, "velocity") == Vec2(0, 3));
    tree.move(crate, {});
    CHECK_FALSE(get(crate, "enabled").boolean());
    tree.move(crate, world());
    set(crate, "enabled", true);
    step(10);
    CHECK(y(crate) > 4.2);
    CHECK(sound());
    CHECK_FALSE(physics.world(other).validate());
}

TEST_CASE_METHOD(Shelf, "nil gives a body the sleep speed of its world again") {
    set(world(), "sleep_speed", 0.125);
    CHECK(number(crate, "sleep_speed") == 0.125);
    set(crate, "sleep_speed", 1);
    CHECK(number(crate, "sleep_speed") == 1);
    set(crate, "sleep_speed", Value());
    CHECK(number(crate, "sleep_speed") == 0.125);
}

}  // namespace disabled_test
