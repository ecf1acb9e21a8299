// Worlds in which most bodies stand still: the work of a step depends on those that move.

#include <broad_phase/tree.h>
#include <fettle/physics/physics.h>
#include <wide/kernels.h>

#include <cmath>
#include <vector>

#include "catch.h"

namespace still_worlds_family_test {

using namespace fettle::physics;
using namespace fettle::physics::detail;

namespace {

int compared = 0;

void count_and_compare(const BucketBoxes& a, uint32_t count, const BucketBoxes& b, uint32_t* rows) {
    ++compared;
    wide_kernels(4).overlaps(a, count, b, rows);
}

Box4 box_at(float x, float y) {
    return {{x - 0.3f, y - 0.3f}, {x + 0.3f, y + 0.3f}};
}

TEST_CASE("movers that are far apart are compared with few of the boxes that stand still") {
    for (const int movers : {2, 4, 16, 60}) {
        Tree moving, fixed;
        for (int i = 0; i < 200; ++i)
            for (int j = 0; j < 100; ++j) fixed.insert(box_at(float(i), float(j)), uint32_t(i));
        for (int i = 0; i < movers; ++i)
            moving.insert(box_at(200.0f * float(i) / float(movers), float(i * 37 % 100)),
                          uint32_t(i));
        moving.rebuild();
        fixed.rebuild();
        fixed.clear_moves();
        int found = 0, expected = 0;
        compared = 0;
        moving.pairs(fixed, count_and_compare, [&](uint32_t, uint32_t) { ++found; });
        for (int i = 0; i < movers; ++i)
            fixed.query(box_at(200.0f * float(i) / float(movers), float(i * 37 % 100)),
                        [&](uint32_t) { ++expected; });
        CAPTURE(movers);
        CHECK(found == expected);
        CHECK(compared <= 8 * movers);
    }
}

TEST_CASE("an edit of the filter of a long chain finds and ends pairs") {
    World world;
    std::vector<Vec2> points;
    for (int i = 0; i <= 2000; ++i) points.emplace_back(float(1000 - i), 0.0f);
    Body ground = world.create_body({.type = BodyType::static_body, .position = {3, 1}});
    // In the order from left to right the chain is solid below.
    std::vector<Vec2> forward(points.rbegin(), points.rend());
    Shape chain = ground.add(Chain{forward});
    std::vector<Body> balls;
    for (int i = 0; i < 5; ++i) {
        balls.push_back(world.create_body({.position = {200.0f * float(i) - 400, 1.5f}}));
        balls.back().add(Circle{0.5f});
    }
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) world.step(1.0f / 60);
    };
    const auto all_lie = [&](float height) {
        for (const Body& ball : balls)
            if (std::abs(ball.position().y - height) > 0.05f) return false;
        return true;
    };
    run(30);
    CHECK(all_lie(1.5f));
    chain.set_friction(0.1f);
    chain.set_density(3.0f);
    run(30);
    CHECK(all_lie(1.5f));
    chain.set_mask(2);
    run(1);
    CHECK(world.statistics().contacts == 0);
    chain.set_mask(~uint64_t{0});
    run(30);
    CHECK(all_lie(1.5f));
    chain.set_sensor(true);
    run(1);
    CHECK(world.events().sensor_begin.size() == 5);
    CHECK_FALSE(world.validate());
}

TEST_CASE("a platform that stands still is left where it is") {
    World world;
    Body platform = world.create_body({.type = BodyType::kinematic_body});
    for (int i = 0; i < 20; ++i) platform.add(Box{.center = {float(i), 0}});
    Body box = world.create_body({.position = {5, 1}});
    box.add(Box{});
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
    CHECK(std::abs(box.position().y - 1.0f) < 0.01f);
    platform.set_velocity({0, 1});
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
    CHECK(std::abs(box.position().y - 2.0f) < 0.05f);
    platform.set_velocity({0, 0});
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
    CHECK(std::abs(box.position().y - platform.position().y - 1.0f) < 0.01f);
}

}  // namespace

}  // namespace still_worlds_family_test
