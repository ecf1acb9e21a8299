#include <fettle/physics/mover.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "catch.h"
#include "scenes.h"

namespace mover_leaving_test {

// What becomes of the velocity of the ground when a mover leaves it, and when it lands.

using namespace scenes;

namespace {

/// A platform or a cabin that moves, and a mover on it with the velocity that `move` returned.
struct Ride {
    World world;
    Body carrier = world.create_body({.type = BodyType::kinematic_body});
    Mover mover{{}, {0, 0.01f}};
    Vec2 velocity = {};
    Moved last = {};

    explicit Ride(float half_width, const Vec2& speed) {
        carrier.add(Box{.width = 2 * half_width, .height = 0.2f, .center = {0, -0.1f}});
        carrier.set_velocity(speed);
        step(60);
    }
    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            if (!mover.on_ground()) velocity.y -= 10.0f * frame;
            last = mover.move(world, velocity, frame);
            velocity = last.velocity;
            world.step(frame);
        }
    }
    float place() const { return float(mover.position().x - carrier.position().x); }
};

}  // namespace

TEST_CASE("a mover that jumps on a moving platform lands where it began") {
    for (const float speed : {-20.0f, -2.0f, 0.0f, 2.0f, 20.0f}) {
        INFO("speed " << speed);
        Ride ride(40, {speed, 0});
        const float before = ride.place();
        ride.velocity.y = 7;
        ride.step();
        REQUIRE_FALSE(ride.last.on_ground);
        REQUIRE(ride.velocity.x == Approx(speed).margin(0.01f));
        ride.step(100);
        REQUIRE(ride.last.on_ground);
        REQUIRE(ride.place() == Approx(before).margin(0.05f));
        REQUIRE(ride.velocity.x == Approx(0).margin(0.01f));
    }
}

TEST_CASE("a mover that leaves a lift keeps the speed of the lift") {
    Ride ride(4, {0, 3});
    ride.velocity.y = 5;
    ride.step();
    REQUIRE(ride.velocity.y == Approx(8).margin(0.2f));
    Ride down(4, {0, -3});
    down.velocity.y = 5;
    down.step();
    REQUIRE(down.velocity.y == Approx(2).margin(0.2f));
}

TEST_CASE("a mover whose ground vanishes or lets it through keeps the velocity of the ground") {
    const std::string how = GENERATE("body", "shape", "drop");
    INFO(how);
    Ride ride(40, {10, 0});
    if (how == "drop") {
        MoverDef def = ride.mover.definition();
        def.ledges = 2;
        ride.mover.set_definition(def);
        ride.carrier.shapes()[0].set_category(2);
        ride.step();
        REQUIRE(ride.mover.drop(ride.world));
    } else if (how == "body") {
        ride.carrier.destroy();
    } else {
        ride.carrier.shapes()[0].destroy();
    }
    const float before = float(ride.mover.position().x);
    ride.step(30);
    CHECK(ride.velocity.x == Approx(10).margin(0.01f));
    CHECK(float(ride.mover.position().x) - before == Approx(5).margin(0.2f));
    CHECK_FALSE(ride.last.on_ground);
}

TEST_CASE("a mover that jumps in a rising lift lands in it") {
    for (const float rises : {1.0f, 3.0f, 5.0f, 8.0f})
        for (const float jump : {1.0f, 2.0f, 4.0f, 6.0f}) {
            INFO("rises " << rises << ", jump " << jump);
            Ride ride(4, {0, rises});
            ride.velocity.y = jump;
            ride.step();
            CHECK_FALSE(ride.last.on_ground);
            int steps = 1;
            while (!ride.last.on_ground && steps < 240) ride.step(), ++steps;
            CHECK(float(steps) * frame == Approx(2 * jump / 10).margin(0.07f));
            CHECK(ride.velocity.y == Approx(0).margin(0.01f));
        }
}

TEST_CASE("a mover drops through a ledge that rises") {
    for (const float rises : {-3.0f, 0.0f, 1.0f, 3.0f, 5.0f}) {
        INFO("rises " << rises);
        Ride ride(4, {0, rises});
        MoverDef def = ride.mover.definition();
        def.ledges = 2;
        ride.mover.set_definition(def);
        ride.carrier.shapes()[0].set_category(2);
        ride.step();
        REQUIRE(ride.mover.drop(ride.world));
        ride.step(60);
        CHECK(ride.mover.position().y < ride.carrier.position().y - 2);
    }
}

TEST_CASE("walls that close on a mover like a wedge do not throw it up") {
    for (const float tilt : {0.02f, 0.05f, 0.1f, 0.2f})
        for (const float speed : {1.0f, 2.5f, 4.0f}) {
            INFO("tilt " << tilt << ", speed " << speed);
            World world;
            add_floor(world);
            const auto wall = [&](float side) {
                Body body = world.create_body({.type = BodyType::kinematic_body,
                                               .position = {side * 2, 2},
                                               .angle = -side * tilt,
                                               .velocity = {-side * speed, 0}});
                body.add(Box{.width = 1, .height = 4});
                return body;
            };
            Body left = wall(-1), right = wall(1);
            Mover mover({}, {0, 0.01f});
            Vec2 velocity;
            float fastest = 0.0f;
            for (int i = 0; i < 200; ++i) {
                if (!mover.on_ground()) velocity.y -= 10.0f * frame;
                velocity = mover.move(world, velocity, frame).velocity;
                fastest = std::max(fastest, velocity.y);
                if (right.position().x - left.position().x < 1.6f) {
                    left.set_velocity({0, 0});
                    right.set_velocity({0, 0});
                }
                world.step(frame);
            }
            CHECK(fastest < 4.0f * speed);
        }
}

TEST_CASE("a mover that walks off the rear edge of a platform keeps its speed over the ground") {
    for (const float rate : {60.0f, 100.0f, 120.0f, 144.0f, 240.0f}) {
        for (const float walk : {-4.0f, -1.0f, 4.0f}) {
            INFO(rate << " Hz, walks with " << walk);
            Ride ride(2, {10, 0});
            Moved moved;
            for (int i = 0; i < int(3 * rate) && ride.mover.on_ground(); ++i) {
                moved = ride.mover.move(ride.world, {walk, 0}, 1 / rate);
                ride.world.step(1 / rate);
            }
            REQUIRE_FALSE(moved.on_ground);
            CHECK(moved.velocity.x == Approx(10 + walk).margin(0.1f));
        }
    }
}

TEST_CASE("a mover that walks off a moving platform keeps its speed over the ground") {
    Ride ride(2, {6, 0});
    for (int i = 0; i < 120 && ride.last.on_ground; ++i) {
        ride.velocity.x = 3;
        ride.step();
    }
    REQUIRE_FALSE(ride.last.on_ground);
    REQUIRE(ride.velocity.x == Approx(9).margin(0.05f));
}

TEST_CASE("the walls of a moving cabin stop a mover in the air relative to the cabin") {
    for (const float speed : {20.0f, -20.0f}) {
        Ride ride(3, {speed, 0});
        ride.carrier.add(Box{.width = 0.2f, .height = 6, .center = {3, 3}});
        ride.carrier.add(Box{.width = 0.2f, .height = 6, .center = {-3, 3}});
        ride.velocity = {5, 7};
        ride.step(40);
        REQUIRE_FALSE(ride.last.on_ground);
        REQUIRE(ride.velocity.x == Approx(speed).margin(0.01f));
        REQUIRE(ride.place() == Approx(2.5f).margin(0.05f));
        ride.step(80);
        REQUIRE(ride.last.on_ground);
        REQUIRE(ride.place() == Approx(2.5f).margin(0.05f));
    }
}

TEST_CASE("a moving platform takes along a mover that falls onto it from rest") {
    Ride ride(40, {20, 0});
    REQUIRE(ride.velocity.x == Approx(0).margin(1e-4f));
    REQUIRE(ride.last.motion.x == Approx(20 * frame).margin(0.01f));
}

TEST_CASE("a mover that lands on a moving platform slides on it with its own speed") {
    Ride ride(40, {4, 0});
    ride.mover.set_position({0, 0.5f});
    ride.velocity = {6, 0};
    do ride.step();
    while (!ride.last.on_ground && ride.mover.position().y > -1.0f);
    REQUIRE(ride.last.on_ground);
    REQUIRE(ride.velocity.x == Approx(2).margin(0.05f));
    REQUIRE(ride.last.motion.x == Approx(6 * frame).margin(0.01f));
}

}  // namespace mover_leaving_test
