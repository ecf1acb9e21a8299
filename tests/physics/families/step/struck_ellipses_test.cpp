// Ellipses that rotating bats strike, in long steps too. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace struck_ellipses_test {

using namespace fettle::physics;

TEST_CASE("a bat makes ellipses no faster than its own tip can") {
    const int seeds = int(families::seeds_or(100));
    float worst = 0.0f;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world(WorldDef{.substeps = 2 + int(random.engine() % 3)});
        const float spin = random(5, 30), half = random(0.8f, 2.5f);
        world
            .create_body(
                {.type = BodyType::kinematic_body, .angle = random(0, 3), .angular_velocity = spin})
            .add(Box{.width = 2 * half, .height = random(0.05f, 0.4f)}, {.friction = random(0, 1)});
        std::vector<Body> struck;
        for (int i = 0; i < 4; ++i) {
            const float radius = random(0.1f, 0.4f);
            struck.push_back(
                world.create_body({.position = {random(-half, half), random(0.5f, 3)}}));
            struck.back().add(Ellipse{.radius_x = radius, .radius_y = random(0.3f, 1) * radius});
        }
        const float lengths[] = {1.0f / 60, 1.0f / random(20, 60), 1.0f / 20};
        float fastest = 0.0f;
        for (int step = 0; step < 60; ++step) {
            world.step(lengths[step % 3]);
            for (const Body& body : struck) fastest = std::max(fastest, body.velocity().length());
        }
        // The tip, the way of a fall, and pushes out of an overlap.
        const float possible = spin * (half + 0.5f) + 10 * 2 + 3;
        worst = std::max(worst, fastest / possible);
        CAPTURE(seed, spin, half, fastest, possible);
        CHECK(fastest < 2.5f * possible);
    }
    std::printf("struck ellipses: at most %.2f of what the tip and a fall can give\n",
                double(worst));
}

}  // namespace struck_ellipses_test
