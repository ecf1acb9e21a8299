// Planks on pins in the way of a fast kinematic body, which cannot stop: it does not throw them by
// their pins. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
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

}  // namespace

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
