// Thin bodies that a pile presses on a line of two sides, and on a chain. FETTLE_SEEDS=n: n piles.

#include <fettle/physics/physics.h>

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

int below(bool chain) {
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
    const int lost = below(false);
    std::printf("thin bodies under piles: %d below the line\n", lost);
    // A blow of a hundred times its mass may still press one through.
    CHECK(lost <= int(families::seeds_or(50)) / 20);
}

TEST_CASE("thin bodies under a pile stay on a chain") {
    const int lost = below(true);
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
    // One in a hundred is still pressed through while it rocks: it touches in one point only.
    CHECK(50 * below <= seeds);
}

}  // namespace pressed_on_lines_test
