// Bodies that overlap so far that their contacts push in opposite directions: they come apart, and
// are not thrown.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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

/// The greatest energy of the bodies within two seconds, per mass: J/kg.
float greatest_energy(World& world, const std::vector<Body>& bodies, float dt) {
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

float length_of_step(Random& random) {
    return random(0, 1) < 0.5f ? 1 / 60.0f : 0.05f;
}
float turn(Random& random) {
    return random(0, 2 * std::numbers::pi_v<float>);
}
Vec2 near_center(Random& random) {
    const float x = random(-0.2f, 0.2f);
    return {x, random(-0.2f, 0.2f)};
}

/// Of a trough and a shape in it, J/kg.
float energy_of_pair(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world({.gravity = {}});
    std::vector<Body> bodies = {world.create_body({.angle = turn(random)})};
    bodies[0].add(trough(random(least_radius, greatest_radius)));
    const Vec2 place = near_center(random);
    bodies.push_back(world.create_body({.position = Position(place), .angle = turn(random)}));
    bodies[1].add(wedge(random));
    return greatest_energy(world, bodies, length_of_step(random));
}

Box box(Random& random) {
    const float width = 2 * random(least_radius, greatest_radius);
    return {.width = width, .height = 2 * random(least_radius, greatest_radius)};
}

/// Of two boxes, welded to each other or both to a third one, and a shape between them, J/kg.
float energy_between_welded(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world({.gravity = {}});
    const auto weld = [&](const Body& a, const Body& b) {
        world.create_weld_joint({.body_a = a.id(),
                                 .body_b = b.id(),
                                 .anchor_a = a.local_point(b.position()),
                                 .reference_angle = b.angle() - a.angle()});
    };
    const float apart = random(0.7f, 1.6f);
    std::vector<Body> bodies;
    for (const float side : {-0.5f, 0.5f}) {
        const Vec2 place = {side * apart, random(-0.1f, 0.1f)};
        bodies.push_back(world.create_body({.position = Position(place), .angle = turn(random)}));
        bodies.back().add(box(random));
    }
    if (random(0, 1) < 0.3f) {
        bodies.push_back(world.create_body({.position = {0, 2}}));
        bodies.back().add(box(random));
        weld(bodies[0], bodies[2]);
        weld(bodies[1], bodies[2]);
    } else {
        weld(bodies[0], bodies[1]);
    }
    const Vec2 place = near_center(random);
    bodies.push_back(world.create_body({.position = Position(place), .angle = turn(random)}));
    const float radius = apart * random(0.4f, 0.7f);
    if (random(0, 1) < 0.5f)
        bodies.back().add(Circle{.radius = radius});
    else
        bodies.back().add(Box{.width = 2 * radius, .height = 2 * radius * random(0.5f, 1)});
    return greatest_energy(world, bodies, length_of_step(random));
}

/// Number of worlds in which more energy appears than two pushes explain.
unsigned thrown(unsigned count, float (*energy_of)(unsigned seed)) {
    constexpr float pushed_apart = 0.5f * 3 * 3;  // J/kg, by the greatest speed of a push
    unsigned number = 0;
    float worst = 0;
    for (unsigned seed = 1; seed <= count; ++seed) {
        const float energy = energy_of(seed);
        worst = std::max(worst, energy);
        number += energy > 2 * pushed_apart;
    }
    UNSCOPED_INFO(number << " of " << count << " are thrown, worst " << worst << " J/kg");
    return number;
}

}  // namespace

TEST_CASE("Two bodies that are wedged into each other are not thrown") {
    const unsigned count = families::seeds_or(400);
    CHECK(thrown(count, energy_of_pair) <= std::max(1u, count / 100));
}

TEST_CASE("A body that is wedged between welded ones is not thrown") {
    const unsigned count = families::seeds_or(400);
    CHECK(thrown(count, energy_between_welded) * 20 <= count);
}

}  // namespace wedged_pairs_test
