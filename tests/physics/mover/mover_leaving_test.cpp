#include <fettle/physics/mover.h>

#include <cmath>

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
