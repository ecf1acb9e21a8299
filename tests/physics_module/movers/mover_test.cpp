// Mover: a character in the tree.

#include <fettle/property/acceptance.h>

#include "catch.h"
#include "game.h"

namespace mover_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Occurrence;

namespace {

struct Scene : Game {
    std::vector<std::string> log;
    Handle hero = {};

    Scene() {
        floor();
        hero = make("Mover", world(), {{"position", Vec2(0, 0.01)}});
        step(5);
    }
    void listen(const char* name) {
        tree.on(hero, *tree.class_of(hero).event(name),
                [this](const Occurrence& o) { log.push_back(o.event->name); });
    }
    bool flag(const char* name) const { return get(hero, name).boolean(); }
};
using Log = std::vector<std::string>;

}  // namespace

TEST_CASE_METHOD(Scene, "a mover stands on the floor and names it as its ground") {
    CHECK(flag("on_ground"));
    CHECK(get(hero, "ground").reference() == tree.child(world(), "body_1"));
    CHECK(vec(hero, "ground_normal").y == Approx(1));
    CHECK(get(hero, "type").text() == "kinematic");
    CHECK(y(hero) == Approx(0.01).margin(0.006));
}

TEST_CASE_METHOD(
    Scene, "a search calls its function with the mover when it finds the capsule of the mover") {
    std::vector<Handle> filtered;
    property::Acceptance accept(tree, "raycast", [&](Handle instance) {
        filtered.push_back(instance);
        return instance != hero;
    });
    const Value from(Vec2(-1, 1)), to(Vec2(1, 1));
    const property::Result found =
        tree.call(world(), "raycast", {from, to, Value(), Value(), Value(true)});
    accept.finish();
    CHECK(filtered == std::vector<Handle>{hero});
    CHECK(std::get<Value>(found).is_nil());
}

TEST_CASE_METHOD(Scene, "a mover walks and jumps and lands") {
    for (const char* name : {"left_ground", "landed", "bumped"}) listen(name);
    set(hero, "walk", 3);
    step(60);
    CHECK(x(hero) > 2.5);
    CHECK(vec(hero, "velocity").x == Approx(3).epsilon(0.01));
    CHECK(log.empty());
    tree.call(hero, "jump", {Value(6.0)});
    step(20);
    CHECK_FALSE(flag("on_ground"));
    CHECK(y(hero) > 1);
    step(100);
    CHECK(flag("on_ground"));
    CHECK(log == Log{"left_ground", "landed"});
}

TEST_CASE_METHOD(Scene, "a written velocity throws a mover") {
    set(hero, "velocity", Vec2(0, 8));
    step(10);
    CHECK(y(hero) > 0.8);
    step(110);
    CHECK(flag("on_ground"));
    set(hero, "position", Vec2(4, 5));
    step(2);
    CHECK_FALSE(flag("on_ground"));
    CHECK(y(hero) > 4.9);
}

TEST_CASE_METHOD(Scene, "a mover bumps against a wall once and its event names the wall") {
    const Handle wall = body("Box", {2, 0.5}, "static");
    Handle other = {};
    tree.on(hero, *tree.class_of(hero).event("bumped"), [&](const Occurrence& o) {
        log.push_back("bumped");
        other = o.record.get("other").reference();
        CHECK(o.record.get("other_shape") == shape_of(wall));
        CHECK(o.record.get("normal").vec2().x == Approx(-1));
    });
    set(hero, "walk", 3);
    step(90);
    CHECK(log == Log{"bumped"});
    CHECK(other == wall);
    CHECK(flag("on_wall"));
    CHECK(x(hero) < 1.1);
}

TEST_CASE_METHOD(Scene, "a mover rides a lift and keeps its velocity when it jumps") {
    const Handle lift = body("Box", {10, 2}, "kinematic");
    set(shape_of(lift), "width", 4);
    set(hero, "position", Vec2(10, 2.51));
    step(10);
    set(lift, "velocity", Vec2(-2, 1));
    step(60);
    CHECK(flag("on_ground"));
    CHECK(vec(hero, "ground_velocity").x == Approx(-2));
    CHECK(x(hero) - x(lift) == Approx(0).margin(0.08));
    CHECK(y(hero) - y(lift) == Approx(0.51).margin(0.01));
    set(hero, "air_acceleration", 0);
    tree.call(hero, "jump", {Value(5.0)});
    step(20);
    CHECK(vec(hero, "velocity").x == Approx(-2).epsilon(0.05));
}

TEST_CASE_METHOD(Scene, "a mover that jumps on a moving platform lands where it began") {
    const Handle train = body("Box", {0, 5}, "kinematic");
    set(shape_of(train), "width", 100);
    for (const double speed : {-20.0, 2.0, 20.0}) {
        set(train, "velocity", Vec2(0, 0));
        set(hero, "position", Vec2(x(train), 5.51));
        step(10);
        set(train, "velocity", Vec2(speed, 0));
        step(40);
        const double before = x(hero) - x(train);
        tree.call(hero, "jump", {Value(7.0)});
        step(30);
        INFO("speed " << speed);
        CHECK_FALSE(flag("on_ground"));
        CHECK(vec(hero, "velocity").x == Approx(speed).epsilon(0.01));
        step(70);
        CHECK(flag("on_ground"));
        CHECK(x(hero) - x(train) == Approx(before).margin(0.1));
    }
}

TEST_CASE_METHOD(Scene, "a mover in the air walks relative to the ground that it left") {
    const Handle train = body("Box", {0, 5}, "kinematic");
    set(shape_of(train), "width", 100);
    set(train, "velocity", Vec2(10, 0));
    set(hero, "position", Vec2(0, 5.51));
    set(hero, "walk", -3);
    step(40);
    tree.call(hero, "jump", {Value(7.0)});
    step(30);
    CHECK(vec(hero, "velocity").x == Approx(7).epsilon(0.01));
    set(hero, "walk", 3);
    step(30);
    CHECK(vec(hero, "velocity").x == Approx(13).epsilon(0.01));
    step(60);
    CHECK(flag("on_ground"));
    CHECK(vec(hero, "velocity").x == Approx(13).epsilon(0.01));
}

TEST_CASE_METHOD(Scene, "a wall ends the speed of the ground that a mover left") {
    const Handle platform = body("Box", {0, 5}, "kinematic");
    set(shape_of(platform), "width", 4);
    const Handle wall = body("Box", {6, 6}, "static");
    set(shape_of(wall), "height", 4);
    set(platform, "velocity", Vec2(6, 0));
    set(hero, "position", Vec2(0, 5.51));
    step(10);
    set(platform, "velocity", Vec2(0, 0));
    tree.call(hero, "jump", {Value(5.0)});
    set(hero, "velocity", Vec2(6, 5));
    step(90);
    CHECK(x(hero) < 5.2);
    CHECK(vec(hero, "velocity").x == Approx(0).margin(0.01));
}

TEST_CASE_METHOD(Scene, "a mover crouches and stands up where there is room") {
    const Handle ceiling = body("Box", {4, 2}, "static");
    set(shape_of(ceiling), "width", 3);
    set(hero, "crouch", true);
    set(hero, "walk", 3);
    step(80);
    CHECK(flag("crouched"));
    CHECK(x(hero) > 3);
    set(hero, "crouch", false);
    CHECK(flag("crouched"));
    step(80);
    CHECK_FALSE(flag("crouched"));
}

TEST_CASE_METHOD(Scene, "a mover drops through a ledge") {
    const Handle ledge = body("Box", {0, 3}, "static");
    set(shape_of(ledge), "category", 2);
    CHECK_FALSE(std::get<Value>(tree.call(hero, "drop", {})).boolean());
    set(hero, "ledges", 2);
    set(hero, "position", Vec2(0, 3.6));
    step(30);
    CHECK(y(hero) == Approx(3.51).margin(0.01));
    CHECK(std::get<Value>(tree.call(hero, "drop", {})).boolean());
    step(80);
    CHECK(y(hero) == Approx(0.01).margin(0.01));
}

TEST_CASE_METHOD(Scene, "a mover that is turned walks on a wall") {
    const Handle wall = body("Box", {6, 5}, "static");
    set(shape_of(wall), "height", 40.0);
    set(world(), "gravity", Vec2(10, 0));
    set(hero, "position", Vec2(4, 5));
    set(hero, "angle", 1.5707963);
    set(hero, "walk", 2);
    step(90);
    CHECK(flag("on_ground"));
    CHECK(get(hero, "ground").reference() == wall);
    CHECK(vec(hero, "ground_normal").x == Approx(-1));
    CHECK(x(hero) == Approx(5.495).margin(0.006));
    CHECK(y(hero) > 7);
}

TEST_CASE_METHOD(Scene, "a sensor and a query find a mover") {
    const Handle zone = body("Box", {0, 1}, "static");
    set(shape_of(zone), "sensor", true);
    int entered = 0;
    tree.on(zone, *tree.class_of(zone).event("sensor_begin"), [&](const Occurrence& o) {
        ++entered;
        CHECK(o.record.get("other") == hero);
        CHECK(o.record.get("other_shape") == Value(Handle{}));
    });
    step(5);
    CHECK(entered == 1);
    const auto hit = tree.call(world(), "raycast", {Vec2(-5, 1), Vec2(5, 1)});
    CHECK(std::get<property::Record>(hit).get("body") == hero);
}

TEST_CASE_METHOD(Scene, "a dynamic mover is a body like others") {
    set(hero, "type", "dynamic");
    set(hero, "walk", 3);
    set(hero, "angular_velocity", 1.0);
    step(120);
    CHECK_FALSE(flag("on_ground"));
    CHECK(std::abs(number(hero, "angle")) > 1);
}

TEST_CASE_METHOD(Scene, "a press crushes a mover") {
    listen("crushed");
    const Handle press = body("Box", {0, 4}, "kinematic");
    set(press, "velocity", Vec2(0, -1));
    step(200);
    CHECK(log == Log{"crushed"});
}

TEST_CASE_METHOD(Scene, "a mover leaves the ground when gravity turns upwards") {
    listen("left_ground");
    const double strength = GENERATE(1.0, 10.0);
    set(world(), "gravity", Vec2(0, strength));
    step(60);
    CHECK(log == Log{"left_ground"});
    CHECK_FALSE(flag("on_ground"));
    CHECK(y(hero) == Approx(0.5 * strength).epsilon(0.1));
    set(world(), "gravity", Vec2(0, -10));
    step(200);
    CHECK(flag("on_ground"));
}

TEST_CASE_METHOD(Scene, "a sensor without events does not report a mover") {
    const Handle zone = body("Box", {0, 1}, "static");
    set(shape_of(zone), "sensor", true);
    set(shape_of(zone), "sensor_events", false);
    listen("sensor_begin");
    listen("sensor_end");
    step(5);
    CHECK(log.empty());
    set(shape_of(zone), "sensor_events", true);  // from the next touch on
    step(5);
    CHECK(log.empty());
    set(zone, "position", Vec2(0, 50));
    step(2);
    set(zone, "position", Vec2(0, 1));
    step(2);
    CHECK(log == Log{"sensor_begin"});
}

TEST_CASE_METHOD(Scene, "a disabled mover does not move and reports no events") {
    for (const char* event : {"landed", "left_ground", "bumped", "crushed"}) listen(event);
    set(hero, "walk", 3);
    step(5);
    set(hero, "enabled", false);
    const Vec2 there = vec(hero, "position");
    step(60);
    CHECK(log.empty());
    CHECK_FALSE(flag("on_ground"));
    CHECK(vec(hero, "position") == there);
    set(hero, "enabled", true);
    step(30);
    CHECK(flag("on_ground"));
    CHECK(vec(hero, "position").x > there.x + 1);
}

TEST_CASE_METHOD(Scene, "a restored mover has the same future") {
    const Handle crate = body("Box", {2, 0.5});
    set(shape_of(crate), "density", 30);
    set(hero, "walk", 2);
    tree.call(hero, "jump", {Value(4.0)});
    step(20);
    const property::Snapshot snapshot = tree.snapshot();
    step(100);
    const Vec2 there = vec(hero, "position");
    const auto hash = physics.hash();
    set(hero, "crouch", true);
    step(30);
    tree.restore(property::Snapshot::from_bytes(snapshot.to_bytes()));
    CHECK_FALSE(flag("crouched"));
    step(100);
    CHECK(vec(hero, "position") == there);
    CHECK(physics.hash() == hash);
}

TEST_CASE_METHOD(Scene, "a mover moves to another world and out of all worlds") {
    const Handle other = make("World", tree.root());
    set(hero, "height", 1.2);
    tree.move(hero, other);
    step(30);
    CHECK(number(hero, "height") == Approx(1.2));
    CHECK(y(hero) < -0.5);
    CHECK_FALSE(flag("on_ground"));
    tree.move(hero, Handle{});
    step(3);
    set(hero, "radius", 0.3);
    CHECK(number(hero, "radius") == Approx(0.3));
    tree.move(hero, world());
    set(hero, "position", Vec2(0, 1));
    step(60);
    CHECK(flag("on_ground"));
    tree.destroy(hero);
    step(3);
}

TEST_CASE_METHOD(Scene, "a handler may delete the mover") {
    tree.on(hero, *tree.class_of(hero).event("left_ground"),
            [&](const Occurrence&) { tree.destroy(hero); });
    tree.call(hero, "jump", {Value(5.0)});
    step(3);
    CHECK_FALSE(tree.alive(hero));
}

}  // namespace mover_test
