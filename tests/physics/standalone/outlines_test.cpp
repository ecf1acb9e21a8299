#include <fettle/physics/outlines.h>
#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "catch.h"

namespace outlines_test {

using namespace fettle::physics;

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

TEST_CASE("lines that form a ring are a closed chain of the requested direction") {
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

namespace {

/// The algorithm of Douglas and Peucker as it was published, which visits all points between two
/// corners.
void keep_corners(const std::vector<Vec2>& points, size_t begin, size_t end, float straight,
                  std::vector<bool>& kept) {
    float farthest = straight * straight;
    size_t corner = begin;
    const Vec2 from = points[begin], way = points[end] - from;
    for (size_t i = begin + 1; i < end; ++i) {
        const Vec2 p = points[i] - from;
        const float whole = way.dot(way);
        const float t = whole > 0 ? std::clamp(p.dot(way) / whole, 0.0f, 1.0f) : 0;
        const float squared = (p - t * way).length_squared();
        if (squared > farthest) farthest = squared, corner = i;
    }
    if (corner == begin) return;
    kept[corner] = true;
    keep_corners(points, begin, corner, straight, kept);
    keep_corners(points, corner, end, straight, kept);
}

/// A way of which each stroke is shorter than the one before, in any direction.
std::vector<Vec2> zigzag(int count, float angle) {
    std::vector<Vec2> points;
    const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    for (int i = 0; i < count; ++i) {
        const float height = (i % 2 == 0 ? 1.0f : -1.0f) * (2.0f - float(i) / float(count));
        points.push_back(0.1f * float(i) * along + height * across);
    }
    return points;
}

}  // namespace

TEST_CASE("a simplified line keeps the points that a search of all points keeps") {
    std::mt19937 random(3);
    const auto number = [&random] { return float(random() % 2001) / 1000 - 1; };
    for (int run = 0; run < 60; ++run) {
        std::vector<Vec2> points;
        Vec2 at;
        const int count = 3 + int(random() % 700);
        for (int i = 0; i < count; ++i) {
            if (run % 3 == 0) at = {0.05f * float(i), number()};
            if (run % 3 == 1) at += Vec2(number(), number());
            if (run % 3 == 2) at = {std::sin(0.02f * float(i)), std::cos(0.02f * float(i)) * at.x};
            points.push_back(at);
        }
        CAPTURE(run, count);
        for (const float straight : {0.0f, 0.03f, 0.5f}) {
            std::vector<bool> kept(points.size());
            kept.front() = kept.back() = true;
            keep_corners(points, 0, points.size() - 1, straight, kept);
            std::vector<Vec2> expected;
            for (size_t i = 0; i < points.size(); ++i)
                if (kept[i]) expected.push_back(points[i]);
            REQUIRE(without_straight_points(points, false, straight) == expected);
        }
    }
}

TEST_CASE("lines of a hundred thousand strokes are made simpler and joined in seconds") {
    // Each search of all points would be 10^10 steps, which take minutes.
    for (const float angle : {0.0f, 0.7f}) {
        const std::vector<Vec2> points = zigzag(200'000, angle);
        CHECK(without_straight_points(points, false, 0.01f).size() == points.size());
        CHECK(without_straight_points(points, true, 0.01f).size() == points.size());
        CHECK(without_straight_points(points, false, 5.0f).size() == 2);
    }
    Lines star, near, column;
    for (int i = 0; i < 100'000; ++i) {
        const float angle = 6.28f * float(i) / 100'000;
        const Vec2 out(std::cos(angle), std::sin(angle));
        star.push_back({{0, 0}, 1000.0f * out});
        near.push_back({4e-4f * out, 1000.0f * out});
        column.push_back({{0, 0.01f * float(i)}, {1, 0.01f * float(i)}});
    }
    CHECK(join_lines(star).size() == 50'000);
    CHECK(join_lines(near).size() == 50'000);
    CHECK(join_lines(column).size() == 100'000);
}

TEST_CASE("where many ends meet the nearest are joined and then those of the same direction") {
    const Lines equal = {{{-1, 0}, {0, 0}}, {{-1, 1}, {0, 0}}, {{0, 0}, {1, 0}}, {{0, 0}, {1, 1}}};
    const auto pairs = join_lines(equal);
    REQUIRE(pairs.size() == 2);
    CHECK(pairs[0].points == std::vector<Vec2>{{-1, 0}, {1, 0}});
    CHECK(pairs[1].points == std::vector<Vec2>{{-1, 1}, {0, 0}, {1, 1}});
    const Lines nearer = {{{-1, 0}, {0, 0}}, {{0.05f, 0}, {1, 1}}, {{1, -1}, {0.02f, 0}}};
    const auto chains = join_lines(nearer, {.reach = 0.1f});
    REQUIRE(chains.size() == 2);
    CHECK(chains[0].points.back() == Vec2(1, -1));
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

TEST_CASE("invalid grids are refused") {
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
