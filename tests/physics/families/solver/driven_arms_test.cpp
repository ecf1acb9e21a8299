// Arms of several links whose strong motors press against the limits of their joints come to rest.
// FETTLE_SEEDS=n: n arms.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace driven_arms_test {

using namespace fettle::physics;

/// The greatest speed of the last link in the thirtieth second.
float speed_of_arm(unsigned seed) {
    families::Random random{std::mt19937(seed)};
    World world;
    if (random(0, 1) < 0.5f) world.set_gravity({0, 0});
    const int links = int(random(3, 8));
    const float torque = 300 * std::pow(10.0f, random(0, 1.5f)), speed = random(0.5f, 3);
    const float range = random(0.1f, 0.6f), rate = random(30, 144);
    Body previous;
    for (int i = 0; i < links; ++i) {
        Body link = world.create_body({.position = {float(i) + 0.5f, 5}});
        link.add(Box{.width = 1, .height = 0.2f}, {.density = random(3, 8)});
        RevoluteJointDef pin;
        if (i > 0) pin.body_a = previous.id();
        pin.anchor_a = i > 0 ? Position{0.5f, 0} : Position{0, 5};
        pin.body_b = link.id();
        pin.anchor_b = {-0.5f, 0};
        pin.lower_angle = -range;
        pin.upper_angle = range;
        pin.motor_speed = speed;
        pin.max_motor_torque = torque;
        world.create_revolute_joint(pin);
        previous = link;
    }
    float fastest = 0;
    for (int i = 0; i < int(30 * rate); ++i) {
        world.step(1 / rate);
        if (i > int(29 * rate)) fastest = std::max(fastest, previous.velocity().length());
    }
    return fastest;
}

TEST_CASE("arms whose strong motors press against limits come to rest", "[families]") {
    float fastest = 0;
    for (unsigned seed = 0; seed < families::seeds_or(50); ++seed) {
        const float speed = speed_of_arm(seed);
        INFO("seed " << seed);
        CHECK(speed < 0.05f);
        fastest = std::max(fastest, speed);
    }
    std::printf("arms with strong motors: at most %.4f m/s after half a minute\n", double(fastest));
}

}  // namespace driven_arms_test
