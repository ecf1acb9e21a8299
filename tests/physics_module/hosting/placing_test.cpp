// Instances are created without a world, enter one, move to another and leave it.

#include <cmath>
#include <limits>

#include <fettle/property/storage/scene.h>

#include "catch.h"
#include "game.h"

namespace placing_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Property;

namespace {

/// All writable values of an instance by name.
std::vector<std::pair<std::string, Value>> written_values(const Game& game, Handle of) {
    std::vector<std::pair<std::string, Value>> values;
    for (const Property* property : game.tree.class_of(of).properties())
        if (!property->read_only && property->owner != &game.tree.object_class())
            values.emplace_back(property->name, game.tree.get(of, *property));
    return values;
}

struct Travellers : Game {
    Handle crate = make("Body", {},
                        {{"position", Vec2(1, 2)},
                         {"angle", 0.3},
                         {"velocity", Vec2(3, 4)},
                         {"angular_velocity", 0.5},
                         {"force", Vec2(1, 0)},
                         {"torque", 0.25},
                         {"gravity_scale", 0.5},
                         {"linear_damping", 0.1},
                         {"angular_damping", 0.2},
                         {"can_sleep", false},
                         {"sleep_speed", 0.25},
                         {"max_speed", 128},
                         {"bullet", true},
                         {"locked_x", true},
                         {"color", property::Color{1, 0, 0, 1}}});
    Handle box = make("Box", crate,
                      {{"width", 2},
                       {"height", 1},
                       {"center", Vec2(0.2, 0.1)},
                       {"angle", 0.1},
                       {"rounding", 0.05},
                       {"density", 3},
                       {"friction", 0.2},
                       {"restitution", 0.7},
                       {"rolling_resistance", 0.01},
                       {"surface_speed", 0.3},
                       {"category", 4},
                       {"mask", 6},
                       {"group", -5},
                       {"material", 300},
                       {"contact_events", false},
                       {"sensor_events", false},
                       {"visible", false},
                       {"border", property::Color{0, 0, 1, 1}}});
    Handle circle = make("Circle", crate,
                         {{"radius", 0.3}, {"center", Vec2(1, 1)}, {"orientation_mark", true}});
    Handle hull = make("Polygon", crate,
                       {{"vertices", List{Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(1, 3)}},
                        {"sensor", true},
                        {"rounding", 0.1}});
    Handle segment =
        make("Segment", crate, {{"from", Vec2(0, 1)}, {"to", Vec2(3, 1)}, {"density", 2}});
    Handle capsule = make("Capsule", crate, {{"radius", 0.4}});

    auto everything() {
        std::vector<std::vector<std::pair<std::string, Value>>> all;
        for (const Handle h : {crate, box, circle, hull, segment, capsule})
            all.push_back(written_values(*this, h));
        return all;
    }
    bool native_in(Handle world) {
        for (const Handle h : {box, circle, hull, segment, capsule}) {
            const physics::Shape shape = physics.shape(h);
            if (&shape.world() != &physics.world(world) || shape.body() != physics.body(crate))
                return false;
            if (physics.handle(shape) != h) return false;
        }
        return &physics.body(crate).world() == &physics.world(world) &&
               physics.handle(physics.body(crate)) == crate &&
               physics.body(crate).shape_count() == 5;
    }
};

}  // namespace

TEST_CASE_METHOD(Travellers, "a body made without a world keeps everything when it enters one") {
    set(crate, "locked_x", false);
    const auto before = everything();
    const double mass = number(crate, "mass");
    tree.move(crate, world(), "crate");
    CHECK(everything() == before);
    CHECK(number(crate, "mass") == mass);
    CHECK(native_in(world()));
    CHECK(get(circle, "color").color() == property::Color{1, 0, 0, 1});
    step();
    CHECK_FALSE(vec(crate, "position") == Vec2(1, 2));
    CHECK_FALSE(physics.world(world()).validate());
}

TEST_CASE_METHOD(Travellers, "a body keeps everything when it moves to another world") {
    const Handle second = make("World", tree.root(), "second");
    tree.move(crate, world(), "crate");
    step(10);
    const auto before = everything();
    tree.move(crate, second);
    CHECK(everything() == before);
    CHECK(native_in(second));
    CHECK(physics.world(world()).body_count() == 0);
    CHECK(physics.world(world()).shape_count() == 0);
    step(10);
    CHECK_FALSE(everything() == before);
    for (const Handle w : {world(), second}) CHECK_FALSE(physics.world(w).validate());
}

TEST_CASE_METHOD(Travellers, "a body taken out of its world stands still and continues later") {
    tree.move(crate, world(), "crate");
    step(10);
    tree.move(crate, {});
    const auto before = everything();
    step(20);
    CHECK(everything() == before);
    set(crate, "mass", 12);
    CHECK(number(crate, "mass") == 12);
    tree.move(crate, world(), "crate");
    CHECK(number(crate, "mass") == 12);
    step(1);
    CHECK_FALSE(everything() == before);
}

TEST_CASE_METHOD(Travellers,
                 "overridden mass and inertia and center move to another world as overrides") {
    set(crate, "mass", 5);
    set(crate, "center", Vec2(0.5, 0.5));
    tree.move(crate, world(), "crate");
    set(box, "density", 9);
    CHECK(number(crate, "mass") == 5);
    CHECK(vec(crate, "center") == Vec2(0.5, 0.5));
    const double inertia = number(crate, "inertia");
    set(crate, "inertia", inertia);
    tree.move(crate, {});
    set(box, "density", 1);
    CHECK(number(crate, "inertia") == inertia);
    set(crate, "mass", Value());
    CHECK(number(crate, "mass") != 5);
}

TEST_CASE_METHOD(Game, "a body is in the world of the nearest World above it") {
    const Handle group = make("Object", world(), "group");
    const Handle ball = make("Body", group, "ball");
    CHECK(&physics.body(ball).world() == &physics.world(world()));
    const Handle inner = make("World", group, "inner");
    tree.move(ball, inner);
    CHECK(&physics.body(ball).world() == &physics.world(inner));
    step();
    CHECK(y(ball) < 0);
    // The whole group leaves the world: inner worlds move with it and stop.
    tree.move(group, {});
    const double height = y(ball);
    step(5);
    CHECK(y(ball) == height);
    tree.move(group, tree.root(), "group");
    step(5);
    CHECK(y(ball) < height);
}

TEST_CASE_METHOD(Game, "a group of bodies enters the world with all that is in it") {
    const Handle group = make("Object", {}, "group");
    std::vector<Handle> bodies;
    for (int i = 0; i < 5; ++i) {
        bodies.push_back(make("Body", group, {{"position", Vec2(3.0 * i, 5)}}));
        make("Circle", make("Object", bodies.back()));  // a shape need not be a direct child
    }
    step();
    CHECK(y(bodies[0]) == 5);
    tree.move(group, world(), "group");
    step();
    for (const Handle b : bodies) {
        CHECK(y(b) < 5);
        CHECK(physics.body(b).shape_count() == 1);
    }
}

TEST_CASE_METHOD(Game,
                 "a chain keeps the surfaces of its segments when it moves to another world") {
    const double same = std::numeric_limits<double>::infinity();
    const Handle ground = make("Body", world(), {{"type", "static"}});
    const List points = {Vec2(0, 0), Vec2(5, 0), Vec2(9, 0)};
    const Handle chain = make("Chain", ground, {{"points", points}});
    CHECK(get(chain, "segment_friction") == List{});
    set(chain, "segment_friction", List{same, 0.25});
    set(chain, "segment_material", List{7, -1});
    const auto check = [&] {
        CHECK(get(chain, "segment_friction") == List{same, 0.25});
        CHECK(get(chain, "segment_material") == List{7});
        CHECK(get(chain, "segment_restitution") == List{});
    };
    check();
    tree.move(ground, make("World", tree.root(), "second"));
    check();
    const property::Snapshot before = tree.snapshot();
    set(chain, "segment_friction", List{});
    set(chain, "segment_material", List{});
    CHECK_FALSE(physics.shape(chain).segment_surface_override(0));
    tree.restore(before);
    tree.barrier();
    check();
    CHECK_THROWS_WITH(set(chain, "segment_friction", List{1, 1, 1}),
                      contains("at most 2 values, one for each segment"));
    CHECK_THROWS_WITH(set(chain, "segment_restitution", List{2}), contains("restitution"));
    CHECK_THROWS_AS(set(chain, "segment_material", List{65535}), property::Error);
    check();
}

TEST_CASE_METHOD(Game, "a shape moves from body to body") {
    const Handle a = body("Box", {0, 5}), b = body("Box", {5, 5});
    const Handle box = shape_of(a);
    tree.move(box, b, "second");
    CHECK(physics.body(a).shape_count() == 0);
    CHECK(physics.body(b).shape_count() == 2);
    CHECK(number(b, "mass") == Approx(2));
    CHECK(number(a, "mass") == 1);  // it has no shapes
    const Handle elsewhere = make("World", tree.root(), "elsewhere");
    const Handle c = make("Body", elsewhere);
    set(box, "friction", 0.125);
    tree.move(box, c);
    CHECK(number(c, "mass") == Approx(1));
    CHECK(number(box, "friction") == 0.125);
    CHECK(physics.shape(box).body() == physics.body(c));
    tree.move(box, {});
    CHECK_FALSE(physics.shape(box).body());
    CHECK(number(box, "area") == Approx(1));
    set(box, "width", 3);
    CHECK(number(box, "area") == Approx(3));
}

TEST_CASE_METHOD(Game, "a shape without a body exists and collides with nothing") {
    const Handle loose = make("Box", world(), "loose");
    const Handle ball = body("Circle", {0, 3});
    step(60);
    CHECK(y(ball) < -1);
    CHECK(get(loose, "world_vertices").list().size() == 4);
    CHECK(physics.world(world()).shape_count() == 1);
}

TEST_CASE_METHOD(Game, "worlds are independent of each other") {
    const Handle moon = make("World", tree.root(), "moon");
    set(moon, "gravity", Vec2(0, -1.6));
    const Handle here = body("Circle", {0, 10});
    const Handle there = make("Body", moon, {{"position", Vec2(0, 10)}});
    make("Circle", there);
    step(30);
    CHECK(vec(here, "velocity").y == Approx(-5).epsilon(1e-4));
    CHECK(vec(there, "velocity").y == Approx(-0.8).epsilon(1e-4));
    CHECK(get(tree.child(moon, "step"), "bodies").integer() == 1);
    tree.destroy(moon);
    CHECK_FALSE(tree.alive(there));
    step(5);
    // The next world gets the same number, but no object of the old one.
    const Handle mars = make("World", tree.root(), "mars");
    CHECK(vec(mars, "gravity") == Vec2(0, -10));
    CHECK(physics.world(mars).body_count() == 0);
}

TEST_CASE_METHOD(
    Game, "creating more than the maximal number of worlds is refused and leaves no instance") {
    std::vector<Handle> worlds;
    const std::size_t before = tree.size();
    std::string refusal;
    for (int i = 0; i < 300 && refusal.empty(); ++i) {
        try {
            worlds.push_back(make("World", tree.root()));
        } catch (const property::Error& error) {
            refusal = error.what();
        }
    }
    CHECK_THAT(refusal, contains("255 worlds"));
    CHECK(tree.size() == before + 2 * worlds.size());
    step();
    for (const Handle w : worlds) tree.destroy(w);
    CHECK(tree.size() == before);
    CHECK_NOTHROW(make("World", tree.root()));
}

TEST_CASE_METHOD(Game, "a sleeping body still sleeps after moving to another world") {
    floor();
    const Handle ball = body("Circle", {0, 0.5});
    REQUIRE(falls_asleep(ball));
    const Handle second = make("World", tree.root(), "second");
    tree.move(ball, second);
    CHECK_FALSE(awake(ball));
    const double height = y(ball);
    step(10);
    CHECK(y(ball) == height);
    set(ball, "awake", true);
    step(10);
    CHECK(y(ball) < height);
}

TEST_CASE_METHOD(
    Game,
    "a spinning body whose center of mass is not its origin keeps its velocity when it is placed") {
    const Handle wheel = make("Body", {}, {{"velocity", Vec2(1, 2)}, {"angular_velocity", 5}});
    const Handle rim = make("Circle", wheel, {{"center", Vec2(1, 0)}});
    CHECK(vec(wheel, "velocity") == Vec2(1, 2));
    tree.move(wheel, world(), "wheel");
    CHECK(vec(wheel, "velocity") == Vec2(1, 2));
    tree.move(wheel, {});
    set(rim, "center", Vec2(0, 3));
    tree.call(wheel, "apply_impulse", {Vec2(0, 0)});
    CHECK(vec(wheel, "velocity") == Vec2(1, 2));
    set(wheel, "type", "static");
    CHECK(vec(wheel, "velocity") == Vec2(0, 0));
    set(wheel, "type", "dynamic");
    set(wheel, "velocity", Vec2(1, 2));
    set(wheel, "angular_velocity", 5);
    tree.move(wheel, world(), "wheel");
    CHECK(vec(wheel, "velocity") == Vec2(1, 2));
    CHECK(number(wheel, "angular_velocity") == 5);
}

TEST_CASE_METHOD(Game, "a class derived from Body or from a shape is hosted like its base") {
    property::ClassDescriptor ball;
    ball.name = "Ball";
    ball.base = "Body";
    ball.properties = {{.name = "mass", .default_value = 4},
                       {.name = "color", .default_value = property::Color{1, 0, 0, 1}},
                       {.name = "lives", .type = property::Type::integer, .default_value = 3}};
    tree.define(ball);
    property::ClassDescriptor wheel;
    wheel.name = "Wheel";
    wheel.base = "Circle";
    wheel.properties = {{.name = "radius", .default_value = 2}};
    tree.define(wheel);
    const Handle made = make("Ball", world(), "ball");
    const Handle rim = make("Wheel", made);
    CHECK(number(made, "mass") == 4);
    CHECK(number(rim, "area") == Approx(4 * 3.14159265));
    CHECK(get(rim, "color").color() == property::Color{1, 0, 0, 1});
    CHECK(get(made, "lives").integer() == 3);
    step(10);
    CHECK(y(made) < 0);
}

TEST_CASE_METHOD(Game, "the saved values of a body are those that differ from the defaults") {
    const Handle ground = floor();
    step();
    std::vector<std::string> names;
    for (const Property* property : tree.class_of(ground).properties())
        if (!property->read_only && tree.overridden(ground, *property))
            names.push_back(property->name);
    CHECK(names == std::vector<std::string>{"type", "position"});
}

TEST_CASE_METHOD(Travellers, "a scene file restores bodies and shapes and joints") {
    const Handle group = make("Object", world(), "group");
    tree.move(crate, group, "crate");
    set(crate, "mass", 8);
    make("MouseJoint", group, {{"body", crate}, {"target", Vec2(1, 8)}});
    const Handle ground = floor();
    tree.move(ground, group, "ground");
    const std::string text = property::scene_text(tree, group);

    Game other;
    const Handle loaded = property::load_scene_text(other.tree, text, "test.json", other.world());
    CHECK(property::scene_text(other.tree, loaded) == text);
    step(40);
    other.step(40);
    CHECK(physics.hash() == other.physics.hash());
}

TEST_CASE_METHOD(Game, "statistics belong to their world and are deleted with it") {
    const Handle second = make("World", tree.root(), "second");
    const Handle statistics = tree.child(second, "step");
    CHECK_THROWS_AS(tree.move(statistics, tree.root(), "numbers"), property::Error);
    CHECK_THROWS_AS(tree.move(statistics, {}), property::Error);
    CHECK_THROWS_AS(tree.rename(statistics, "numbers"), property::Error);
    CHECK(tree.child(second, "step") == statistics);
    tree.destroy(second);
    step();
    CHECK_FALSE(tree.alive(statistics));
}

TEST_CASE_METHOD(
    Game, "an instance that does nothing where it is placed is reported once for each kind") {
    std::vector<std::string> reports;
    physics.on_problem([&](const std::string& text) { reports.push_back(text); });
    make("Body", Handle{}, "kept");  // may get its place later
    const Handle ball = make("Body", tree.root(), "ball");
    step();
    REQUIRE(reports.size() == 1);
    CHECK_THAT(reports[0], contains("ball is below no World, so it takes part in no step"));
    const Handle late = make("Body", tree.root(), "late");
    tree.move(late, world());
    make("Body", tree.root(), "other");
    step();
    CHECK(reports.size() == 1);
    const Handle circle = make("Circle", world(), "circle");
    make("Box", world(), "box");
    const Handle moved = make("Circle", world(), "moved");
    tree.move(moved, ball);
    step(2);
    REQUIRE(reports.size() == 2);
    CHECK_THAT(reports[1],
               contains("world.circle (with 1 more) is on no Body, so nothing touches it"));
    tree.move(circle, ball);
    step();
    CHECK(reports.size() == 2);
    const Handle rod = make("DistanceJoint", world(), "rod");
    tree.set(rod, "body_b", late);  // in the same frame
    step();
    CHECK(reports.size() == 2);
    make("WeldJoint", world(), "weld");
    step(2);
    REQUIRE(reports.size() == 3);
    CHECK_THAT(reports[2], contains("world.weld does nothing: its body_a and body_b are the same"));
    const Handle pin = make("RevoluteJoint", world(), "pin");
    tree.set(pin, "body_b", late);
    tree.set(pin, "lower_angle", 0.5);
    tree.set(pin, "upper_angle", 1.0);
    step();
    CHECK(reports.size() == 3);
    const Handle slide = make("PrismaticJoint", world(), "slide");
    tree.set(slide, "body_b", late);
    tree.set(slide, "lower_translation", 2.5);
    tree.set(slide, "upper_translation", 1.0);
    step(2);
    REQUIRE(reports.size() == 4);
    CHECK_THAT(reports[3], contains("world.slide has lower_translation = 2.5: expected at most "
                                    "upper_translation, which is 1"));
}

TEST_CASE_METHOD(Game, "limits that cross during the run are reported for every type of joint") {
    struct Limits {
        std::string type, lower, upper;
    };
    const auto [type, lower, upper] =
        GENERATE(Limits{"RevoluteJoint", "lower_angle", "upper_angle"},
                 Limits{"RotaryLimitJoint", "lower_angle", "upper_angle"},
                 Limits{"PrismaticJoint", "lower_translation", "upper_translation"},
                 Limits{"PinSlotJoint", "lower_translation", "upper_translation"},
                 Limits{"WheelJoint", "lower_translation", "upper_translation"},
                 Limits{"DistanceJoint", "min_length", "max_length"});
    CAPTURE(type);
    std::vector<std::string> reports;
    physics.on_problem([&](const std::string& text) { reports.push_back(text); });
    const Handle ball = make("Body", world(), "ball");
    const Handle joint = make(type.c_str(), world(), "joint");
    tree.set(joint, "body_b", ball);
    step();
    tree.set(joint, lower, 3.0);
    tree.set(joint, upper, 2.0);  // only in between
    tree.set(joint, upper, 4.0);
    step(2);
    CHECK(reports.empty());
    tree.set(joint, upper, 1.0);
    tree.set(joint, lower, 2.5);
    step(2);
    REQUIRE(reports.size() == 1);
    CHECK(reports[0] == "world.joint has " + lower + " = 2.5: expected at most " + upper +
                            ", which is 1 and is used for both");
}

TEST_CASE_METHOD(Game, "no instance of an abstract class is made") {
    const property::Snapshot before = tree.snapshot();
    for (const char* name : {"Shape", "Joint", "PairJoint", "Field"}) {
        INFO(name);
        for (const Handle parent : {world(), Handle{}})
            REQUIRE_THROWS_WITH(make(name, parent),
                                contains(std::string(name) + ": it cannot be made"));
    }
    REQUIRE_NOTHROW(tree.restore(tree.snapshot()));
    REQUIRE_NOTHROW(tree.restore(before));
}

}  // namespace placing_test
