// A lift that starts at once under a column of crates carries all of them: the limit of squeezed
// bodies does not hold the upper ones back.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;

namespace starting_lift_test {
namespace {

struct Ride {
    float sunk = 0;     ///< of the column, at the end, as a part of its height
    float overlap = 0;  ///< of two crates, the greatest one, as a part of the height of a crate
};

Ride ride_of(unsigned seed) {
    Random random{std::mt19937(seed + 1)};
    constexpr float rates[] = {30, 60, 144};
    const float dt = 1 / rates[seed % 3];
    World world;
    Body lift = world.create_body({.type = BodyType::kinematic_body});
    lift.add(Box{.width = 4, .height = 0.3f});
    const int count = 2 + int(random(0, 9));
    const float height = random(0.25f, 1), width = height * random(0.8f, 2);
    std::vector<Body> crates;
    for (int i = 0; i < count; ++i) {
        crates.push_back(world.create_body({.position = {0, 0.15f + height * (float(i) + 0.5f)}}));
        crates.back().add(Box{.width = width, .height = height}, {.friction = 0.6f});
    }
    for (float time = 0; time < 1; time += dt) world.step(dt);
    // Faster ones move by more than half of the lowest crate in a step.
    lift.set_velocity({0, std::min(random(3, 12), 0.4f * height / dt)});
    Ride ride;
    for (float time = 0; time < 2; time += dt) {
        world.step(dt);
        for (int i = 1; i < count; ++i) {
            const float apart =
                float(crates[size_t(i)].position().y) - float(crates[size_t(i) - 1].position().y);
            ride.overlap = std::max(ride.overlap, 1 - apart / height);
        }
    }
    const float top = float(crates.back().position().y - lift.position().y) - 0.15f;
    ride.sunk = 1 - top / (height * (float(count) - 0.5f));
    return ride;
}

}  // namespace

TEST_CASE("a lift that starts at once carries its whole column") {
    const unsigned count = families::seeds_or(120);
    Ride worst;
    for (unsigned seed = 0; seed < count; ++seed) {
        const Ride ride = ride_of(seed);
        worst = {std::max(worst.sunk, ride.sunk), std::max(worst.overlap, ride.overlap)};
    }
    std::printf("starting lift: a column sinks in by %.3f, a crate by %.3f\n", double(worst.sunk),
                double(worst.overlap));
    CHECK(worst.sunk < 0.12f);
    CHECK(worst.overlap < 0.35f);
}

}  // namespace starting_lift_test
