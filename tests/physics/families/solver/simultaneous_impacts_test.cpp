// A body that meets several others at the same time: what is symmetrical stays symmetrical, and
// elastic bodies keep their energy. FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

namespace simultaneous_impacts_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

Vec2 turned(Vec2 v, float angle) {
    return {std::cos(angle) * v.x - std::sin(angle) * v.y,
            std::sin(angle) * v.x + std::cos(angle) * v.y};
}

Body add_ball(World& world, const Vec2& at, float radius, float density, float restitution) {
    Body ball = world.create_body({.position = at});
    ball.add(Circle{.radius = radius},
             {.density = density, .friction = 0, .restitution = restitution});
    return ball;
}

}  // namespace

TEST_CASE("a ball that meets two others in the middle goes straight on or back") {
    float worst = 0, most_energy = 0;
    for (unsigned seed = 0; seed < seeds_or(100); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {}});
        const float aim = random(-3, 3), speed = random(3, 60), restitution = random(0.01f, 1);
        const float side = random(0.35f, 1.2f), radius = random(0.2f, 0.6f);
        const float reach = 0.5f + radius + random(0, 0.01f);
        const float density = random(0.3f, 3);
        Body balls[2];
        for (const float sign : {-1.0f, 1.0f})
            balls[sign > 0] =
                add_ball(world, turned(reach * Vec2(std::cos(side), sign * std::sin(side)), aim),
                         radius, density, restitution);
        if (radius > reach * std::sin(side)) continue;  // they would overlap
        Body cue = add_ball(world, turned({-random(0.2f, 2), 0}, aim), 0.5f, 1, restitution);
        cue.set_velocity(turned({speed, 0}, aim));
        const float before = cue.kinetic_energy();
        for (int i = 0; i < 60 + int(200 / speed); ++i) world.step(1.0f / 60);
        const Vec2 a = turned(balls[0].velocity(), -aim), b = turned(balls[1].velocity(), -aim);
        const Vec2 c = turned(cue.velocity(), -aim);
        INFO("seed " << seed << ": (" << a.x << ", " << a.y << "), (" << b.x << ", " << b.y << ")");
        const float off = std::max(Vec2(a.x - b.x, a.y + b.y).length(), std::fabs(c.y)) / speed;
        worst = std::max(worst, off);
        float after = cue.kinetic_energy();
        for (const Body& ball : balls) after += ball.kinetic_energy();
        most_energy = std::max(most_energy, after / before);
        CHECK(off < 0.05f);
    }
    std::printf("two balls hit at a time: %.4f of the speed to the side, %.4f of the energy\n",
                double(worst), double(most_energy));
    CHECK(most_energy < 1.005f);
}

// With friction the impulses of several impacts take more rounds to agree. In the rounds that solve
// them one after the other, the first one gets more.
TEST_CASE("a level plank that falls on two blocks leaves straight") {
    float worst = 0;
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        const ShapeDef surface = {.friction = random(0, 1), .restitution = random(0, 1)};
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 40, .height = 2, .center = {0, -1}}, surface);
        const float apart = random(0.8f, 1.3f);
        for (const float side : {-1.0f, 1.0f})
            world.create_body({.position = {side * apart, 0.5f}})
                .add(Box{.width = 0.8f, .height = 1}, surface);
        const float speed = random(4, 15);
        Body plank = world.create_body({.position = {0, 1.9f}, .velocity = {0, -speed}});
        plank.add(Box{.width = 4, .height = 0.4f}, surface);
        float off = 0;
        for (int i = 0; i < 20; ++i) {
            world.step(1.0f / 60);
            off = std::max(
                {off, std::fabs(plank.velocity().x), 2 * std::fabs(plank.angular_velocity())});
        }
        INFO("seed " << seed << ": " << off << " of " << speed << " m/s");
        worst = std::max(worst, off / speed);
        CHECK(off < 0.05f * speed);
    }
    std::printf("planks on two blocks: %.4f of the speed to the side\n", double(worst));
}

TEST_CASE("an impact passes through a row also if an earlier one of its bodies does not happen") {
    for (unsigned seed = 0; seed < seeds_or(50); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {}});
        // The first ball would hit the second one, but a fixed ball turns it away before.
        Body first = add_ball(world, {0, 0}, 0.1f, 1, 1);
        first.set_velocity({2, 0});
        Body fixed = world.create_body({.type = BodyType::static_body,
                                        .position = turned({random(0.151f, 0.153f), 0}, 0.52f)});
        fixed.add(Circle{.radius = 0.05f}, {.friction = 0, .restitution = 1});
        const float x = 0.2f + random(0.006f, 0.01f), gap = random(0.012f, 0.018f);
        Body second = add_ball(world, {x, 0}, 0.1f, 1, 1);
        second.set_velocity({0, -2});
        std::vector<Body> row;
        for (int i = 0; i < 5; ++i)
            row.push_back(add_ball(world, {x, -0.2f - gap - 0.2f * float(i)}, 0.1f, 1, 1));
        world.step(1.0f / 60);
        INFO("seed " << seed << ": the last ball of the row has " << row.back().velocity().y);
        CHECK(row.back().velocity().y < -1.98f);
    }
}

TEST_CASE("a triangle of balls breaks in the same way on both sides") {
    float worst = 0;
    for (unsigned seed = 0; seed < seeds_or(20); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {}});
        const float speed = random(10, 40), restitution = random(0.7f, 1);
        const float pitch = 0.5f * random(1.0005f, 1.003f);
        std::vector<std::vector<Body>> rows(5);
        for (size_t row = 0; row < rows.size(); ++row)
            for (size_t i = 0; i <= row; ++i)
                rows[row].push_back(add_ball(world,
                                             {float(row) * pitch * std::sqrt(3.0f),
                                              2 * pitch * (float(i) - 0.5f * float(row))},
                                             0.5f, 1, restitution));
        Body cue = add_ball(world, {-random(1.5f, 4), 0}, 0.5f, 1, restitution);
        cue.set_velocity({speed, 0});
        for (int i = 0; i < int(600 / speed); ++i) world.step(1.0f / 60);
        for (const std::vector<Body>& row : rows) {
            for (size_t i = 0; i < row.size(); ++i) {
                const Vec2 a = row[i].velocity(), b = row[row.size() - 1 - i].velocity();
                worst = std::max(worst, Vec2(a.x - b.x, a.y + b.y).length() / speed);
            }
        }
        CHECK(std::fabs(cue.velocity().y) < 0.05f * speed);
    }
    std::printf("both sides of a triangle differ by %.4f of the speed\n", double(worst));
    CHECK(worst < 0.05f);
}

TEST_CASE("an elastic ball keeps its speed among bricks") {
    float worst = 0;
    for (unsigned seed = 0; seed < seeds_or(20); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {}});
        const ShapeDef elastic = {.friction = 0, .restitution = 1};
        const float gap = random(0, 0.1f), radius = random(0.15f, 0.4f), speed = random(20, 200);
        Body walls = world.create_body({.type = BodyType::static_body});
        walls.add(Chain{.points = {{-8, 0}, {8, 0}, {8, 16}, {-8, 16}}, .closed = true}, elastic);
        for (float y = 8; y < 12; y += 0.5f + gap)
            for (float x = -6; x < 6; x += 1 + gap)
                walls.add(Box{.width = 1, .height = 0.5f, .center = {x, y}}, elastic);
        Body ball = world.create_body({.position = {0, 3},
                                       .velocity = turned({speed, 0}, random(0.5f, 2.6f)),
                                       .bullet = true});
        ball.add(Circle{.radius = radius}, elastic);
        for (int i = 0; i < 1200; ++i) world.step(1.0f / 60);
        worst = std::max(worst, std::fabs(ball.velocity().length() / speed - 1));
    }
    std::printf("the speed of a ball among bricks changes by %.4f\n", double(worst));
    CHECK(worst < 0.05f);
}

}  // namespace simultaneous_impacts_test
