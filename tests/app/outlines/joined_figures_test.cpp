#include <outlines/joined_figures.h>

#include <catch.h>

#include <cmath>

namespace fettle::app {

namespace {

using Points = std::vector<sf::Vector2f>;

Points box(float left, float top, float right, float bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

Points circle(float x, float y, float radius) {
    Points points;
    for (int i = 0; i < 60; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / 60;
        points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
    }
    return points;
}

float length_of(const std::vector<Run>& runs) {
    float length = 0;
    for (const Run& run : runs)
        for (std::size_t i = 0; i + (run.closed ? 0 : 1) < run.bends.size(); ++i) {
            const sf::Vector2f step =
                run.bends[(i + 1) % run.bends.size()].corner - run.bends[i].corner;
            length += std::hypot(step.x, step.y);
        }
    return length;
}

std::vector<Run> border_of(const std::vector<Points>& parts) {
    JoinedFigures joined;
    for (const Points& part : parts) joined.add(part);
    REQUIRE(joined.find_seams());
    return joined.border(0);
}

}  // namespace

TEST_CASE("separate parts keep their whole borders") {
    const auto border = border_of({box(0, 0, 50, 20), box(100, 0, 150, 20)});
    REQUIRE(border.size() == 2);
    CHECK((border[0].closed && border[1].closed));
    CHECK(length_of(border) == Approx(280));
}

TEST_CASE("touching boxes have one common border") {
    CHECK(length_of(border_of({box(0, 0, 50, 20), box(50, 0, 150, 20)})) == Approx(340));
    CHECK(length_of(border_of({box(0, 0, 50, 20), box(20, 20, 30, 40)})) == Approx(180).margin(2));
    // Four boxes in a square: the edges at which they meet have no border.
    CHECK(length_of(border_of({box(0, 0, 50, 50), box(50, 0, 100, 50), box(0, 50, 50, 100),
                               box(50, 50, 100, 100)})) == Approx(400).margin(2));
}

TEST_CASE("a row of a hundred touching boxes has the border of one long box") {
    std::vector<Points> row;
    for (int i = 0; i < 100; ++i)
        row.push_back(
            box(static_cast<float>(12 * i), 3.3f, static_cast<float>(12 * i + 12), 15.3f));
    CHECK(length_of(border_of(row)) == Approx(2 * (1200 + 12)).margin(1));
}

TEST_CASE("overlapping parts have the border of their union") {
    CHECK(length_of(border_of({box(0, 0, 60, 20), box(20, -20, 40, 40)})) == Approx(240).margin(4));
    // Circles of radius 50 whose centers are 50 apart: a third of each rim is hidden.
    CHECK(length_of(border_of({circle(0, 0, 50), circle(50, 0, 50)})) ==
          Approx(2 * 6.2831853f * 50 * 2 / 3).epsilon(0.01));
    CHECK(length_of(border_of({box(0, 0, 60, 60), box(20, 20, 40, 40)})) == Approx(240));
}

TEST_CASE("a border that two parts share is drawn once") {
    CHECK(length_of(border_of({box(0, 0, 60, 20), box(20, 0, 40, 60)})) == Approx(240).margin(4));
    CHECK(length_of(border_of({box(0, 0, 60, 20), box(0, 0, 60, 20)})) == Approx(160));
}

TEST_CASE("two parts that cross have one open run of border each") {
    const auto border = border_of({box(0, 0, 50, 20), box(20, 10, 30, 60)});
    std::size_t open = 0;
    for (const Run& run : border) open += run.closed ? 0 : 1;
    CHECK(open == border.size());
    CHECK(border.size() == 2);
}

TEST_CASE("too many parts in one place keep their own borders") {
    JoinedFigures joined;
    for (int i = 0; i < 400; ++i) joined.add(circle(static_cast<float>(i % 7), 0, 50));
    CHECK_FALSE(joined.find_seams());
}

}  // namespace fettle::app
