// Outlines of tiles.

#include <catch.h>

#include <cmath>
#include <random>

#include <fettle/maps/outlines.h>
#include <fettle/property/error.h>

namespace outlines_test {

using namespace fettle::maps;
using fettle::property::Vec2;

namespace {

Outline box(double x, double y, double width = 16, double height = 16) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

double area(const Outline& outline) {
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        sum += 0.5 * (a.x * b.y - a.y * b.x);
    }
    return sum;
}

double area(const std::vector<Outline>& outlines) {
    double sum = 0;
    for (const Outline& outline : outlines) sum += area(outline);
    return sum;
}

}  // namespace

TEST_CASE("tiles in a row become one box with four corners") {
    std::vector<Outline> tiles;
    for (int i = 0; i < 10; ++i) tiles.push_back(box(16 * i, 0));
    const std::vector<Outline> merged = merged_outlines(tiles);
    REQUIRE(merged.size() == 1);
    CHECK(merged[0].size() == 4);
    CHECK(area(merged) == 10 * 16 * 16);
}

TEST_CASE("the winding of the polygons does not matter") {
    Outline clockwise = box(16, 0);
    std::ranges::reverse(clockwise);
    const std::vector<Outline> merged = merged_outlines(std::vector<Outline>{box(0, 0), clockwise});
    REQUIRE(merged.size() == 1);
    CHECK(area(merged) == 2 * 16 * 16);
}

TEST_CASE("a ring of tiles has an outline around it and one around its hole") {
    std::vector<Outline> tiles;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            if (x != 1 || y != 1) tiles.push_back(box(16 * x, 16 * y));
    std::vector<Outline> merged = merged_outlines(tiles);
    REQUIRE(merged.size() == 2);
    std::ranges::sort(merged, {}, [](const Outline& outline) { return area(outline); });
    CHECK(area(merged[0]) == -16 * 16);
    CHECK(area(merged[1]) == 9 * 16 * 16);
    CHECK(merged[0].size() == 4);
    CHECK(merged[1].size() == 4);
}

TEST_CASE("tiles that meet in a corner stay two outlines") {
    const std::vector<Outline> merged =
        merged_outlines(std::vector<Outline>{box(0, 0), box(16, 16)});
    REQUIRE(merged.size() == 2);
    CHECK(merged[0].size() == 4);
    CHECK(merged[1].size() == 4);
}

TEST_CASE("slopes and boxes with edges of different lengths are merged") {
    const Outline slope = {{0, 0}, {16, 0}, {16, 16}};
    const std::vector<Outline> merged =
        merged_outlines(std::vector<Outline>{slope, box(16, -16, 16, 32), box(32, 0, 8, 8)});
    REQUIRE(merged.size() == 1);
    CHECK(area(merged) == 16 * 16 / 2 + 16 * 32 + 64);
}

TEST_CASE("polygons without an area are skipped") {
    const Outline line = {{0, 0}, {8, 8}, {16, 16}};
    const Outline twice = {{0, 0}, {0, 0}, {4, 0}};
    CHECK(merged_outlines(std::vector<Outline>{line, twice, Outline{}}).empty());
    CHECK_THROWS_AS(merged_outlines(std::vector<Outline>{box(1e9, 0)}), fettle::property::Error);
    CHECK_THROWS_AS(merged_outlines(std::vector<Outline>{box(std::nan(""), 0)}),
                    fettle::property::Error);
}

TEST_CASE("random maps keep their area and no common edge remains") {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        std::vector<Outline> tiles;
        const unsigned density = 1 + random() % 9;
        std::vector<bool> solid(20 * 20);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                if (random() % 10 < density) {
                    solid[static_cast<std::size_t>(20 * y + x)] = true;
                    tiles.push_back(box(16 * x, 16 * y));
                }
        const auto is_solid = [&](double x, double y) {
            const int i = static_cast<int>(std::floor(x / 16)),
                      j = static_cast<int>(std::floor(y / 16));
            return i >= 0 && j >= 0 && i < 20 && j < 20 &&
                   solid[static_cast<std::size_t>(20 * j + i)];
        };
        const std::vector<Outline> merged = merged_outlines(tiles);
        CHECK(area(merged) == 16 * 16 * static_cast<double>(tiles.size()));
        for (const Outline& outline : merged)
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
                const Vec2 middle = 0.5 * (a + b), along = (b - a).normalized();
                const Vec2 left(-along.y, along.x);
                const Vec2 near = a + along, inside = near + left, outside = near - left;
                CHECK(is_solid(inside.x, inside.y));
                CHECK_FALSE(is_solid(outside.x, outside.y));
                CHECK((middle - a).length() >= 8);
            }
    }
}

}  // namespace outlines_test
