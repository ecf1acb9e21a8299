// A body that nothing supports is slow where it turns back, and does not fall asleep there.

#include <fettle/physics/physics.h>

#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace turning_points_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

TEST_CASE("a body that is thrown up under little gravity falls again") {
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        const float gravity = random(0.03f, 0.4f), speed = random(0.1f, 1);
        const bool by_scale = seed % 2 != 0;
        World world({.gravity = {0, by_scale ? -10 : -gravity}});
        Body body = world.create_body(
            {.velocity = {0, speed}, .gravity_scale = by_scale ? gravity / 10 : 1});
        body.add(Circle{random(0.05f, 1)});
        const float time = 2 * speed / gravity + 3;
        const int steps = int(time * 60);
        for (int i = 0; i < steps; ++i) world.step(1.0f / 60);
        const float passed = float(steps) / 60;
        const float wanted = speed * passed - 0.5f * gravity * passed * passed;
        INFO("seed " << seed);
        CHECK(body.awake());
        CHECK(std::fabs(body.position().y - wanted) < 0.02f * std::fabs(wanted) + 0.05f);
    }
}

TEST_CASE("a body that drifts or sinks slowly goes on") {
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        const float speed = random(0.005f, 0.06f), drag = random(1, 20);
        const bool sinks = seed % 2 != 0;
        World world({.gravity = {0, sinks ? -speed * drag : 0}});
        Body body =
            world.create_body({.velocity = {0, -speed}, .linear_damping = sinks ? drag : 0});
        body.add(Circle{random(0.1f, 1)});
        for (int i = 0; i < 1200; ++i) world.step(1.0f / 60);
        INFO("seed " << seed);
        CHECK(std::fabs(body.position().y + 20 * speed) < 0.05f * 20 * speed);
    }
}

TEST_CASE("a pendulum does not stop beside the vertical") {
    int stopped = 0;
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        const float length = random(0.3f, 10), angle = random(0.01f, 0.1f);
        World world;
        Body post = world.create_body({.type = BodyType::static_body});
        const Vec2 place = length * Vec2{std::sin(angle), -std::cos(angle)};
        Body bob = world.create_body({.position = place});
        bob.add(Circle{0.1f * length});
        if (seed % 2)
            world.create_distance_joint({.body_a = post.id(), .body_b = bob.id()});
        else
            world.create_revolute_joint(
                {.body_a = post.id(), .body_b = bob.id(), .anchor_b = -place});
        float greatest = 0;
        for (int i = 0; i < 1200; ++i) {
            world.step(1.0f / 60);
            if (i > 600) greatest = std::max(greatest, std::fabs(float(bob.position().x)));
        }
        const float beside = std::fabs(bob.position().x) / length;
        if (!bob.awake() && beside > 0.003f) ++stopped;
        INFO("seed " << seed << ", " << length << " m, " << angle << " rad");
        CHECK(greatest > 0.8f * length * std::sin(angle));
    }
    CHECK(stopped == 0);
}

TEST_CASE("what hangs or floats still falls asleep") {
    for (unsigned seed = 0; seed < seeds_or(20); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {0, seed % 2 ? -10.0f : 0.0f}});
        Body post = world.create_body({.type = BodyType::static_body});
        Body body = world.create_body({.position = {0, -random(0.5f, 5)}});
        body.add(Box{.width = random(0.1f, 2), .height = random(0.1f, 2)});
        if (seed % 2) world.create_distance_joint({.body_a = post.id(), .body_b = body.id()});
        for (int i = 0; i < 300; ++i) world.step(1.0f / 60);
        INFO("seed " << seed);
        CHECK(!body.awake());
    }
}

}  // namespace turning_points_test
