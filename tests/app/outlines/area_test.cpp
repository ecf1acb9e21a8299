#include <outlines/area.h>

#include <catch.h>

#include <cmath>
#include <random>

namespace fettle::app {

namespace {

using Points = std::vector<sf::Vector2f>;

std::vector<Trapezoid> cut(const std::vector<Points>& outlines, Area::Rule rule, int rows = 100) {
    Area area;
    for (const Points& outline : outlines) area.add(outline);
    std::vector<Trapezoid> trapezoids;
    area.cut(rule, 0, rows, trapezoids);
    return trapezoids;
}

/// Number of trapezoids that contain the center of the pixel.
int covers(const std::vector<Trapezoid>& trapezoids, int x, int y) {
    const float cx = static_cast<float>(x) + 0.5f, cy = static_cast<float>(y) + 0.5f;
    int count = 0;
    for (const Trapezoid& t : trapezoids) {
        if (cy < t.top || cy > t.bottom) continue;
        const float share = (cy - t.top) / (t.bottom - t.top);
        const float left = t.top_left + share * (t.bottom_left - t.top_left);
        const float right = t.top_right + share * (t.bottom_right - t.top_right);
        count += left <= cx && cx < right;
    }
    return count;
}

/// Winding number of the outlines around a point: the sum of the angles of their edges as seen from
/// the point.
int winding(const std::vector<Points>& outlines, float x, float y) {
    double sum = 0;
    for (const Points& outline : outlines)
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const sf::Vector2f a = outline[i], b = outline[(i + 1) % outline.size()];
            const double ax = a.x - x, ay = a.y - y, bx = b.x - x, by = b.y - y;
            sum += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
        }
    return static_cast<int>(std::lround(sum / 6.283185307));
}

/// Whether the center of a pixel is so near to an edge that rounding decides on which side it is.
bool is_near_edge(const std::vector<Points>& outlines, float x, float y) {
    for (const Points& outline : outlines)
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const sf::Vector2f a = outline[i], edge = outline[(i + 1) % outline.size()] - a;
            const float length = std::hypot(edge.x, edge.y);
            const float across = edge.x * (y - a.y) - edge.y * (x - a.x);
            if (std::abs(across) < 0.01f * length) return true;
        }
    return false;
}

/// Checks each `step`-th of 100 × 100 pixels; returns the number that `inside` covers although the
/// rule excludes them, or the reverse.
int wrong_pixels(const std::vector<Points>& outlines, Area::Rule rule,
                 const std::vector<Trapezoid>& inside, int step = 1) {
    int wrong = 0;
    for (int y = 0; y < 100; y += step)
        for (int x = 0; x < 100; x += step) {
            const float cx = static_cast<float>(x) + 0.5f, cy = static_cast<float>(y) + 0.5f;
            if (is_near_edge(outlines, cx, cy)) continue;
            const int round = winding(outlines, cx, cy);
            const bool expected = rule == Area::Rule::forward ? round > 0 : round != 0;
            wrong += covers(inside, x, y) != (expected ? 1 : 0);
        }
    return wrong;
}

}  // namespace

TEST_CASE("the interior of a box is one trapezoid") {
    const auto inside = cut({{{10, 10}, {50, 10}, {50, 40}, {10, 40}}}, Area::Rule::forward);
    REQUIRE(inside.size() == 1);
    CHECK(inside[0].top == 10);
    CHECK(inside[0].bottom == 40);
    CHECK(inside[0].top_left == Approx(10));
    CHECK(inside[0].bottom_right == Approx(50));
}

TEST_CASE("each pixel inside any outline is covered once and no pixel outside is covered") {
    std::mt19937 generator(GENERATE(range(1u, 40u)));
    std::uniform_real_distribution<float> place(-20, 120);
    std::uniform_int_distribution<int> count(3, 12);
    std::vector<Points> outlines(2);
    for (Points& outline : outlines)
        for (int i = count(generator); i > 0; --i)
            outline.push_back({place(generator), place(generator)});
    const auto rule = GENERATE(Area::Rule::forward, Area::Rule::any_way);
    const auto inside = cut(outlines, rule);
    CHECK(wrong_pixels(outlines, rule, inside) == 0);
}

TEST_CASE("no outline and an outline without area have an empty interior") {
    CHECK(cut({}, Area::Rule::any_way).empty());
    CHECK(cut({{{10, 10}, {50, 10}}}, Area::Rule::any_way).empty());
    for (const Trapezoid& t : cut({{{10, 10}, {50, 40}, {10, 10}}}, Area::Rule::any_way)) {
        CHECK(t.top_right - t.top_left == Approx(0).margin(1e-4));
        CHECK(t.bottom_right - t.bottom_left == Approx(0).margin(1e-4));
    }
    CHECK(cut({{{10, -90}, {50, -90}, {50, -10}}}, Area::Rule::any_way).empty());
}

TEST_CASE("the cost of an outline is proportional to its corners and not to their square") {
    const auto star = [](int corners) {
        Points points;
        for (int i = 0; i < corners; ++i) {
            const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(corners);
            const float radius = i % 2 == 0 ? 400.0f : 300.0f;
            points.push_back({500 + radius * std::cos(angle), 500 + radius * std::sin(angle)});
        }
        return cut({points}, Area::Rule::forward, 1000).size();
    };
    CHECK(star(20'000) < 20 * 20'000);
}

TEST_CASE("an outline with very many crossing edges is filled as exactly as a simple one") {
    std::mt19937 generator(7);
    std::uniform_real_distribution<float> place(-20, 120);
    std::vector<Points> outlines(1);
    for (int i = 0; i < 700; ++i) outlines[0].push_back({place(generator), place(generator)});
    const auto rule = GENERATE(Area::Rule::forward, Area::Rule::any_way);
    const auto inside = cut(outlines, rule);
    CHECK(wrong_pixels(outlines, rule, inside, 3) == 0);
    // The number of spans is limited by the number of pixels, whatever the number of corners.
    for (int i = 0; i < 40'000; ++i) outlines[0].push_back({place(generator), place(generator)});
    CHECK(cut(outlines, rule).size() <= 100 * 71);
}

}  // namespace fettle::app
