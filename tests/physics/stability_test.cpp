#include <iostream>

#include "catch.h"
#include "scenes.h"

using namespace scenes;

TEST_CASE("a stack of twelve boxes stands still to a millimetre a second") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> stack;
    for (int i = 0; i < 12; ++i) stack.push_back(add_box(world, {0, 0.5f + float(i)}));
    run(world, 5.0f);
    double sum = 0.0;
    for (Body box : stack) sum += double(box.velocity().squaredNorm());
    const double jitter = std::sqrt(sum / double(stack.size()));
    std::cout << "12-box stack: jitter " << jitter * 1000.0 << " mm/s\n";
    REQUIRE(jitter < 1e-3);
    REQUIRE(stack.back().position().y() == Approx(11.5f).margin(0.05));
    for (Body box : stack) REQUIRE(std::fabs(box.position().x()) < 0.01f);
}

TEST_CASE("a pyramid of fifteen rows stands") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> boxes;
    for (int i = 0; i < 15; ++i) {
        for (int j = i; j < 15; ++j) {
            boxes.push_back(add_box(
                world, {float(i + 1) * 0.5f + float(j - i) - 7.5f, float(2 * i + 1) * 0.5f}));
        }
    }
    run(world, 6.0f);
    REQUIRE(boxes.back().position().y() == Approx(14.5f).margin(0.1));
    for (Body box : boxes) REQUIRE(std::fabs(box.angle()) < 0.02f);
}

TEST_CASE("boxes that overlap by a quarter are pushed apart without being thrown") {
    World world({.gravity = {0, 0}});
    Body a = add_box(world, {0, 0}), b = add_box(world, {0.75f, 0});
    float fastest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        fastest = std::max({fastest, a.velocity().norm(), b.velocity().norm()});
    }
    REQUIRE(b.position().x() - a.position().x() > 0.98f);
    REQUIRE(fastest <= 3.0f);
    REQUIRE(a.velocity().norm() < 0.5f);
}

TEST_CASE("many circles in a box without gravity come to rest") {
    World world({.gravity = {0, 0}, .bounds = Aabb{{-10, -10}, {10, 10}}});
    std::vector<Body> balls;
    for (int i = 0; i < 25; ++i) {
        for (int k = 0; k < 25; ++k) {
            balls.push_back(
                add_ball(world, {-9.0f + 0.75f * float(i), -9.0f + 0.75f * float(k)}, 0.39f));
        }
    }
    run(world, 12.0f);
    double sum = 0.0;
    for (Body ball : balls) sum += double(ball.velocity().squaredNorm());
    REQUIRE(std::sqrt(sum / double(balls.size())) < 0.05);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a heavy box on a light one does not crush it") {
    World world({.sleeping = false});
    add_floor(world);
    Body light = add_box(world, {0, 0.5f});
    Body heavy = add_box(world, {0, 1.5f}, 1.0f, {.density = 50.0f});
    run(world, 5.0f);
    REQUIRE(heavy.position().y() > 1.4f);
    REQUIRE(light.position().y() > 0.45f);
}
