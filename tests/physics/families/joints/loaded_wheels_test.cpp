// Wheels that a suspension presses on a floor of touching boxes roll over its seams.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;

namespace loaded_wheels_test {
namespace {

/// How high a wheel gets above the floor, m.
float hop_of(unsigned seed) {
    Random random{std::mt19937(seed + 1)};
    constexpr float rates[] = {30, 60, 144, 240};
    const float dt = 1 / rates[seed % 4];
    const float speed = random(5, 60), tile = random(0.4f, 2), radius = random(0.25f, 0.6f);
    World world;
    Body floor = world.create_body({.type = BodyType::static_body});
    const float length = 3 * speed + 20;
    for (float x = -10; x < length; x += tile)
        floor.add(Box{.width = tile, .height = 1, .center = {x, -0.5f}}, {.friction = 0.9f});
    const Position middle = {0, radius + 0.5f};
    Body chassis = world.create_body({.position = middle, .velocity = {speed, 0}});
    chassis.add(Box{.width = 3, .height = 0.5f}, {.density = random(0.5f, 5)});
    std::vector<Body> wheels;
    const bool springs = random(0, 1) < 0.8f;
    for (const float x : {-1.1f, 1.1f}) {
        const Position place = {x, radius};
        Body wheel = world.create_body(
            {.position = place, .velocity = {speed, 0}, .angular_velocity = -speed / radius});
        wheel.add(Circle{.radius = radius}, {.friction = 1});
        wheels.push_back(wheel);
        const BodyId a = chassis.id(), b = wheel.id();
        const Position anchor = chassis.local_point(place);
        if (springs)
            world.create_wheel_joint({.body_a = a,
                                      .body_b = b,
                                      .anchor_a = anchor,
                                      .hertz = random(2, 6),
                                      .damping_ratio = 0.7f});
        else
            world.create_revolute_joint({.body_a = a, .body_b = b, .anchor_a = anchor});
    }
    float hop = 0;
    for (float time = 0; time < 3; time += dt) {
        world.step(dt);
        for (const Body& wheel : wheels)
            if (time > 1) hop = std::max(hop, float(wheel.position().y) - radius);
    }
    return hop;
}

}  // namespace

TEST_CASE("loaded wheels roll over the seams of a floor") {
    const unsigned count = families::seeds_or(80);
    float worst = 0;
    for (unsigned seed = 0; seed < count; ++seed) worst = std::max(worst, hop_of(seed));
    std::printf("loaded wheels hop by %.4f m at most\n", double(worst));
    CHECK(worst < 0.01f);
}

}  // namespace loaded_wheels_test
