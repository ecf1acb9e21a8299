// Bounces of single bodies with nothing else about: off a bat that moves, and on a corner. Speed
// and spin must be those of one impact, wherever in a step it happens.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

namespace free_bounces_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

const float rates[] = {30, 60, 144};

/// The kinetic energy, J.
double motion_of(const std::vector<Body>& bodies) {
    double sum = 0;
    for (const Body& body : bodies)
        sum += 0.5 * double(body.mass() * body.velocity().length_squared() +
                            body.inertia() * body.angular_velocity() * body.angular_velocity());
    return sum;
}

}  // namespace

TEST_CASE("a body bounces off a bat that moves as off one that rests") {
    for (unsigned seed = 0; seed < seeds_or(300); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = rates[seed % 3], restitution = random(0.2f, 1);
        const float speed = random(-2, 10), own = speed - random(2, 12), gap = random(0.5f, 3);
        const ShapeDef surface = {.friction = 0, .restitution = restitution};
        World world({.gravity = {0, 0}});
        Body bat = world.create_body({.type = BodyType::kinematic_body, .velocity = {speed, 0}});
        bat.add(Box{.width = 0.4f, .height = 2}, surface);
        Body body = world.create_body({.position = {0.4f + gap, 0}, .velocity = {own, 0}});
        if (seed % 2)
            body.add(Circle{0.2f}, surface);
        else
            body.add(Box{.width = 0.4f, .height = 0.4f}, surface);
        const int steps = int((gap / (speed - own) + 0.1f) * rate);
        for (int i = 0; i < steps; ++i) world.step(1 / rate);
        const float wanted = speed + restitution * (speed - own);
        INFO("seed " << seed << ", " << rate << " steps a second");
        CHECK(std::fabs(body.velocity().x - wanted) < 0.01f * (wanted - speed));
    }
}

TEST_CASE("a box that lands on a corner keeps its energy") {
    for (const float rate : rates) {
        double least = 1, sum = 0;
        const unsigned count = seeds_or(100);
        for (unsigned seed = 0; seed < count; ++seed) {
            Random random{std::mt19937(seed)};
            const ShapeDef elastic = {.friction = 0, .restitution = 1};
            World world({.gravity = {0, 0}});
            world.create_body({.type = BodyType::static_body})
                .add(Box{.width = 20, .height = 1, .center = {0, -0.5f}}, elastic);
            const float speed = random(2, 8), height = random(0.8f, 2);
            Body box = world.create_body({.position = {0, height},
                                          .angle = random(0.05f, 1.5f),
                                          .velocity = {0, -speed},
                                          .angular_velocity = random(-6, 6)});
            box.add(Box{.width = 1, .height = random(0.2f, 1)}, elastic);
            const double before = motion_of({box});
            for (int i = 0; i < int((height / speed + 0.6f) * rate); ++i) world.step(1 / rate);
            const double kept = motion_of({box}) / before;
            least = std::min(least, kept);
            sum += kept;
            CHECK(kept < 1.001);
        }
        std::printf("corner bounces, %.0f Hz: %.3f of the energy kept in the mean, at least %.3f\n",
                    double(rate), sum / count, least);
        CHECK(sum / count > 0.98);
        CHECK(least > 0.9);
    }
}

TEST_CASE("boxes without friction in a closed room keep most of their energy") {
    double least = 1;
    for (unsigned seed = 0; seed < seeds_or(12); ++seed) {
        Random random{std::mt19937(seed)};
        const ShapeDef elastic = {.friction = 0, .restitution = 1};
        World world({.gravity = {0, 0}});
        Body room = world.create_body({.type = BodyType::static_body});
        for (const float side : {-1.0f, 1.0f}) {
            room.add(Box{.width = 24, .height = 2, .center = {0, 11 * side}}, elastic);
            room.add(Box{.width = 2, .height = 24, .center = {11 * side, 0}}, elastic);
        }
        std::vector<Body> boxes;
        for (int i = 0; i < 36; ++i) {
            const Vec2 place = {-7.5f + 3 * float(i % 6), -7.5f + 3 * float(i / 6)};
            boxes.push_back(
                world.create_body({.position = place, .velocity = {random(-5, 5), random(-5, 5)}}));
            boxes.back().add(Box{.width = random(0.5f, 1), .height = random(0.5f, 1)}, elastic);
        }
        const double before = motion_of(boxes);
        for (int i = 0; i < 600; ++i) world.step(1.0f / 60);
        least = std::min(least, motion_of(boxes) / before);
    }
    std::printf("a gas of boxes keeps at least %.3f of its energy for ten seconds\n", least);
    CHECK(least > 0.95);
}

TEST_CASE("a row of touching balls passes a blow on at any step rate") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = seed % 4 == 3 ? 240 : rates[seed % 4];
        const int count = 2 + int(seed % 5);
        const float radius = random(0.1f, 1), speed = random(1.5f, 8), gap = random(0.2f, 2);
        const ShapeDef elastic = {.friction = 0, .restitution = 1};
        World world({.gravity = {0, 0}});
        std::vector<Body> balls;
        for (int i = 0; i <= count; ++i) {
            const float x = 2 * radius * float(i) + (i > 0 ? gap : 0);
            balls.push_back(
                world.create_body({.position = {x, 0}, .velocity = {i > 0 ? 0 : speed, 0}}));
            balls.back().add(Circle{radius}, elastic);
        }
        for (int i = 0; i < int((gap / speed + 0.1f) * rate); ++i) world.step(1 / rate);
        INFO("seed " << seed << ", " << rate << " steps a second");
        CHECK(std::fabs(balls.back().velocity().x - speed) < 0.01f * speed);
        CHECK(std::fabs(balls.front().velocity().x) < 0.1f * speed);
    }
}

}  // namespace free_bounces_test
