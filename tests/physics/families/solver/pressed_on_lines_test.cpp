// Thin bodies that a pile, wind or a load presses on a line of two sides, on a chain, and on a box.
// FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace pressed_on_lines_test {

using namespace fettle::physics;

Geometry thin_shape(families::Random& random, int kind) {
    const float length = random(0.25f, 0.5f), half = random(0.008f, 0.012f);
    if (kind == 0) return Box{.width = length, .height = 2 * half};
    if (kind == 1)
        return Segment{.from = {-0.5f * length, 0}, .to = {0.5f * length, 0}, .rounding = half};
    return Ellipse{.radius_x = 0.5f * length, .radius_y = half};
}

int count_below(bool chain) {
    const int seeds = int(families::seeds_or(50));
    int below = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        if (chain)
            ground.add(Chain{.points = {{-200, 0}, {200, 0}}});
        else
            ground.add(Segment{.from = {-200, 0}, .to = {200, 0}});
        Body thin = world.create_body({.position = {0, random(0.1f, 0.4f)}});
        thin.add(thin_shape(random, seed % 3), {.friction = 0});
        for (int i = 0; i < 6; ++i) {
            Body load =
                world.create_body({.position = {random(-0.3f, 0.3f), 0.8f + 0.5f * float(i)},
                                   .angle = random(-3, 3)});
            load.add(Box{.width = 0.4f, .height = 0.4f},
                     {.density = random(0.3f, 1), .friction = 0});
        }
        const float dt = random(1.0f / 60, 1.0f / 40);
        for (int step = 0; step < 200; ++step) world.step(dt);
        if (thin.position().y < -0.005f) ++below;
    }
    return below;
}

TEST_CASE("thin bodies under a pile stay on a line of two sides") {
    const int lost = count_below(false);
    std::printf("thin bodies under piles: %d below the line\n", lost);
    // A blow of a hundred times its mass may still press one through.
    CHECK(lost <= int(families::seeds_or(50)) / 20);
}

TEST_CASE("thin bodies under a pile stay on a chain") {
    const int lost = count_below(true);
    std::printf("thin bodies under piles: %d below the chain\n", lost);
    // A blow of a hundred times its mass may still press one through.
    CHECK(lost <= int(families::seeds_or(50)) / 20);
}

TEST_CASE("thin ellipses that fall on a chain of slopes in long steps stay on it") {
    const int seeds = int(families::seeds_or(200));
    int below = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world;
        Chain slopes;
        for (int i = -10; i <= 10; ++i) slopes.points.push_back({2.0f * float(i), random(-1, 0)});
        slopes.points.front().y = slopes.points.back().y = 20;
        world.create_body({.type = BodyType::static_body}).add(slopes);
        Body thin = world.create_body({.position = {random(-15, 15), random(2, 5)}});
        thin.add(Ellipse{.radius_x = random(0.1f, 0.3f), .radius_y = random(0.005f, 0.012f)});
        const float dt = 1.0f / random(20, 60);
        for (int step = 0; step < int(4 / dt); ++step) world.step(dt);
        if (thin.position().y < -1.1f) ++below;
    }
    std::printf("thin ellipses on slopes: %d below the chain\n", below);
    CHECK(below == 0);
}

/// A thin ellipse lies on the ground. Wind presses it, or what falls on it does. Returns how deep
/// its center gets below the ground.
float depth_of_pressed(unsigned seed, bool in_wind) {
    families::Random random{std::mt19937(seed)};
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    const float kind = random(0, 3);
    if (kind < 1)
        ground.add(Box{.width = 40, .height = 2, .center = {0, -1}});
    else if (kind < 2)
        ground.add(Chain{.points = {{-20, 0}, {-5, 0}, {0, 0}, {5, 0}, {20, 0}}});
    else
        ground.add(Segment{{-20, 0}, {20, 0}});
    const auto thin_at = [&](float height) {
        Body thin =
            world.create_body({.position = {0, height}, .angle = in_wind ? random(-3, 3) : 0.0f});
        thin.add(Ellipse{.radius_x = random(0.1f, 0.3f), .radius_y = random(0.005f, 0.015f)},
                 {.density = random(0.2f, 3), .friction = random(0, 1)});
        return thin;
    };
    Body thin = thin_at(random(0.1f, 0.6f));
    if (in_wind)
        world.create_field(
            {.force = WindField{.velocity = {random(-3, 3), random(-15, -3)}, .density = 1.2f}});
    const float dt = 1.0f / random(30, 60);
    float depth = 0;
    for (int step = 0; step < int(5 / dt); ++step) {
        if (step == int(1 / dt) && !in_wind) {
            if (random(0, 1) < 0.3f)
                thin_at(0.5f);
            else
                world.create_body({.position = {random(-0.2f, 0.2f), 1}})
                    .add(Box{.width = random(0.1f, 1), .height = random(0.02f, 1)});
        }
        world.step(dt);
        if (std::fabs(thin.position().x) > 19)
            break;  // the wind has blown it to the end of the ground
        depth = std::max(depth, -float(thin.position().y));
    }
    return depth;
}

TEST_CASE("thin ellipses that wind or a load presses on the ground stay above it") {
    for (const bool in_wind : {true, false}) {
        const unsigned seeds = families::seeds_or(150);
        float deepest = 0;
        unsigned below = 0;
        for (unsigned seed = 0; seed < seeds; ++seed) {
            const float depth = depth_of_pressed(seed + 1, in_wind);
            deepest = std::max(deepest, depth);
            if (depth > 0.004f) ++below;
        }
        std::printf("thin ellipses under %s: %u of %u below the ground, at most %.4f m\n",
                    in_wind ? "wind" : "a load", below, seeds, double(deepest));
        CHECK(below == 0);
    }
}

}  // namespace pressed_on_lines_test
