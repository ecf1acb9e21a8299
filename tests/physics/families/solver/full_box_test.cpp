// A box that is full of circles, under the direct solver: more contacts than it can solve.

#include <algorithm>
#include <limits>
#include <vector>

#include "catch.h"
#include "scenes.h"

namespace full_box_test {

using namespace scenes;

namespace {

/// Circles that overlap by a seventh at first, in a box without gravity that is 80 % full.
std::vector<Body> confine(World& world, int rows) {
    const float half = 0.42f * float(rows);
    Body walls = world.create_body({.type = BodyType::static_body});
    for (const float side : {-1.0f, 1.0f}) {
        walls.add(Box{.width = 2, .height = 2 * half + 4, .center = {side * (half + 1), 0}});
        walls.add(Box{.width = 2 * half + 4, .height = 2, .center = {0, side * (half + 1)}});
    }
    std::vector<Body> circles;
    for (int i = 0; i < rows * rows; ++i) {
        const Vec2 place(float(i % rows), float(i / rows));
        circles.push_back(add_ball(world, 0.72f * (place - Vec2(rows / 2, rows / 2)), 0.42f));
    }
    return circles;
}

/// Between the centers of two circles, m.
float least_distance(const std::vector<Body>& circles) {
    float least = std::numeric_limits<float>::infinity();
    for (size_t i = 0; i < circles.size(); ++i)
        for (size_t k = 0; k < i; ++k)
            least = std::min(least, Vec2(circles[i].position() - circles[k].position()).length());
    return least;
}

}  // namespace

TEST_CASE("a problem that is too hard for the direct solver comes to rest all the same") {
    World world({.gravity = {0, 0}, .sleeping = false, .solver = Solver::direct});
    const std::vector<Body> circles = confine(world, 8);
    bool too_hard = false;
    for (int i = 0; i < 300; ++i) {
        world.step(frame);
        too_hard |= world.statistics().direct_failures > 0;
        // Overlap is left at 3 m/s at most: eight in a row move the outermost by no more than 24.
        REQUIRE(rms_speed(circles) < 24.0f);
    }
    CHECK(too_hard);
    // In double precision, a motion below the resolution of a float goes on.
    CHECK(rms_speed(circles) < (sizeof(Position) > sizeof(Vec2) ? 0.05f : 0.01f));
    for (const Body& circle : circles)
        CHECK(Vec2(circle.position()).abs().largest() < 0.42f * 8 - 0.41f);
    CHECK(least_distance(circles) > 0.83f);
}

TEST_CASE("an island too large for the direct solver comes to rest") {
    World world({.gravity = {0, 0}, .sleeping = false, .solver = Solver::direct});
    const std::vector<Body> circles = confine(world, 25);
    run(world, 1.0f);
    CHECK(rms_speed(circles) < 0.05f);
}

}  // namespace full_box_test
