// Bodies that hang on joints at the world and are made to overlap: the joints and the contact press
// against each other, and the bodies are not thrown.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;

namespace hanging_overlaps_test {
namespace {

constexpr float gravity = 10;  // m/s²

/// Kinetic energy and energy of height, J.
float energy_of(const std::vector<Body>& bodies) {
    float sum = 0;
    for (const Body& body : bodies) {
        sum += 0.5f * (body.mass() * body.velocity().length_squared() +
                       body.inertia() * body.angular_velocity() * body.angular_velocity());
        sum += body.mass() * gravity * float(body.world_center().y);
    }
    return sum;
}

/// A row of balls that hang beside each other, of which one becomes a box that overlaps the others.
/// Returns the energy that appears within two seconds, per mass: J/kg.
float energy_gained(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world;
    std::vector<Body> bodies;
    const float radius = random(0.1f, 0.4f), arm = random(0.5f, 2);
    const int count = 2 + int(random(0, 2));
    for (int i = 0; i < count; ++i) {
        const Position hook = {2 * radius * float(i), 10}, place = {hook.x, 10 - arm};
        bodies.push_back(world.create_body({.position = place}));
        bodies.back().add(Circle{.radius = radius});
        const BodyId body = bodies.back().id();
        if (random(0, 1) < 0.5f)
            world.create_revolute_joint({.body_b = body, .anchor_a = hook, .anchor_b = {0, arm}});
        else
            world.create_distance_joint({.body_b = body, .anchor_a = hook, .length = arm});
    }
    const float dt = random(0, 1) < 0.7f ? 1 / 60.0f : 1 / 30.0f;
    for (float time = 0; time < 0.2f; time += dt) world.step(dt);
    const float width = 2 * radius * random(1.5f, 3.5f), height = 2 * radius * random(0.5f, 1.2f);
    bodies[0].shapes()[0].set_geometry(Box{.width = width, .height = height});
    const float first = energy_of(bodies);
    float most = 0, mass = 0;
    for (const Body& body : bodies) mass += body.mass();
    for (float time = 0; time < 2; time += dt) {
        world.step(dt);
        most = std::max(most, energy_of(bodies) - first);
    }
    return most / mass;
}

}  // namespace

TEST_CASE("Bodies that hang on joints and are made to overlap are not thrown") {
    const unsigned count = families::seeds_or(400);
    constexpr float pushed_apart = 0.5f * 3 * 3;  // J/kg, by the greatest speed of a push
    unsigned thrown = 0;
    float worst = 0;
    for (unsigned seed = 1; seed <= count; ++seed) {
        const float energy = energy_gained(seed);
        worst = std::max(worst, energy);
        thrown += energy > 2 * pushed_apart;
    }
    INFO(thrown << " of " << count << " are thrown, worst " << worst << " J/kg");
    CHECK(thrown * 50 <= count);
}

}  // namespace hanging_overlaps_test
