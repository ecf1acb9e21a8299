// Arms of several links whose strong motors press against the limits of their joints come to rest.
// FETTLE_SEEDS=n: n arms.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

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

/// The same for an arm of two to four links of very different masses, whose motors are little
/// stronger than the arm is heavy.
float speed_of_uneven_arm(unsigned seed) {
    families::Random random{std::mt19937(seed)};
    World world;
    const int links = int(random(2, 4.99f));
    std::vector<float> masses;
    for (int i = 0; i < links; ++i) masses.push_back(0.3f * std::pow(10.0f, random(0, 1)));
    const float range = random(0.2f, 1.2f), times = random(1.5f, 10);
    const float rate = random(0, 1) < 0.5f ? 60.0f : random(30, 144);
    Body previous;
    for (int i = 0; i < links; ++i) {
        Body link =
            world.create_body({.position = {float(i) + 0.5f, 5}, .mass = masses[size_t(i)]});
        link.add(Box{.width = 1, .height = 0.2f});
        float needed = 0;  // the torque that holds the links from here on
        for (int k = i; k < links; ++k) needed += 10 * masses[size_t(k)] * (float(k - i) + 0.5f);
        RevoluteJointDef pin;
        if (i > 0) pin.body_a = previous.id();
        pin.anchor_a = i > 0 ? Position{0.5f, 0} : Position{0, 5};
        pin.body_b = link.id();
        pin.anchor_b = {-0.5f, 0};
        pin.lower_angle = -range;
        pin.upper_angle = range;
        pin.motor_speed = random(0, 1) < 0.5f ? -1.5f : 1.5f;
        pin.max_motor_torque = times * needed;
        world.create_revolute_joint(pin);
        previous = link;
    }
    float fastest = 0;
    for (int i = 0; i < int(20 * rate); ++i) {
        world.step(1 / rate);
        if (i > int(18 * rate)) fastest = std::max(fastest, previous.velocity().length());
    }
    return fastest;
}

/// The greatest speed, in ten seconds, of three slides, each on the one before, across each other.
float speed_of_slides(unsigned seed) {
    families::Random random{std::mt19937(seed)};
    World world;
    Body previous;
    std::vector<Body> bodies;
    for (int i = 0; i < 3; ++i) {
        Body body = world.create_body({.position = {0, 5}, .mass = random(0.2f, 3)});
        body.add(Box{.width = 0.5f, .height = 0.5f}, {.mask = 0});
        PrismaticJointDef slide;
        if (i > 0) slide.body_a = previous.id();
        slide.anchor_a = i > 0 ? Position{} : Position{0, 5};
        slide.body_b = body.id();
        slide.axis = families::turned(random(0, 6.28f));
        slide.lower_translation = -random(0.2f, 1);
        slide.upper_translation = random(0.2f, 1);
        slide.motor_speed = random(0, 1) < 0.5f ? -1.5f : 1.5f;
        slide.max_motor_force = random(20, 800);
        world.create_prismatic_joint(slide);
        previous = body;
        bodies.push_back(body);
    }
    float fastest = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(1.0f / 60);
        for (const Body& body : bodies) fastest = std::max(fastest, body.velocity().length());
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

// With one sweep, arms whose outer links are heavier swung for ever, also with weak motors.
TEST_CASE("arms of light and heavy links whose motors press against limits rest", "[families]") {
    unsigned restless = 0;
    const unsigned seeds = families::seeds_or(60);
    for (unsigned seed = 0; seed < seeds; ++seed) restless += speed_of_uneven_arm(seed) > 0.05f;
    std::printf("arms of light and heavy links: %u of %u do not rest\n", restless, seeds);
    CHECK(restless <= seeds / 30);
}

TEST_CASE("slides in a row whose motors press against limits throw nothing", "[families]") {
    float fastest = 0;
    for (unsigned seed = 0; seed < families::seeds_or(200); ++seed)
        fastest = std::max(fastest, speed_of_slides(seed));
    INFO("fastest " << fastest);
    CHECK(fastest < 10);
}

}  // namespace driven_arms_test
