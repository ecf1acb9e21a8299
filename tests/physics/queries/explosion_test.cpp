#include <cmath>
#include <stdexcept>

#include "catch.h"
#include "scenes.h"

namespace explosion_test {

using namespace scenes;

TEST_CASE("an explosion gives an impulse for each meter that faces it") {
    World world({.gravity = {0, 0}});
    Body small = add_box(world, {3, 0}, 1.0f), large = add_box(world, {-4, 0}, 2.0f);
    Body ball = add_ball(world, {0, 3}, 0.75f);
    world.explode({.point = {0, 0}, .radius = 10, .impulse_per_length = 5});
    CHECK(small.velocity().x * small.mass() == Approx(5 * 1.0f));
    CHECK(large.velocity().x * large.mass() == Approx(-5 * 2.0f));
    CHECK(ball.velocity().y * ball.mass() == Approx(5 * 1.5f));
    CHECK(small.velocity().y == Approx(0).margin(1e-5));
}

TEST_CASE("the impulse falls to nothing beyond the radius") {
    World world({.gravity = {0, 0}});
    std::vector<Body> balls;
    for (const float x : {1.5f, 2.5f, 3.5f, 4.6f}) balls.push_back(add_ball(world, {x, 0}, 0.5f));
    world.explode({.radius = 2, .falloff = 2, .impulse_per_length = 8});
    const auto impulse = [&](size_t i) { return balls[i].velocity().x * balls[i].mass(); };
    CHECK(impulse(0) == Approx(8));
    CHECK(impulse(1) == Approx(8));
    CHECK(impulse(2) == Approx(4));
    CHECK(impulse(3) == 0);
}

TEST_CASE("an explosion beside the middle of a body turns it") {
    World world({.gravity = {0, 0}});
    Body beam = world.create_body({.position = {3, 0}});
    beam.add(Box{.width = 1, .height = 6});
    world.explode({.point = {0, 2}, .radius = 5, .impulse_per_length = 1});
    CHECK(beam.velocity().x > 0);
    CHECK(beam.angular_velocity() < 0);
}

TEST_CASE("an outline counts once and a negative impulse pulls") {
    World world({.gravity = {0, 0}});
    Body star = world.create_body({.position = {5, 0}});
    star.add(Concave{{{-1, -1}, {1, -1}, {1, 1}, {0.9f, 1}, {0.9f, -0.9f}, {-1, -0.9f}}});
    world.explode({.radius = 10, .impulse_per_length = -3});
    // Seen from the center, the L is two meters high, across the way to its nearest point.
    const float impulse = star.velocity().length() * star.mass();
    CHECK(impulse == Approx(3 * 2.0f).epsilon(0.25));
    CHECK(star.velocity().x < 0);
}

TEST_CASE("bodies around the center are pushed away from it") {
    World world({.gravity = {0, 0}});
    Body box = add_box(world, {0.2f, 0});
    world.explode({.impulse_per_length = 2});
    CHECK(box.velocity().x * box.mass() == Approx(2));
    Body centered = add_box(world, {20, 0});
    world.explode({.point = {20, 0}, .impulse_per_length = 2});
    CHECK(centered.velocity().length() > 1);
}

TEST_CASE("an explosion wakes bodies and pushes only those that the filter accepts") {
    World world;
    add_floor(world);
    Body asleep = add_box(world, {0, 0.5f}), other = add_box(world, {3, 0.5f});
    run(world, 2.0f);
    REQUIRE_FALSE(asleep.awake());
    world.explode({.point = {-1, 0}, .radius = 10},
                  {.accept = [&](const Shape& shape) { return shape.body() == asleep; }});
    CHECK(asleep.awake());
    CHECK(asleep.velocity().x > 0);
    CHECK_FALSE(other.awake());
}

TEST_CASE("an invalid explosion is refused and pushes nothing") {
    World world({.gravity = {0, 0}});
    Body box = add_box(world, {1, 0});
    const float nan = std::nanf("");
    CHECK_THROWS_AS(world.explode({.point = {nan, 0}}), std::invalid_argument);
    CHECK_THROWS_AS(world.explode({.radius = -1}), std::invalid_argument);
    CHECK_THROWS_AS(world.explode({.falloff = nan}), std::invalid_argument);
    CHECK_THROWS_AS(world.explode({.impulse_per_length = infinity}), std::invalid_argument);
    CHECK(box.velocity().length() == 0);
}

}  // namespace explosion_test
