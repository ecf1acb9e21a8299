#include <outlines/outline.h>

#include <catch.h>

#include <cmath>

namespace fettle::app {

namespace {

using Points = std::vector<sf::Vector2f>;

Points ring(const Outline& outline, float depth) {
    Points points;
    outline.ring(depth, points);
    return points;
}

bool has(const Points& points, float x, float y) {
    for (const sf::Vector2f p : points)
        if (std::hypot(p.x - x, p.y - y) < 1e-3f) return true;
    return false;
}

}  // namespace

TEST_CASE("a ring inside a box is a smaller box in either orientation") {
    Points corners{{0, 0}, {10, 0}, {10, 6}, {0, 6}};
    if (GENERATE(false, true)) std::reverse(corners.begin(), corners.end());
    Outline outline;
    outline.set(corners, 0);
    const Points inner = ring(outline, 2);
    REQUIRE(inner.size() == 4);
    CHECK(has(inner, 2, 2));
    CHECK(has(inner, 8, 4));
    const Points outer = ring(outline, -0.5f);
    CHECK(has(outer, -0.5f, -0.5f));
    CHECK(has(outer, 10.5f, 6.5f));
    CHECK(outline.depth_limit() == Approx(3).epsilon(0.03));
}

TEST_CASE("a ring within the rounding has round corners and one beyond it has sharp corners") {
    const Points corners{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    Outline outline;
    outline.set(corners, 10);
    for (const sf::Vector2f p : ring(outline, 0)) {
        const float dx = std::max({0 - p.x, p.x - 100, 0.0f});
        const float dy = std::max({0 - p.y, p.y - 100, 0.0f});
        CHECK(std::hypot(dx, dy) == Approx(10).margin(1e-3));
    }
    const Points deep = ring(outline, 15);
    CHECK(deep.size() == outline.size());
    for (const sf::Vector2f p : deep) {
        CHECK(std::min(std::abs(p.x - 5), std::abs(p.x - 95)) < 1e-3f);
        CHECK(std::min(std::abs(p.y - 5), std::abs(p.y - 95)) < 1e-3f);
    }
}

TEST_CASE("one corner with a rounding is a smooth circle") {
    Outline outline;
    const float radius = GENERATE(2.0f, 20.0f, 500.0f);
    outline.set(Points{{50, 50}}, radius);
    const Points rim = ring(outline, 0);
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const sf::Vector2f middle = (rim[i] + rim[(i + 1) % rim.size()]) * 0.5f;
        CHECK(std::hypot(rim[i].x - 50, rim[i].y - 50) == Approx(radius));
        // The error of the chord is too small to be visible.
        CHECK(radius - std::hypot(middle.x - 50, middle.y - 50) < 0.35f);
    }
    CHECK(outline.depth_limit() == Approx(radius));
}

TEST_CASE("two corners with a rounding are a capsule") {
    Outline outline;
    outline.set(Points{{0, 0}, {20, 0}}, 3);
    float left = 0, right = 0;
    for (const sf::Vector2f p : ring(outline, 0)) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        CHECK(std::abs(p.y) <= 3.001f);
    }
    CHECK(left == Approx(-3).epsilon(0.05));
    CHECK(right == Approx(23).epsilon(0.05));
}

TEST_CASE("degenerate outlines give finite rings") {
    const Points corners = GENERATE(Points{}, Points{{1, 1}}, Points{{1, 1}, {1, 1}},
                                    Points{{0, 0}, {1, 0}, {2, 0}}, Points{{0, 0}, {5, 0}, {0, 0}});
    const float rounding = GENERATE(0.0f, 4.0f);
    Outline outline;
    outline.set(corners, rounding);
    for (const float depth : {-0.5f, 0.0f, 0.5f})
        for (const sf::Vector2f p : ring(outline, std::min(depth, outline.depth_limit())))
            CHECK((std::isfinite(p.x) && std::isfinite(p.y)));
}

TEST_CASE("a border at a sharp corner keeps its width on both sides") {
    const Points corners{{0, 0}, {100, -10}, {100, 10}};
    Outline outline;
    outline.set(corners, 0);
    const float depth = 3;
    REQUIRE(outline.depth_limit() > depth);
    for (const sf::Vector2f p : ring(outline, depth))
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const sf::Vector2f from = corners[i], edge = corners[(i + 1) % 3] - from;
            const float distance = std::abs(edge.x * (p.y - from.y) - edge.y * (p.x - from.x)) /
                                   std::hypot(edge.x, edge.y);
            CHECK(distance > depth - 1e-3f);
        }
}

TEST_CASE("an outline is convex when it always turns to the same side and goes around once") {
    CHECK(is_convex(Points{{0, 0}, {10, 0}, {10, 6}, {0, 6}}));
    CHECK(is_convex(Points{{0, 6}, {10, 6}, {10, 0}, {0, 0}}));
    CHECK(is_convex(Points{{0, 0}, {5, 0}, {10, 0}, {10, 6}, {5, 6.0001f}, {0, 6}}));
    CHECK_FALSE(is_convex(Points{{0, 0}, {10, 0}, {5, 3}, {10, 6}, {0, 6}}));  // a notch
    CHECK_FALSE(is_convex(Points{{0, 0}, {10, 6}, {10, 0}, {0, 6}}));          // a bow tie
    Points star;
    for (int i = 0; i < 5; ++i)
        star.push_back({100 * std::cos(2.5132741f * static_cast<float>(i)),
                        100 * std::sin(2.5132741f * static_cast<float>(i))});
    CHECK_FALSE(is_convex(star));  // always turns left, but goes around twice
    Points circle;
    for (int i = 0; i < 20'000; ++i)
        circle.push_back({300 * std::cos(0.00031415927f * static_cast<float>(i)),
                          300 * std::sin(0.00031415927f * static_cast<float>(i))});
    remove_close_corners(circle);
    CHECK(circle.size() < 10'000);
    CHECK(is_convex(circle));
}

TEST_CASE("self intersecting outlines are detected") {
    Outline outline;
    outline.set_any(Points{{0, 0}, {10, 0}, {5, 3}, {10, 6}, {0, 6}});
    CHECK(outline.goes_round_once());
    outline.set_any(Points{{0, 0}, {10, 6}, {10, 0}, {0, 6}});
    CHECK_FALSE(outline.goes_round_once());
}

TEST_CASE("an edge along the rows of pixels is sharp and a slanted one fades over a whole pixel") {
    CHECK(Side({0, 0}, {40, 0}).halo == 0.5f);
    CHECK(Side({0, 0}, {0, 40}).halo == 0.5f);
    CHECK(Side({0, 0}, {40, 0.01f}).halo == 0.5f);
    CHECK(Side({0, 0}, {40, 3}).halo == 1);
}

TEST_CASE("the border at a sharp corner does not extend far") {
    Outline outline;
    outline.set(Points{{0, 0}, {100, -1}, {100, 1}}, 0);
    for (const sf::Vector2f p : ring(outline, -0.5f)) CHECK(p.x > -2.5f);
}

}  // namespace fettle::app
