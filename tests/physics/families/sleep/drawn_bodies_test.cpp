// A body that gravity draws is slow where it turns back, and does not fall asleep there. One that
// settles does.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "family.h"

namespace drawn_bodies_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr ShapeDef rough = {.friction = 0.9f};

void run(World& world, float seconds) {
    for (int i = 0; i < int(seconds * 60); ++i) world.step(1.0f / 60);
}

/// Seconds until the world sleeps, at most `limit`.
float seconds_to_rest(World& world, float limit) {
    float time = 0;
    for (; time < limit; time += 1.0f / 60) {
        world.step(1.0f / 60);
        if (world.statistics().awake_bodies == 0) break;
    }
    return time;
}

}  // namespace

TEST_CASE("a ball that rolls up a gentle slope comes back") {
    unsigned stay = 0;
    const unsigned seeds = seeds_or(100);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        const float slope = random(0.3f, 3) / 57.3f, speed = random(0.5f, 1.5f);
        const float radius = random(0.05f, 0.4f);
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Chain{{{-40, 0}, {0, 0}, {60, 60 * std::tan(slope)}}}, rough);
        Body ball = world.create_body({.position = {1, std::tan(slope) + radius / std::cos(slope)},
                                       .velocity = {speed, 0},
                                       .angular_velocity = -speed / radius});
        ball.add(Circle{radius}, rough);
        run(world, 2 * speed / (6.5f * std::sin(slope)) + 3 / speed + 1);
        stay += ball.position().x > 0;
    }
    INFO(stay << " of " << seeds << " stay on the slope");
    CHECK(stay == 0);
}

TEST_CASE("a ball in a wide bowl rolls to and fro") {
    for (unsigned seed = 0; seed < seeds_or(24); ++seed) {
        Random random{std::mt19937(seed)};
        const float size = random(4, 100), start = size * random(0.03f, 0.05f);
        World world;
        std::vector<Vec2> bowl;
        for (int i = -200; i <= 200; ++i) {
            const float x = 0.0005f * size * float(i);
            bowl.emplace_back(x, x * x / (2 * size));
        }
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Chain{bowl}, rough);
        Body ball = world.create_body({.position = {start, start * start / (2 * size) + 0.3f}});
        ball.add(Circle{0.3f}, rough);
        run(world, 40);
        INFO("seed " << seed << ", radius " << size << " m, from " << start << " m");
        CHECK(ball.awake());
    }
}

TEST_CASE("a swing with a rider does not stop beside the vertical") {
    for (unsigned seed = 0; seed < seeds_or(40); ++seed) {
        Random random{std::mt19937(seed)};
        const float length = random(1, 10), angle = random(0.02f, 0.1f);
        const auto at = [angle](float distance) {
            return distance * Vec2{std::sin(angle), -std::cos(angle)};
        };
        World world;
        Body post = world.create_body({.type = BodyType::static_body});
        Body seat = world.create_body({.position = at(length), .angle = angle});
        seat.add(Box{.width = 0.8f, .height = 0.1f});
        world.create_revolute_joint(
            {.body_a = post.id(), .body_b = seat.id(), .anchor_b = {0, length}});
        Body rider = world.create_body({.position = at(length - 0.35f), .angle = angle});
        rider.add(Box{.width = 0.4f, .height = 0.6f});
        float greatest = 0;
        for (int i = 0; i < 1200; ++i) {
            world.step(1.0f / 60);
            if (i > 600) greatest = std::max(greatest, std::fabs(float(seat.position().x)));
        }
        INFO("seed " << seed << ", " << length << " m, " << angle << " rad");
        CHECK(greatest > 0.6f * length * std::sin(angle));  // the rider rubs
        // What stops, stops where it hangs.
        if (!seat.awake()) CHECK(std::fabs(seat.position().x) < 0.003f * length);
    }
}

TEST_CASE("bodies that touch and are thrown up under little gravity fall again") {
    for (unsigned seed = 0; seed < seeds_or(40); ++seed) {
        Random random{std::mt19937(seed)};
        const float gravity = random(0.03f, 0.4f), speed = random(0.1f, 1);
        World world({.gravity = {0, -gravity}});
        std::vector<Body> tower;
        for (int i = 0; i < 3; ++i) {
            tower.push_back(world.create_body({.position = {0, float(i)}, .velocity = {0, speed}}));
            tower.back().add(Box{});
        }
        const float passed = 2 * speed / gravity + 3;
        run(world, passed);
        const float wanted = speed * passed - 0.5f * gravity * passed * passed;
        INFO("seed " << seed);
        CHECK(tower[0].position().y == Approx(wanted).epsilon(0.02).margin(0.05));
    }
}

TEST_CASE("balls that drift and touch keep their momentum") {
    for (unsigned seed = 0; seed < seeds_or(40); ++seed) {
        Random random{std::mt19937(seed)};
        const float speed = random(0.3f, 4), radius = 0.1f;
        const ShapeDef surface = {.friction = 0, .restitution = seed % 2 != 0 ? 1.0f : 0.0f};
        World world({.gravity = {0, 0}});
        std::vector<Body> balls;
        for (int i = 0; i < 5; ++i) {
            for (int j = 0; j <= i; ++j)
                balls.push_back(world.create_body(
                    {.position = {1.74f * radius * float(i),
                                  2.01f * radius * (float(j) - 0.5f * float(i))}}));
        }
        balls.push_back(
            world.create_body({.position = {-1, random(-0.05f, 0.05f)}, .velocity = {speed, 0}}));
        for (Body& ball : balls) ball.add(Circle{radius}, surface);
        run(world, 10);
        float sum = 0;
        for (const Body& ball : balls) sum += ball.velocity().x;
        INFO("seed " << seed);
        CHECK(sum == Approx(speed).epsilon(0.002));
    }
}

TEST_CASE("what settles falls asleep as soon as it is slow") {
    for (unsigned seed = 0; seed < seeds_or(40); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        Body ground = world.create_body({.type = BodyType::static_body, .angle = -0.01f});
        ground.add(Box{.width = 100, .height = 1, .center = {0, -0.5f}}, rough);
        Body ball = world.create_body({.position = {0, 0.3f}, .velocity = {random(-1, 1), 0}});
        const bool rolls = seed % 2 != 0;
        if (rolls)
            ball.add(Circle{0.3f}, {.friction = 0.9f, .rolling_resistance = random(0.06f, 0.15f)});
        else
            ball.add(Box{.width = 0.6f, .height = 0.6f}, {.friction = random(0.1f, 1)});
        INFO("seed " << seed);
        CHECK(seconds_to_rest(world, 10) < 5);
    }
}

}  // namespace drawn_bodies_test
