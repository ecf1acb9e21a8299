// Stacks of crates without restitution that fall, or that are made with overlaps: they do not rise
// again, whatever their number, size, speed, gaps and the length of the steps.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace landing_stacks_test {
namespace {

struct Stack {
    World world;
    std::vector<Body> crates;
    float dt;

    /// `gap`: between the crates, and below the lowest one; < 0: they overlap.
    Stack(Random& random, int count, float speed, float gap) : dt(1 / rates[random.engine() % 3]) {
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 100, .height = 2}, {.friction = 0.6f});
        const float size = random(0.3f, 1);
        for (int i = 0; i < count; ++i) {
            const float height = 1 + gap + (size + gap) * float(i) + 0.5f * size;
            crates.push_back(world.create_body(
                {.position = {random(-0.02f, 0.02f), height}, .velocity = {0, -speed}}));
            crates.back().add(Box{.width = size, .height = size}, {.friction = 0.6f});
        }
    }
    /// The greatest upward speed of a crate within two seconds.
    float rise() {
        float most = 0;
        for (float time = 0; time < 2; time += dt) {
            world.step(dt);
            for (const Body& crate : crates) most = std::max(most, crate.velocity().y);
        }
        return most;
    }

    static constexpr float rates[] = {30, 60, 144};
};

}  // namespace

TEST_CASE("a stack that lands does not rise again") {
    const unsigned count = seeds_or(200);
    float few = 0, many = 0;  // of the speed of the fall
    for (unsigned seed = 0; seed < count; ++seed) {
        Random random{std::mt19937(seed + 1)};
        const int crates = 1 + int(seed % 8);
        const float speed = random(3, 20), gap = seed % 2 ? random(0, 0.2f) : 0.3f;
        const float rise = Stack(random, crates, speed, gap).rise() / (speed + 1);
        (crates <= 3 ? few : many) = std::max(crates <= 3 ? few : many, rise);
    }
    std::printf("landing stacks: up to 3 crates rise at %.2f of their speed, up to 8 at %.2f\n",
                double(few), double(many));
    CHECK(few < 0.3f);
    CHECK(many < 0.45f);
}

TEST_CASE("crates that are made with overlaps come apart slowly") {
    const unsigned count = seeds_or(100);
    float most = 0;
    for (unsigned seed = 0; seed < count; ++seed) {
        Random random{std::mt19937(seed + 1)};
        most = std::max(most, Stack(random, 2 + int(seed % 9), 0, -random(0.02f, 0.14f)).rise());
    }
    std::printf("overlapping stacks: at most %.2f m/s upward\n", double(most));
    CHECK(most < 4);
}

}  // namespace landing_stacks_test
