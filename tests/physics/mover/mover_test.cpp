#include <fettle/physics/mover.h>

#include <cmath>

#include "catch.h"
#include "scenes.h"

namespace mover_test {

using namespace scenes;

namespace {

Body add_static(World& world, const Geometry& geometry, const ShapeDef& surface = {}) {
    Body body = world.create_body({.type = BodyType::static_body});
    body.add(geometry, surface);
    return body;
}

/// A mover with gravity, as games use it.
struct Walker {
    World& world;
    Mover mover;
    Vec2 velocity = {};
    Moved last = {};
    bool crushed = false;

    Walker(World& in, const Vec2& position, const MoverDef& def = {})
        : world(in), mover(def, position) {}

    void step(float walk, int count = 1) {
        for (int i = 0; i < count; ++i) {
            velocity.x = walk;
            if (!mover.on_ground()) velocity.y -= 10.0f * frame;
            last = mover.move(world, velocity, frame);
            velocity = last.velocity;
            crushed |= last.crushed;
            world.step(frame);
        }
    }
    float x() const { return mover.position().x; }
    float y() const { return mover.position().y; }
};

float depth(const Walker& walker) {
    float least = 0.0f;
    for (const MoverPlane& plane : walker.mover.planes(walker.world, 0.0f))
        least = std::min(least, plane.separation);
    return -least;
}

}  // namespace

TEST_CASE("a mover falls onto the floor and stands clear of it") {
    World world;
    add_floor(world);
    Walker hero(world, {0, 2});
    hero.step(0, 120);
    CHECK(hero.last.on_ground);
    CHECK(hero.y() == Approx(0.01f).margin(0.006f));
    CHECK(hero.last.ground_normal.y == Approx(1.0f));
    CHECK(hero.last.motion.length() < 1e-4f);
}

TEST_CASE("a mover walks over the seams of tiles at constant speed") {
    World world;
    for (int i = -5; i < 40; ++i)
        add_static(world, Box{.width = 1, .height = 1, .center = {float(i), -0.5f}});
    Walker hero(world, {0, 0.01f});
    hero.step(0, 5);
    const float start = hero.x();
    for (int i = 0; i < 120; ++i) {
        hero.step(6);
        REQUIRE(hero.last.on_ground);
        REQUIRE(std::fabs(hero.y() - 0.01f) < 0.008f);
    }
    CHECK(hero.x() - start == Approx(12.0f).epsilon(0.002));
}

TEST_CASE("a mover walks up and down a slope along the ground and stands still on it") {
    World world;
    const float slope = 0.6f;
    add_static(world, Chain{.points = {{-20, 0}, {0, 0}, {10, 10 * std::tan(slope)}, {30, 7}}});
    Walker hero(world, {-1, 0.02f});
    hero.step(3, 120);
    CHECK(hero.last.on_ground);
    CHECK(hero.y() > 1.0f);
    CHECK(hero.last.motion.length() == Approx(3 * frame).epsilon(0.02));
    const float height = hero.y();
    hero.step(0, 60);
    CHECK(hero.y() == Approx(height).margin(0.01f));
    for (int i = 0; i < 40; ++i) {
        hero.step(-3);
        REQUIRE(hero.last.on_ground);
    }
    CHECK(hero.y() < height - 0.5f);
}

TEST_CASE("a mover neither climbs a slope that is too steep nor stands on it") {
    World world;
    add_floor(world);
    add_static(world, Polygon{.vertices = {{3, -1}, {8, -1}, {8, 9}}});
    Walker hero(world, {1, 0.01f});
    hero.step(4, 120);
    CHECK(hero.last.hit_wall);
    CHECK(hero.y() < 0.1f);
    Walker other(world, {6, 8});
    for (int i = 0; i < 180; ++i) other.step(other.velocity.x);
    CHECK(other.x() < 4.0f);
    CHECK(other.y() < 0.1f);
}

TEST_CASE("a mover climbs steps up to its step height only") {
    World world;
    add_floor(world);
    add_static(world, Box{.width = 4, .height = 0.25f, .center = {4, 0.125f}});
    add_static(world, Box{.width = 2, .height = 0.5f, .center = {5, 0.25f}});
    Walker hero(world, {1, 0.01f});
    hero.step(3, 100);
    CHECK(hero.y() == Approx(0.51f).margin(0.01f));
    World high;
    add_floor(high);
    add_static(high, Box{.width = 4, .height = 0.45f, .center = {4, 0.225f}});
    Walker low(high, {1, 0.01f});
    low.step(3, 100);
    CHECK(low.last.hit_wall);
    CHECK(low.y() < 0.02f);
    CHECK(low.x() < 1.7f);
}

TEST_CASE("the height of the steps that a mover climbs is true to a millimeter") {
    // Lower edges are slopes for the round foot.
    for (const float height : {0.2f, 0.3f, 0.6f})
        for (const float skin : {0.001f, 0.01f, 0.05f})
            for (const bool higher : {false, true})
                for (const float speed : {-3.0f, 0.1f, 0.5f, 9.0f}) {
                    World world;
                    add_floor(world);
                    const float step = height + (higher ? 0.001f : -0.001f);
                    add_static(world, Box{.width = 8,
                                          .height = step,
                                          .center = {speed > 0 ? 6.0f : -6.0f, 0.5f * step}});
                    Walker hero(world, {0, skin}, {.step_height = height, .skin = skin});
                    hero.step(speed, int(200 / std::fabs(speed)));
                    INFO("step height " << height << ", skin " << skin << ", higher " << higher
                                        << ", speed " << speed << ", at " << hero.y());
                    CHECK((hero.y() > 0.9f * step) == !higher);
                }
}

TEST_CASE("a mover descends steps without leaving the ground") {
    World world;
    for (int i = 0; i < 8; ++i)
        add_static(world,
                   Box{.width = 1, .height = 4, .center = {float(i), -2.0f - 0.2f * float(i)}});
    Walker hero(world, {0, 0.01f});
    hero.step(0, 5);
    for (int i = 0; i < 100; ++i) {
        hero.step(3);
        REQUIRE(hero.last.on_ground);
    }
    CHECK(hero.y() < -0.8f);
}

TEST_CASE("a jump leaves the ground and a ceiling ends it") {
    World world;
    add_floor(world);
    add_static(world, Box{.width = 4, .height = 1, .center = {0, 3}});
    Walker hero(world, {0, 0.01f});
    hero.step(0, 5);
    hero.velocity = {0, 8};
    hero.step(0);
    CHECK_FALSE(hero.last.on_ground);
    bool met = false;
    for (int i = 0; i < 60 && !met; ++i) {
        hero.step(0);
        met = hero.last.hit_ceiling;
    }
    CHECK(met);
    CHECK(hero.velocity.y <= 0.0f);
    CHECK(hero.y() + 1.8f < 2.5f);
}

TEST_CASE("a mover passes through a ledge from below and stands on it and drops through it") {
    for (const bool chain : {true, false}) {
        World world;
        add_floor(world);
        if (chain)
            add_static(world, Chain{.points = {{-2, 2}, {2, 2}}});
        else
            add_static(world, Box{.width = 4, .height = 0.2f, .center = {0, 1.9f}},
                       {.category = 2});
        MoverDef def;
        def.ledges = 2;
        Walker hero(world, {0, 0.01f}, def);
        hero.step(0, 5);
        CHECK_FALSE(hero.mover.drop(world));
        hero.velocity = {0, 8};
        hero.step(0, 120);
        CHECK(hero.y() == Approx(2.01f).margin(0.01f));
        REQUIRE(hero.mover.drop(world));
        hero.step(0, 90);
        CHECK(hero.y() == Approx(0.01f).margin(0.01f));
        hero.velocity = {0, 8};
        hero.step(0, 120);
        CHECK(hero.y() == Approx(2.01f).margin(0.01f));
    }
}

TEST_CASE("a mover rides platforms that move and turn") {
    World world;
    Body lift = world.create_body(
        {.type = BodyType::kinematic_body, .position = {0, 0}, .velocity = {2, 1.5f}});
    lift.add(Box{.width = 4, .height = 1, .center = {0, -0.5f}});
    Walker hero(world, {0.5f, 0.02f});
    hero.step(0, 10);
    const Vec2 place = hero.mover.position() - lift.position();
    for (int i = 0; i < 120; ++i) {
        hero.step(0);
        REQUIRE(hero.last.on_ground);
        REQUIRE((hero.mover.position() - lift.position() - place).length() < 0.01f);
    }
    CHECK(hero.last.ground_velocity.x == Approx(2.0f).epsilon(0.01));
    lift.set_velocity({0, -4});
    hero.step(0, 60);
    CHECK(hero.last.on_ground);
    CHECK(hero.y() - lift.position().y == Approx(0.01f).margin(0.01f));
    lift.set_velocity({0, 0});
    lift.set_angular_velocity(0.3f);
    const float arm = hero.x() - lift.position().x;
    hero.step(0, 60);
    CHECK(hero.last.on_ground);
    const Vec2 local = lift.local_point(hero.mover.position());
    CHECK(local.x == Approx(arm).margin(0.05f));
    CHECK(depth(hero) < 0.01f);
}

TEST_CASE("a conveyor belt carries a mover") {
    World world;
    add_floor(world, 50, {.surface_speed = -2});
    Walker hero(world, {0, 0.01f});
    hero.step(0, 70);
    CHECK(hero.x() == Approx(2.0f * 69 * frame).epsilon(0.05));
}

TEST_CASE("a segment of a chain with a speed of its own carries a mover") {
    World world;
    Shape ground = world.create_body({.type = BodyType::static_body})
                       .add(Chain{.points = {{-20, 0}, {0, 0}, {20, 0}}});
    SegmentSurface belt = surface_of_shape;
    belt.surface_speed = -2;
    ground.set_segment_surface(1, belt);
    Walker still(world, {-5, 0.01f}), carried(world, {5, 0.01f});
    still.step(0, 70);
    carried.step(0, 70);
    CHECK(still.x() == -5);
    CHECK(carried.x() == Approx(5 + 2.0f * 69 * frame).epsilon(0.02));
    CHECK(carried.mover.state().ground_part == 1);
    CHECK(carried.last.ground_velocity.x == Approx(2));
    ground.set_segment_surface(1, {});
    carried.step(0, 70);
    CHECK(carried.last.ground_velocity == Vec2{});
}

TEST_CASE("no belt carries a mover faster than a contact moves a body") {
    World world;
    add_floor(world, 50, {.surface_speed = 3e38f});
    Walker hero(world, {0, 0.01f});
    hero.step(0, 70);
    CHECK(std::isfinite(hero.x()));
    CHECK(hero.last.ground_velocity.length() <= 1e4f);
    CHECK_NOTHROW(Mover().set_state(hero.mover.state()));
}

TEST_CASE("a mover pushes a light crate and not a heavy one") {
    for (const bool heavy : {false, true}) {
        World world;
        add_floor(world);
        Body crate = add_box(world, {2, 0.5f}, 1.0f, {.density = heavy ? 4000.0f : 30.0f});
        Walker hero(world, {0, 0.01f});
        hero.step(2, 180);
        INFO("at " << hero.x() << " crate " << crate.position().x);
        if (heavy)
            CHECK(crate.position().x < 2.05f);
        else
            CHECK(crate.position().x > 4.0f);
        CHECK(crate.position().x - hero.x() > 0.85f);
        CHECK(crate.velocity().length() < 2.5f);
    }
}

TEST_CASE("a mover weighs on a dynamic plank") {
    World world;
    Body plank = world.create_body({.position = {0, 0}});
    plank.add(Box{.width = 4, .height = 0.2f}, {.density = 50});
    world.create_revolute_joint({.body_b = plank.id()});
    Walker hero(world, {1.2f, 0.11f});
    hero.step(0, 20);
    CHECK(plank.angle() < -0.02f);
}

TEST_CASE("a light crate rests below a heavy mover") {
    World world;
    add_floor(world);
    Body crate = world.create_body({.position = {0, 0.5f}});
    crate.add(Box{.width = 3, .height = 1});
    Walker hero(world, {0, 1.01f});
    hero.step(0, 120);
    CHECK(hero.last.on_ground);
    CHECK(crate.velocity().length() < 0.01f);
    CHECK(hero.last.ground_velocity.length() < 0.01f);
    CHECK(hero.y() - crate.position().y == Approx(0.505f).margin(0.01f));
    float force = 0;
    for (const Contact& contact : crate.contacts()) force += contact.normal_force;
    CHECK(force == Approx(10 * (80 + crate.mass())).epsilon(0.02));
}

TEST_CASE("a mover passes through a body that a joint keeps apart from its own") {
    World world;
    add_floor(world);
    Body wall = world.create_body({.type = BodyType::static_body, .position = {3, 1}});
    wall.add(Box{.width = 1, .height = 2});
    const Body own = world.create_body({.type = BodyType::kinematic_body});
    FilterJoint joint = world.create_filter_joint({.body_a = own.id(), .body_b = wall.id()});
    Walker hero(world, {0, 0.01f}, {.body = own.id()});
    hero.step(3, 120);
    CHECK(hero.x() > 5.0f);
    joint.destroy();
    hero.step(-3, 120);
    CHECK(hero.x() > 3.8f);
}

TEST_CASE("stairs are not a wall for a mover") {
    for (const float walk : {1.0f, 2.0f, 3.0f, 4.0f, 5.0f}) {
        World world;
        add_floor(world);
        for (int i = 1; i <= 12; ++i) {
            const auto n = static_cast<float>(i);
            Body stair = world.create_body({.type = BodyType::static_body});
            stair.add(Box{.width = 0.5f, .height = 0.2f * n, .center = {2 + 0.5f * n, 0.1f * n}});
        }
        Walker hero(world, {0, 0.01f});
        int walls = 0;
        while (hero.x() < 8.0f && hero.last.motion.x >= 0.0f && walls < 100) {
            hero.step(walk);
            walls += hero.last.hit_wall;
        }
        INFO("walks with " << walk);
        CHECK(walls == 0);
    }
}

TEST_CASE("a mover crouches and stands up only where there is room") {
    World world;
    add_floor(world);
    add_static(world, Box{.width = 4, .height = 1, .center = {4, 1.7f}});
    Walker hero(world, {0, 0.01f});
    hero.step(3, 100);
    CHECK(hero.x() < 2.0f);
    REQUIRE(hero.mover.set_height(world, 1.0f));
    hero.step(3, 30);
    CHECK(hero.x() > 2.2f);
    CHECK_FALSE(hero.mover.set_height(world, 1.8f));
    CHECK(hero.mover.definition().height == 1.0f);
    hero.step(3, 100);
    CHECK(hero.mover.set_height(world, 1.8f));
}

TEST_CASE("a mover that climbs is free of ground and steps") {
    World world;
    add_floor(world);
    Walker hero(world, {0, 0.01f});
    hero.step(0, 5);
    hero.mover.set_climbing(true);
    hero.last = hero.mover.move(world, {0, 2}, 0.5f);
    CHECK(hero.y() == Approx(1.01f).margin(0.01f));
    hero.last = hero.mover.move(world, {0, 0}, 0.5f);
    CHECK(hero.y() == Approx(1.01f).margin(0.01f));
    CHECK_FALSE(hero.last.on_ground);
}

TEST_CASE("a mover stands in a gap between two steep slopes") {
    World world;
    add_static(world, Polygon{.vertices = {{0, 0}, {-3, 9}, {-6, 9}, {-6, -1}}});
    add_static(world, Polygon{.vertices = {{0, 0}, {3, 9}, {6, 9}, {6, -1}}});
    Walker hero(world, {0.3f, 6});
    hero.step(0, 200);
    CHECK(hero.last.on_ground);
    CHECK(depth(hero) < 1e-3f);
    CHECK(hero.velocity.length() < 0.2f);
}

TEST_CASE("a fall at 300 meters a second ends on the thinnest floor") {
    World world;
    add_static(world, Segment{.from = {-5, 0}, .to = {5, 0}});
    add_static(world, Chain{.points = {{10, 0}, {20, 0}}});
    for (const float x : {0.0f, 15.0f}) {
        Walker hero(world, {x, 50});
        hero.velocity = {0, -300};
        hero.step(0, 30);
        CHECK(hero.last.on_ground);
        CHECK(hero.y() == Approx(0.01f).margin(0.01f));
    }
}

TEST_CASE("a press crushes a mover") {
    World world;
    add_floor(world);
    Body press = world.create_body(
        {.type = BodyType::kinematic_body, .position = {0, 4}, .velocity = {0, -1}});
    press.add(Box{.width = 3, .height = 1});
    Walker hero(world, {0, 0.01f});
    hero.step(0, 60);
    CHECK_FALSE(hero.crushed);
    hero.step(0, 120);
    CHECK(hero.crushed);
}

TEST_CASE("a fast pusher moves a mover in front of it") {
    World world;
    add_floor(world);
    Body pusher = world.create_body(
        {.type = BodyType::kinematic_body, .position = {-20, 1}, .velocity = {20, 0}});
    pusher.add(Box{.width = 1, .height = 1.5f});
    Walker other(world, {-17, 0.01f});
    other.step(0, 60);
    CHECK_FALSE(other.crushed);
    CHECK(other.x() > pusher.position().x + 0.89f);
}

TEST_CASE("the bounds of a world stop a mover") {
    World world({.bounds = Aabb{{-5, 0}, {5, 10}}});
    Walker hero(world, {0, 2});
    hero.step(6, 120);
    CHECK(hero.last.on_ground);
    CHECK(hero.last.hit_wall);
    CHECK(hero.x() == Approx(4.59f).margin(0.01f));
}

TEST_CASE("a mover passes through shapes outside of its mask and through its own body") {
    World world;
    add_floor(world);
    add_static(world, Box{.width = 1, .height = 1, .center = {2, 0.5f}}, {.category = 4});
    Body own = world.create_body({.type = BodyType::kinematic_body, .position = {0, 1}});
    own.add(Circle{});
    MoverDef def;
    def.mask = ~uint64_t{4};
    def.body = own.id();
    Walker hero(world, {0, 0.01f}, def);
    hero.step(3, 100);
    CHECK(hero.x() > 4.0f);
}

TEST_CASE("the plane solver finds the nearest allowed motion") {
    const MoverPlane both[] = {{{0, 1}, {0, 0}, 0.0f, {}}, {{-1, 0}, {0, 0}, 0.5f, {}}};
    CHECK(solve_planes({1, -1}, both) == Vec2(0.5f, 0));
    CHECK(solve_planes({0.2f, -1}, both) == Vec2(0.2f, 0));
    CHECK(solve_planes({0.2f, 1}, both) == Vec2(0.2f, 1));
    CHECK(clip_velocity({3, -4}, both) == Vec2(0, 0));
    const MoverPlane pressed[] = {{{0, 1}, {0, 0}, -0.2f, {}}, {{0, -1}, {0, 0}, -0.4f, {}}};
    CHECK(solve_planes({0, 0}, pressed).y == Approx(-0.1f).margin(0.01f));
}

TEST_CASE("a copy of a mover and of its world has the same future") {
    World world;
    add_floor(world);
    add_box(world, {2, 0.5f}, 1.0f, {.density = 30});
    Walker hero(world, {0, 1});
    hero.step(2, 50);
    World later = world.clone();
    Walker copy(later, {0, 0});
    copy.mover.set_definition(hero.mover.definition());
    copy.mover.set_state(hero.mover.state());
    copy.velocity = hero.velocity;
    hero.step(2, 50);
    copy.step(2, 50);
    CHECK(copy.mover.position() == hero.mover.position());
    CHECK(later.hash() == world.hash());
}

TEST_CASE("a mover refuses values out of range and changes nothing") {
    World world;
    REQUIRE_THROWS_AS(Mover({.radius = 0}), std::invalid_argument);
    REQUIRE_THROWS_AS(Mover({.radius = 1, .height = 1}), std::invalid_argument);
    REQUIRE_THROWS_AS(Mover({.max_slope = 2}), std::invalid_argument);
    REQUIRE_THROWS_AS(Mover({.skin = 0}), std::invalid_argument);
    REQUIRE_THROWS_AS(Mover({}, {NAN, 0}), std::invalid_argument);
    Mover hero({}, {1, 2});
    REQUIRE_THROWS_AS(hero.move(world, {NAN, 0}, frame), std::invalid_argument);
    REQUIRE_THROWS_AS(hero.set_height(world, 0.1f), std::invalid_argument);
    hero.move(world, {1, 0}, 0.0f);
    hero.move(world, {1, 0}, -1.0f);
    hero.move(world, {1, 0}, NAN);
    CHECK(hero.position() == Vec2(1, 2));
    hero.move(world, {1e30f, 0}, 1.0f);
    CHECK(std::isfinite(hero.position().x));
}

}  // namespace mover_test
