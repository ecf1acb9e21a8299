#include <outlines/visible_area.h>

#include <catch.h>

#include <cmath>

namespace fettle::app {

namespace {

using Point = VisibleArea::Point;

const VisibleArea visible({-20, -20}, {1300, 820});

/// Largest distance between the outline and a circle within the visible part.
double farthest_from_circle(const std::vector<Point>& outline, const Point& center, double radius) {
    double worst = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point &from = outline[i], &to = outline[(i + 1) % outline.size()];
        for (int k = 0; k <= 8; ++k) {
            const Point p = from + k / 8.0 * (to - from);
            if (p.x < 0 || p.y < 0 || p.x > 1280 || p.y > 800) continue;
            worst = std::max(worst, std::abs((p - center).length() - radius));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("a circle that is much larger than the screen is round in the visible part") {
    const double radius = GENERATE(300.0, 5e3, 1e6, 1e9, 1e12);
    const double angle = GENERATE(0.0, 0.3, 1.6, 4.0);
    const Point on_rim(600, 380);
    const Point center = on_rim + radius * Point(std::cos(angle), std::sin(angle));
    const std::vector<Point> outline = visible.rounded({&center, 1}, radius);
    CHECK(outline.size() < 2000);
    CHECK(farthest_from_circle(outline, center, radius) < 0.06 + 1e-15 * radius);
}

TEST_CASE("the edges made by cutting are outside the screen") {
    const Point center(640, 1e6 + 400);
    std::vector<Point> outline = visible.rounded({&center, 1}, 1e6);
    visible.cut(outline);
    REQUIRE(outline.size() >= 3);
    double lowest = 1e9;
    for (const Point& p : outline) {
        CHECK(p.x >= -20.001);
        CHECK(p.x <= 1300.001);
        CHECK(p.y >= -20.001);
        CHECK(p.y <= 820.001);
        lowest = std::min(lowest, p.y);
    }
    CHECK(lowest == Approx(400).margin(0.3));
}

TEST_CASE("a figure that contains the screen covers it and a figure outside is dropped") {
    const Point center(640, 5e5);
    std::vector<Point> around = visible.rounded({&center, 1}, 1e6);
    visible.cut(around);
    CHECK(around.size() >= 4);
    std::vector<Point> elsewhere{{2000, 2000}, {1e7, 2000}, {1e7, 1e7}};
    visible.cut(elsewhere);
    CHECK(elsewhere.size() < 3);
}

TEST_CASE("a long line is cut and keeps its direction") {
    Point from(-1e9, 400 - 1e8), to(1e9, 400 + 1e8);
    REQUIRE(visible.cut(from, to));
    CHECK(from.x == Approx(-20));
    CHECK(from.y == Approx(398));
    CHECK(to.x == Approx(1300));
    CHECK(to.y == Approx(530));
    Point a(-100, 0), b(-50, 1000);
    CHECK_FALSE(visible.cut(a, b));
    Point still(5, 5), same(5, 5);
    CHECK(visible.cut(still, same));
}

TEST_CASE("the rounding of a line or a polygon keeps its distance") {
    const std::vector<Point> line{{100, 400}, {5e5, 400}};
    for (const Point& p : visible.rounded(line, 2000)) {
        const double past = std::max({100 - p.x, p.x - 5e5, 0.0});
        CHECK(std::hypot(past, p.y - 400) == Approx(2000).epsilon(1e-6));
    }
    const std::vector<Point> box{{0, 0}, {9000, 0}, {9000, 9000}, {0, 9000}};
    for (const Point& p : visible.rounded(box, 1500)) {
        const double dx = std::max({-p.x, p.x - 9000, 0.0});
        const double dy = std::max({-p.y, p.y - 9000, 0.0});
        CHECK(std::hypot(dx, dy) == Approx(1500).epsilon(1e-6));
    }
}

}  // namespace fettle::app
