// Bodies fall on bridges of links. A bridge is as long as the distance between its ends, so it is
// almost straight, and the impulses in it have no bound. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace taut_bridge_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// The greatest speed of a body, in speeds of the fall.
float fastest_after_fall(unsigned seed, Solver solver) {
    Random random{std::mt19937(seed + 1)};
    World world({.solver = solver});
    const int links = int(random(8, 13));
    const float size = random(0.3f, 0.8f), height = random(1, 3);
    const float dt = 1 / random(20, 60);
    std::vector<Body> bodies;
    RevoluteJointDef joint;
    for (int i = 0; i < links; ++i) {
        bodies.push_back(world.create_body({.position = {(float(i) + 0.5f) * size, 0}}));
        bodies.back().add(Box{.width = 0.95f * size, .height = random(0.3f, 0.4f) * size});
        joint.body_b = bodies.back().id();
        joint.anchor_b = {-0.5f * size, 0};
        world.create_revolute_joint(joint);
        joint.body_a = bodies.back().id();
        joint.anchor_a = {0.5f * size, 0};
    }
    joint.body_b = {};
    joint.anchor_b = {float(links) * size, 0};
    world.create_revolute_joint(joint);
    bodies.push_back(
        world.create_body({.position = {random(0.2f, 0.8f) * float(links) * size, height}}));
    bodies.back().add(Box{.width = size, .height = random(0.03f, 0.1f) * size},
                      {.density = random(0.5f, 3)});
    float fastest = 0.0f;
    for (float time = 0; time < 3; time += dt) {
        world.step(dt);
        for (const Body& body : bodies) {
            // A body that has fallen off the bridge does not count.
            if (body.position().y > -float(links) * size)
                fastest = std::max(fastest, body.velocity().length());
        }
    }
    return fastest / std::sqrt(2 * 9.81f * (height + 0.1f * float(links) * size));
}

}  // namespace

TEST_CASE("a taut bridge on which a body falls does not throw its links") {
    for (const Solver solver : {Solver::soft_step, Solver::direct}) {
        float most = 0;
        unsigned worst = 0;
        int thrown = 0;
        for (unsigned seed = 0; seed < seeds_or(50); ++seed) {
            const float speed = fastest_after_fall(seed, solver);
            thrown += speed > 3;
            if (speed > most) most = speed, worst = seed;
        }
        std::printf("taut bridges, solver %d: %d thrown, at most %.2f speeds of the fall (%u)\n",
                    int(solver), thrown, double(most), worst);
        CHECK(thrown == 0);
    }
}

}  // namespace taut_bridge_test
