// Two bodies that overlap so far that their contacts push in opposite directions: they come apart,
// and are not thrown.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;

namespace wedged_pairs_test {
namespace {

constexpr float least_radius = 0.2f, greatest_radius = 0.6f;  // m

/// A trough with walls a third as wide as itself.
Concave trough(float size) {
    const float inner = 0.44f * size;
    return {{{-size, -size},
             {size, -size},
             {size, size},
             {inner, size},
             {inner, -inner},
             {-inner, -inner},
             {-inner, size},
             {-size, size}}};
}

Geometry wedge(Random& random) {
    const float size = random(least_radius, greatest_radius);
    const float kind = random(0, 3);
    if (kind < 1) return Ellipse{.radius_x = size, .radius_y = size * random(0.4f, 1)};
    if (kind < 2) return Box{.width = 2 * size, .height = 2 * size * random(0.4f, 1)};
    return trough(size);
}

/// The greatest energy of the two within two seconds, per mass: J/kg.
float energy_of(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world({.gravity = {}});
    Body bodies[2];
    const auto turn = [&] { return random(0, 2 * std::numbers::pi_v<float>); };
    bodies[0] = world.create_body({.angle = turn()});
    bodies[0].add(trough(random(least_radius, greatest_radius)));
    bodies[1] = world.create_body(
        {.position = {random(-0.2f, 0.2f), random(-0.2f, 0.2f)}, .angle = turn()});
    bodies[1].add(wedge(random));
    const float dt = random(0, 1) < 0.5f ? 1 / 60.0f : 0.05f;
    float most = 0;
    for (float time = 0; time < 2; time += dt) {
        world.step(dt);
        float energy = 0, mass = 0;
        for (const Body& body : bodies) {
            energy += 0.5f * (body.mass() * body.velocity().length_squared() +
                              body.inertia() * body.angular_velocity() * body.angular_velocity());
            mass += body.mass();
        }
        most = std::max(most, energy / mass);
    }
    return most;
}

}  // namespace

TEST_CASE("Two bodies that are wedged into each other are not thrown") {
    const unsigned count = families::seeds_or(400);
    constexpr float pushed_apart = 0.5f * 3 * 3;  // J/kg, by the greatest speed of a push
    unsigned fast = 0;
    float worst = 0;
    for (unsigned seed = 1; seed <= count; ++seed) {
        const float energy = energy_of(seed);
        worst = std::max(worst, energy);
        fast += energy > 2 * pushed_apart;
    }
    INFO(fast << " of " << count << " are thrown, worst " << worst << " J/kg");
    CHECK(fast * 100 <= count);
}

}  // namespace wedged_pairs_test
