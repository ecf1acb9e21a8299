// Heaps come to rest, also where a contact lets go and holds again in turn; and what moves visibly
// does not rest.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "family.h"

namespace rest_family_test {

using namespace fettle::physics;
using families::Random;

namespace {

/// Time until 500 stars with spikes that hook into each other sleep, s; at most `limit`.
float stars_to_rest(unsigned seed, float limit) {
    Random random{std::mt19937(seed)};
    World world;
    Body box = world.create_body({.type = BodyType::static_body});
    box.add(Box{.width = 30, .height = 1, .center = {0, -0.5f}});
    for (const float x : {-12.0f, 12.0f}) box.add(Box{.width = 1, .height = 60, .center = {x, 30}});
    for (int i = 0; i < 500; ++i) {
        Body star =
            world.create_body({.position = {1.1f * float(i % 20 - 10) + 0.55f + random(0, 0.1f),
                                            1 + 1.2f * float(i / 20)},
                               .angle = random(0, 6)});
        std::vector<Vec2> rim;
        for (int k = 0; k < 10; ++k) {
            const float angle = 0.628f * float(k), radius = k % 2 != 0 ? 0.22f : 0.5f;
            rim.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
        star.add(Concave{rim});
    }
    for (float time = 0.0f; time < limit; time += 1.0f / 60) {
        world.step(1.0f / 60);
        if (world.statistics().awake_bodies == 0) return time;
    }
    return limit;
}

}  // namespace

TEST_CASE("heaps of stars come to rest") {
    std::vector<float> times;
    const unsigned seeds = families::seeds_or(10);
    for (unsigned seed = 0; seed < seeds; ++seed) times.push_back(stars_to_rest(seed, 40));
    std::ranges::sort(times);
    INFO("half after " << times[seeds / 2] << " s, the last after " << times.back() << " s");
    CHECK(times[seeds / 2] < 8);
    CHECK(times.back() < 40);
}

TEST_CASE("a body that swings to and fro on the ground stays awake") {
    World world;
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 20, .height = 1, .center = {0, -0.5f}}, {.friction = 0});
    Body body = world.create_body({.position = {0, 0.5f}});
    body.add(Box{.width = 1, .height = 1}, {.friction = 0});
    DistanceJoint spring = world.create_distance_joint(
        {.body_b = body.id(), .anchor_a = {-3, 0.5f}, .anchor_b = {0, 0}});
    spring.set_hertz(2);
    spring.set_damping_ratio(0);
    body.set_position({0.015f, 0.5f});  // at most 0.19 m/s
    int asleep = 0;
    for (int i = 0; i < 240; ++i) {
        world.step(1.0f / 60);
        asleep += !body.awake();
    }
    CHECK(asleep == 0);
}

TEST_CASE("what is carried slowly stays awake") {
    for (const float speed : {0.06f, 0.1f, 0.2f}) {
        World world;
        Body lift =
            world.create_body({.type = BodyType::kinematic_body, .velocity = {speed, speed}});
        lift.add(Box{.width = 4, .height = 1});
        Body body = world.create_body({.position = {0, 1}});
        body.add(Box{.width = 1, .height = 1});
        for (int i = 0; i < 240; ++i) world.step(1.0f / 60);
        CHECK(body.awake());
        CHECK(body.position().x == Approx(4 * speed).epsilon(0.02));
    }
}

}  // namespace rest_family_test
