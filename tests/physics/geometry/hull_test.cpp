#include <fettle/physics/hull.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"

namespace hull_test {

using namespace fettle::physics;

namespace {

bool is_convex_and_counter_clockwise(const std::vector<Vec2>& hull) {
    for (size_t i = 0; i < hull.size(); ++i) {
        const Vec2 a = hull[i], b = hull[(i + 1) % hull.size()], c = hull[(i + 2) % hull.size()];
        const Vec2 u = b - a, v = c - b;
        if (!(u.x * v.y - u.y * v.x > 0.0f)) return false;
    }
    return hull.size() >= 3;
}

}  // namespace

TEST_CASE("a square in any order of its vertices has the same hull") {
    std::vector<Vec2> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::vector<Vec2> first;
    REQUIRE(convex_hull(points, first) == HullStatus::ok);
    REQUIRE(first.size() == 4);
    std::sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.y < b.y; });
    do {
        std::vector<Vec2> hull;
        REQUIRE(convex_hull(points, hull) == HullStatus::ok);
        REQUIRE(hull == first);
    } while (std::next_permutation(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    }));
}

TEST_CASE("a hull drops duplicate points and points inside or on an edge") {
    std::vector<Vec2> hull;
    const std::vector<Vec2> points = {{0, 0}, {2, 0}, {2, 2},       {0, 2}, {1, 1},
                                      {0, 0}, {1, 0}, {0.5f, 1.9f}, {2, 1}, {2, 2}};
    REQUIRE(convex_hull(points, hull) == HullStatus::ok);
    REQUIRE(hull.size() == 4);
    REQUIRE(is_convex_and_counter_clockwise(hull));
}

TEST_CASE("points without an area make no hull and nothing is written") {
    std::vector<Vec2> hull = {{7, 7}};
    using Points = std::vector<Vec2>;
    REQUIRE(convex_hull(Points{}, hull) == HullStatus::too_few_points);
    REQUIRE(convex_hull(Points{{1, 1}, {1, 1}, {1, 1}}, hull) == HullStatus::too_few_points);
    REQUIRE(convex_hull(Points{{0, 0}, {1, 1}}, hull) == HullStatus::too_few_points);
    REQUIRE(convex_hull(Points{{0, 0}, {1, 1}, {2, 2}, {-3, -3}}, hull) == HullStatus::collinear);
    REQUIRE(convex_hull(Points{{0, 0}, {0.1f, 0.3f}, {0.2f, 0.6f}}, hull) == HullStatus::collinear);
    REQUIRE(convex_hull(Points{{0, 0}, {1, NAN}, {2, 2}}, hull) == HullStatus::not_finite);
    REQUIRE(convex_hull(Points{{0, 0}, {1, INFINITY}, {2, 2}}, hull) == HullStatus::not_finite);
    REQUIRE(hull == Points{{7, 7}});
}

TEST_CASE("a thin card is a polygon and not a line") {
    std::vector<Vec2> hull;
    const std::vector<Vec2> card = {
        {-0.2f, -0.001f}, {0.2f, -0.001f}, {0.2f, 0.001f}, {-0.2f, 0.001f}};
    REQUIRE(convex_hull(card, hull) == HullStatus::ok);
    REQUIRE(hull.size() == 4);
}

TEST_CASE("a hull of random points contains them all and is convex") {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-3.0f, 3.0f);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec2> points(size_t(3 + round % 40));
        for (Vec2& p : points) p = {coordinate(random), coordinate(random)};
        std::vector<Vec2> hull;
        if (convex_hull(points, hull) != HullStatus::ok) continue;
        REQUIRE(is_convex_and_counter_clockwise(hull));
        for (const Vec2& p : points) {
            for (size_t i = 0; i < hull.size(); ++i) {
                const Vec2 a = hull[i], e = hull[(i + 1) % hull.size()] - a, r = p - a;
                REQUIRE(e.x * r.y - e.y * r.x > -1e-3f);
            }
        }
    }
}

TEST_CASE("many points on a circle all stay corners") {
    std::vector<Vec2> points, hull;
    for (int i = 0; i < 100; ++i)
        points.emplace_back(std::cos(float(i) * 0.0628318f), std::sin(float(i) * 0.0628318f));
    REQUIRE(convex_hull(points, hull) == HullStatus::ok);
    REQUIRE(hull.size() == 100);
}

}  // namespace hull_test
