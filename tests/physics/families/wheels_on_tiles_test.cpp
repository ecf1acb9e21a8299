// Round shapes that joints load roll and slide over the seams of a floor of boxes as over one box.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace wheels_on_tiles_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// A level floor of boxes, side by side, from -10 m to `length`.
void add_tiles(World& world, float length, float width, float friction) {
    Body floor = world.create_body({.type = BodyType::static_body});
    for (float x = -10; x < length; x += width)
        floor.add(Box{.width = width, .height = 1, .center = {x, -0.5f}}, {.friction = friction});
}

struct Ride {
    float hop = 0;   ///< the greatest height of a wheel above the floor, m
    float kept = 1;  ///< part of the speed that is left at the end
};

Ride ride(unsigned seed) {
    Random random{std::mt19937(seed)};
    const float rates[] = {30, 60, 144}, rate = rates[seed % 3];
    const float speed = random(2, 50), radius = random(0.25f, 0.6f), time = 4;
    World world;
    add_tiles(world, speed * time + 20, random(0.5f, 3), 0.9f);
    Body chassis = world.create_body({.position = {0, radius + 0.5f}, .velocity = {speed, 0}});
    chassis.add(Box{.width = 3, .height = 0.5f}, {.density = random(0.5f, 4)});
    std::vector<Body> wheels;
    for (const float x : {-1.1f, 1.1f}) {
        wheels.push_back(world.create_body({.position = {x, radius},
                                            .velocity = {speed, 0},
                                            .angular_velocity = -speed / radius}));
        wheels.back().add(Circle{radius}, {.friction = 0.9f});
        const Vec2 anchor = {x, -0.5f};
        if (seed % 2)
            world.create_wheel_joint({.body_a = chassis.id(),
                                      .body_b = wheels.back().id(),
                                      .anchor_a = anchor,
                                      .hertz = random(3, 8)});
        else
            world.create_revolute_joint(
                {.body_a = chassis.id(), .body_b = wheels.back().id(), .anchor_a = anchor});
    }
    Ride ride;
    for (int i = 0; i < int(time * rate); ++i) {
        world.step(1 / rate);
        for (const Body& wheel : wheels)
            ride.hop = std::max(ride.hop, float(wheel.position().y) - radius);
    }
    ride.kept = chassis.velocity().x / speed;
    return ride;
}

}  // namespace

TEST_CASE("wheels roll over the seams of tiles") {
    float hop = 0, kept = 1;
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        const Ride one = ride(seed);
        hop = std::max(hop, one.hop);
        kept = std::min(kept, one.kept);
        INFO("seed " << seed);
        CHECK(one.hop < 0.01f);
        CHECK(one.kept > 0.9f);
    }
    std::printf("wheels on tiles hop by at most %.4f m and keep at least %.3f of their speed\n",
                double(hop), double(kept));
}

TEST_CASE("an elastic ball rolls over the seams of tiles") {
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        const float rates[] = {30, 60, 144}, rate = rates[seed % 3];
        const float speed = random(2, 50), radius = random(0.2f, 0.6f);
        World world;
        add_tiles(world, speed * 4 + 20, random(0.5f, 3), 0.5f);
        Body ball = world.create_body(
            {.position = {0, radius}, .velocity = {speed, 0}, .angular_velocity = -speed / radius});
        ball.add(Circle{radius}, {.friction = 0.5f, .restitution = random(0.3f, 1)});
        float hop = 0;
        for (int i = 0; i < int(4 * rate); ++i) {
            world.step(1 / rate);
            hop = std::max(hop, float(ball.position().y) - radius);
        }
        INFO("seed " << seed);
        CHECK(hop < 0.01f);
        CHECK(ball.velocity().x > 0.95f * speed);
    }
}

}  // namespace wheels_on_tiles_test
