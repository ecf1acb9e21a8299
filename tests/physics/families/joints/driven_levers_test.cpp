// Bodies that joints hold where a kinematic body drives them, which cannot stop: planks on pins in
// its way, and what it drags through the ground. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

namespace driven_levers_test {

using namespace fettle::physics;
using families::Random;

namespace {

/// The greatest speed of a body, as a multiple of that of the ram.
float fastest_beside_ram(unsigned seed) {
    Random random{std::mt19937(seed + 1)};
    World world;
    const float speed = random(5, 30);
    world
        .create_body(
            {.type = BodyType::kinematic_body, .position = {-8, 1}, .velocity = {speed, 0}})
        .add(Box{.width = 0.5f, .height = 2});
    const float length = random(0.6f, 3), thickness = random(0.08f, 0.25f);
    Body plank = world.create_body({.angle = random(-3.1f, 3.1f)});
    plank.add(Box{.width = length, .height = thickness},
              {.density = random(0.2f, 2), .restitution = std::max(random(-0.5f, 0.5f), 0.0f)});
    const float place = std::max(random(-1, 0.5f), -0.5f);  // often at the end
    const Vec2 anchor(place * length, 0);
    const float height = random(0, 2.2f);
    plank.set_position(Position{0, height} - plank.world_vector(anchor));
    world.create_revolute_joint(RevoluteJointDef(
        JointDef{.body_b = plank.id(), .anchor_a = {0, height}, .anchor_b = anchor}));
    std::vector<Body> bodies = {plank};
    for (int i = 0; i < 3; ++i) {
        bodies.push_back(
            world.create_body({.position = {random(-0.8f, 0.8f), random(2.6f, 4.5f)}}));
        bodies.back().add(Box{.width = random(0.15f, 0.5f), .height = random(0.15f, 0.5f)});
    }
    float fastest = 0;
    for (float time = 0; time < 9.5f / speed + 0.5f; time += 1.0f / 60) {
        world.step(1.0f / 60);
        for (const Body& body : bodies) fastest = std::max(fastest, body.velocity().length());
    }
    return fastest / speed;
}

/// A falling chain of limbs of which one becomes kinematic and drags the others through the ground.
/// The greatest speed of a body, as a multiple of that of this limb.
float fastest_beside_dragged(unsigned seed) {
    Random random{std::mt19937(seed + 1)};
    World world;
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 40, .height = 1, .center = {0, -0.5f}});
    const int count = 3 + int(random.engine() % 4), which = int(random.engine() % unsigned(count));
    const float height = random(1.5f, 5), speed = random(0, 8);
    std::vector<Body> limbs;
    for (int i = 0; i < count; ++i) {
        const float length = random(0.3f, 0.6f);
        limbs.push_back(world.create_body({.position = {0.5f * float(i), height},
                                           .angle = random(-0.4f, 0.4f),
                                           .velocity = {0, -speed}}));
        limbs.back().add(Segment{
            .from = {-length / 2, 0}, .to = {length / 2, 0}, .rounding = random(0.04f, 0.12f)});
        if (i > 0)
            world.create_revolute_joint(
                RevoluteJointDef(JointDef{.body_a = limbs[std::size_t(i) - 1].id(),
                                          .body_b = limbs.back().id(),
                                          .anchor_a = {0.25f, 0},
                                          .anchor_b = {-0.25f, 0}}));
    }
    Body& limb = limbs[std::size_t(which)];
    const int begin = int(random(9, 30));
    for (int step = 0; step < begin; ++step) world.step(1.0f / 60);
    limb.set_type(BodyType::kinematic_body);
    const float driven = limb.velocity().length() + 0.3f * std::fabs(limb.angular_velocity());
    float fastest = 0;
    for (int step = begin; step < 90; ++step) {
        world.step(1.0f / 60);
        for (const Body& each : limbs) fastest = std::max(fastest, each.velocity().length());
    }
    return fastest / std::max(driven, 1.0f);
}

}  // namespace

TEST_CASE("a limb that becomes kinematic does not throw what it drags through the ground") {
    const unsigned seeds = families::seeds_or(400);
    std::vector<float> times;
    for (unsigned seed = 0; seed < seeds; ++seed) times.push_back(fastest_beside_dragged(seed));
    std::sort(times.begin(), times.end());
    const float most = times.back(), usual = times[times.size() / 2];
    std::printf(
        "dragged through the ground: median %.1f times the speed of the limb, at most %.1f\n",
        double(usual), double(most));
    CHECK(usual < 5);
    CHECK(most < 50);
}

TEST_CASE("a fast kinematic body does not throw a plank by its pin") {
    const unsigned seeds = families::seeds_or(400);
    std::vector<float> times;
    for (unsigned seed = 0; seed < seeds; ++seed) times.push_back(fastest_beside_ram(seed));
    std::sort(times.begin(), times.end());
    const float most = times.back(), usual = times[times.size() * 95 / 100];
    std::printf("levers and rams: 95 %% below %.1f times the speed of the ram, all below %.1f\n",
                double(usual), double(most));
    CHECK(usual < 5);
    CHECK(most < 25);
}

}  // namespace driven_levers_test
