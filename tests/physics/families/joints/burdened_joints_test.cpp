// Joints under loads that do not come from another joint: a force, what lies on a light body, or an
// impact.
// FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace burdened_joints_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr float dt = 1.0f / 60;

float greatest_gap(const World& world) {
    float gap = 0.0f;
    for (const Joint& joint : world.joints()) gap = std::max(gap, joint.separation());
    return gap;
}

/// Holds a body at its center by a joint of some type.
Joint hold(World& world, const Body& body, unsigned type) {
    switch (type % 4) {
        case 0:
            return world.create_revolute_joint({.body_b = body.id()});
        case 1:
            return world.create_weld_joint({.body_b = body.id()});
        case 2:
            return world.create_prismatic_joint({.body_b = body.id(), .axis = {1, 0}});
        default:
            return world.create_distance_joint(
                {.body_b = body.id(), .anchor_a = {0, 1}, .length = 1.0f});
    }
}

RevoluteJoint pin(World& world, const Body& a, const Body& b, Vec2 at, float torque = 0.0f) {
    return world.create_revolute_joint({.body_a = a.id(),
                                        .body_b = b.id(),
                                        .anchor_a = a.local_point(at),
                                        .anchor_b = b.local_point(at),
                                        .max_motor_torque = torque});
}

/// An arm of two bars with a scoop, held by motors. A load lies in the scoop. Returns the greatest
/// gap of a joint, m.
float gap_of_arm(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world;
    const ShapeDef arm = {.group = -1};
    Body base = world.create_body({.type = BodyType::static_body, .position = {0, 1}});
    base.add(Box{.width = 200, .height = 2, .center = {0, -2}});
    const float first = random(2, 4), second = random(1.5f, 3), tip = first + second;
    Body near = world.create_body({.position = {first / 2, 2}});
    near.add(Box{.width = first, .height = 0.3f}, arm);
    Body far = world.create_body({.position = {first + second / 2, 2}});
    far.add(Box{.width = second, .height = 0.2f}, arm);
    Body scoop = world.create_body({.position = {tip + 0.4f, 2}});
    scoop.add(Box{.width = 0.8f, .height = 0.1f}, arm);
    for (const float side : {-0.4f, 0.4f})
        scoop.add(Box{.width = 0.1f, .height = 0.6f, .center = {side, 0.25f}}, arm);
    Body load = world.create_body({.position = {tip + 0.4f, 2.4f}});
    load.add(Box{.width = 0.5f, .height = 0.5f}, {.density = random(1, 200)});
    const float torque = random(2000, 20000);
    pin(world, base, near, {0, 2}, torque);
    pin(world, near, far, {first, 2}, torque);
    pin(world, far, scoop, {tip, 2}, torque);
    float gap = 0.0f;
    for (int i = 0; i < 300; ++i) {
        world.step(dt);
        gap = std::max(gap, greatest_gap(world));
    }
    return gap;
}

/// A heavy wagon without restitution falls on its light wheels. Returns the greatest speed at which
/// it rises, as a part of the speed at which it lands.
float bounce_of_wagon(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{.width = 400, .height = 2, .center = {0, -1}});
    const float drop = random(0.5f, 6), ratio = random(5, 80), radius = random(0.15f, 0.5f);
    const float length = random(1, 3), height = random(0.3f, 1);
    Body wagon = world.create_body(
        {.position = {0, drop + radius + height / 2}, .angle = random(-0.3f, 0.3f)});
    wagon.add(Box{.width = length, .height = height}, {.group = -1});
    std::vector<Body> parts = {wagon};
    for (const float side : {-0.5f, 0.5f}) {
        const Position axle = wagon.world_point({side * length, -height / 2});
        Body wheel = world.create_body({.position = axle});
        wheel.add(Circle{.radius = radius},
                  {.density = wagon.mass() / ratio / (3.14159f * radius * radius), .group = -1});
        pin(world, wagon, wheel, Vec2(axle));
        parts.push_back(wheel);
    }
    const float across = random(-5, 5), down = random(0, 5);
    for (Body& part : parts) part.set_velocity({across, -down});
    float rise = 0.0f;
    for (int i = 0; i < 300; ++i) {
        world.step(dt);
        float mass = 0.0f, momentum = 0.0f;
        for (const Body& part : parts) {
            mass += part.mass();
            momentum += part.mass() * part.velocity().y;
        }
        rise = std::max(rise, momentum / mass);
    }
    return rise / std::sqrt(down * down + 2 * 9.81f * drop);
}

}  // namespace

TEST_CASE("a joint yields to a force of any size in proportion to the force") {
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {}});
        Body body = world.create_body({});
        const float size = random(0.1f, 2);
        body.add(Box{.width = size, .height = size * random(0.2f, 1)});
        const Joint joint = hold(world, body, seed);
        const float acceleration = std::pow(10.0f, random(2, 4.6f));
        for (int i = 0; i < 120; ++i) {
            body.apply_force({0, -acceleration * body.mass()});
            world.step(dt);
        }
        const float stiffness = 377 * 377;  // 60 Hz for each kilogram
        INFO("seed " << seed << ", acceleration " << acceleration);
        CHECK(joint.separation() < 1.1f * acceleration / stiffness + 0.001f);
        CHECK(body.velocity().length() < 0.05f);
    }
}

TEST_CASE("an arm with a heavy load in its scoop is not drawn apart") {
    float worst = 0, sum = 0;
    const unsigned seeds = seeds_or(50);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const float gap = gap_of_arm(seed);
        INFO("seed " << seed << ", gap " << gap << " m");
        CHECK(gap < 0.3f);
        worst = std::max(worst, gap);
        sum += gap / float(seeds);
    }
    std::printf("joints of a loaded arm part by %.0f mm, at most %.0f\n", 1000 * double(sum),
                1000 * double(worst));
    CHECK(sum < 0.1f);
}

TEST_CASE("a heavy wagon on light wheels hardly bounces without restitution") {
    float worst = 0, sum = 0;
    const unsigned seeds = seeds_or(60);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const float part = bounce_of_wagon(seed);
        worst = std::max(worst, part);
        sum += part / float(seeds);
    }
    std::printf("wagons on light wheels rise at %.2f of the speed of their fall, at most %.2f\n",
                double(sum), double(worst));
    CHECK(sum < 0.35f);
    CHECK(worst < 0.8f);
}

}  // namespace burdened_joints_test
