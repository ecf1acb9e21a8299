#include <fettle/physics/outlines.h>
#include <fettle/physics/physics.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "catch.h"

namespace outlines_test {

using namespace fettle::physics;
using Catch::Detail::Approx;

namespace {

float area_of(const Chain& chain) {
    float twice = 0.0f;
    for (size_t i = 0; i < chain.points.size(); ++i) {
        const Vec2 a = chain.points[i], b = chain.points[(i + 1) % chain.points.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5f * twice;
}

using Lines = std::vector<std::vector<Vec2>>;

}  // namespace

TEST_CASE("lines in any order and direction are one chain") {
    const Lines lines = {{{2, 0}, {3, 1}}, {{1, 0}, {0, 0}}, {{1, 0}, {2, 0}}, {{3, 1}, {4, 1}}};
    const auto chains = join_lines(lines);
    REQUIRE(chains.size() == 1);
    CHECK_FALSE(chains[0].closed);
    CHECK(chains[0].points == std::vector<Vec2>{{0, 0}, {2, 0}, {3, 1}, {4, 1}});
}

TEST_CASE("lines that meet all round are a closed chain of the wanted direction") {
    const Lines lines = {{{0, 0}, {1, 0}}, {{1, 1}, {0, 1}}, {{1, 1}, {1, 0}}, {{0, 1}, {0, 0}}};
    for (const auto& [winding, area] : {std::pair(Winding::as_given, 1.0f),
                                        {Winding::clockwise, -1.0f},
                                        {Winding::counter_clockwise, 1.0f}}) {
        const auto chains = join_lines(lines, {.closed = winding});
        REQUIRE(chains.size() == 1);
        CHECK(chains[0].closed);
        CHECK(chains[0].points.size() == 4);
        CHECK(area_of(chains[0]) == Approx(area));
    }
}

TEST_CASE("ends are joined within reach only") {
    const Lines lines = {{{0, 0}, {1, 0}}, {{1.05f, 0}, {2, 1}}};
    CHECK(join_lines(lines).size() == 2);
    CHECK(join_lines(lines, {.reach = 0.1f}).size() == 1);
}

TEST_CASE("nearly straight points are dropped") {
    std::vector<Vec2> points;
    for (int i = 0; i <= 100; ++i)
        points.emplace_back(0.1f * float(i), 0.001f * std::sin(float(i)));
    points.emplace_back(10, 3);
    const auto kept = without_straight_points(points, false, 0.01f);
    CHECK(kept.size() == 3);
    CHECK(kept.front() == points.front());
    CHECK(kept.back() == points.back());
    const std::vector<Vec2> square = {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2.001f}, {0, 2}, {0, 1}};
    CHECK(without_straight_points(square, true, 0.01f).size() == 4);
    CHECK(without_straight_points(square, true, 0.0f).size() == 5);
}

TEST_CASE("lines that shrink to a point are dropped") {
    const Lines lines = {{}, {{1, 1}}, {{2, 2}, {2, 2}}};
    CHECK(join_lines(lines).empty());
}

TEST_CASE("the outline of one cell is an island") {
    const bool cells[] = {true};
    const auto chains = grid_outlines(cells, {.columns = 1, .rows = 1, .origin = {2, 3}});
    REQUIRE(chains.size() == 1);
    CHECK(chains[0].closed);
    CHECK(area_of(chains[0]) == Approx(-0.5f));
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(chains[0]);
    Body ball = world.create_body({.position = {2, 4.2f}});
    ball.add(Circle{0.1f});
    for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
    CHECK(ball.position().y > 3.4f);  // it lies on the corner or slides off it, but not inside
}

TEST_CASE("an area with a hole has two outlines of opposite direction") {
    bool cells[25];
    for (int i = 0; i < 25; ++i) cells[i] = i != 12;
    const auto chains = grid_outlines(cells, {.columns = 5, .rows = 5, .cell = 2.0f});
    REQUIRE(chains.size() == 2);
    CHECK(area_of(chains[0]) < 0.0f);
    CHECK(area_of(chains[1]) == Approx(2.0f));
    // Both at once: all edges of all cells lie between a filled and an empty sample.
    CHECK(area_of(chains[0]) == Approx(-(100.0f - 2.0f)));
}

TEST_CASE("the outline of a round hill is a circle") {
    std::vector<float> values;
    for (int row = 0; row < 41; ++row)
        for (int column = 0; column < 41; ++column)
            values.push_back(1.5f - 0.1f * std::hypot(float(row - 20), float(column - 20)));
    const auto chains =
        grid_outlines(values, {.columns = 41, .rows = 41, .origin = {-2, -2}, .cell = 0.1f}, 0.0f);
    REQUIRE(chains.size() == 1);
    for (const Vec2& p : chains[0].points) CHECK(p.length() == Approx(1.5f).margin(0.002));
    CHECK(-area_of(chains[0]) == Approx(3.14159f * 2.25f).epsilon(0.01));
}

TEST_CASE("areas that meet at a corner are joined if the mean is filled") {
    const float apart[] = {1, 0, 0, 1};
    CHECK(grid_outlines(apart, {.columns = 2, .rows = 2}, 0.6f).size() == 2);
    CHECK(grid_outlines(apart, {.columns = 2, .rows = 2}, 0.4f).size() == 1);
}

TEST_CASE("outlines of random grids are chains that a shape takes") {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        const uint32_t columns = 1 + uint32_t(random() % 9), rows = 1 + uint32_t(random() % 9);
        std::vector<float> values;
        float filled = 0.0f;
        for (uint32_t i = 0; i < columns * rows; ++i) {
            values.push_back(float(random() % 2));
            filled += values.back();
        }
        World world;
        Body body = world.create_body({.type = BodyType::static_body});
        float area = 0.0f;
        for (const Chain& chain : grid_outlines(values, {.columns = columns, .rows = rows})) {
            body.add(chain);
            area -= area_of(chain);
        }
        CHECK(area >= 0.5f * filled - 1e-3f);
        CHECK(area <= filled + 0.5f * float(columns * rows));
    }
}

TEST_CASE("grids that cannot be are refused") {
    const std::vector<float> values(6);
    CHECK_THROWS_AS(grid_outlines(values, {.columns = 2, .rows = 2}), std::invalid_argument);
    CHECK_THROWS_AS(grid_outlines(values, {.columns = 3, .rows = 2, .cell = 0.0f}),
                    std::invalid_argument);
    const float bad[] = {std::nanf("")};
    CHECK_THROWS_AS(grid_outlines(bad, {.columns = 1, .rows = 1}), std::invalid_argument);
    CHECK(grid_outlines(std::span<const float>(), {}).empty());
    CHECK_THROWS_AS(join_lines({}, {.reach = -1.0f}), std::invalid_argument);
    const Lines far = {{{0, 0}, {1e7f, 0}}};
    CHECK_THROWS_AS(join_lines(far), std::invalid_argument);
}

}  // namespace outlines_test
