// Heaps come to rest, even if a contact ends and begins again and again. A body that moves visibly
// stays awake.

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

/// Seconds until 500 stars, whose spikes hook into each other, sleep; at most `limit`.
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
    const unsigned seeds = families::seeds_or(20);
    for (unsigned seed = 0; seed < seeds; ++seed) times.push_back(stars_to_rest(seed, 40));
    std::ranges::sort(times);
    INFO("half after " << times[seeds / 2] << " s, the last after " << times.back() << " s");
    CHECK(times[seeds / 2] < 8);
    CHECK(times.back() < 40);
}

TEST_CASE("capsules in one line meet at their ends") {
    for (unsigned seed = 0; seed < families::seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        World world(WorldDef{.gravity = {0, 0}});
        const float angle = random(-3, 3), half = random(0.05f, 1), radius = random(0.01f, 0.3f);
        const Vec2 axis(std::cos(angle), std::sin(angle));
        const float gap = random(-0.002f, 0.002f), lean = random(-1e-3f, 1e-3f);
        for (const int side : {-1, 1}) {
            world
                .create_body({.position = float(side) * (half + radius + 0.5f * gap) * axis,
                              .angle = angle + float(side) * lean})
                .add(Segment{.from = {-half, 0}, .to = {half, 0}, .rounding = radius});
        }
        world.step(1e-6f);
        INFO("seed " << seed << ", gap " << gap);
        const std::vector<Contact> contacts = world.contacts();
        REQUIRE(contacts.size() == 1);
        CHECK(std::abs(contacts[0].normal.dot(axis)) > 0.99f);
        CHECK(contacts[0].points[0].separation == Approx(gap).margin(1e-4));
    }
}

TEST_CASE("capsules that lie end to end come to rest") {
    int awake = 0;
    const unsigned seeds = families::seeds_or(50);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 40, .height = 1, .center = {0, -0.5f}});
        const float friction = random(0.3f, 0.6f), half = random(0.1f, 0.3f);
        const float radius = random(0.03f, 0.1f);
        for (int i = 0; i < 3; ++i)
            world
                .create_body(
                    {.position = {2.1f * float(i) * (half + radius) + random(-0.02f, 0.02f),
                                  radius + half},
                     .angle = random(-3, 3)})
                .add(Segment{.from = {-half, 0}, .to = {half, 0}, .rounding = radius},
                     {.friction = friction, .rolling_resistance = 0.1f});
        for (int step = 0; step < 480; ++step) world.step(1.0f / 60);
        awake += world.statistics().awake_bodies > 0;
    }
    INFO(awake << " of " << seeds << " are awake");
    CHECK(awake == 0);
}

TEST_CASE("a body that swings on the ground stays awake") {
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

TEST_CASE("a body that is carried slowly stays awake") {
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

TEST_CASE("bodies whose joint was torn apart stay awake until they are together") {
    World world({.gravity = {0, 0}});
    Body a = world.create_body({}), b = world.create_body({.position = {1.5f, 0}});
    a.add(Box{});
    b.add(Box{});
    RevoluteJoint pin = world.create_revolute_joint(
        {.body_a = a.id(), .body_b = b.id(), .anchor_a = {0.75f, 0}, .anchor_b = {-0.75f, 0}});
    b.set_position({6.5f, 0});
    for (int i = 0; i < 400; ++i) world.step(1.0f / 60);
    CHECK(pin.separation() < 0.01f);
    CHECK(!a.awake());
    CHECK(!b.awake());
}

}  // namespace rest_family_test
