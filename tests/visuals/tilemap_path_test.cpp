// The shortest way over the cells of a map.

#include <catch.h>

#include <random>

#include <tilemaps/shortest_way.h>

#include "levels.h"

namespace tilemap_path_test {

using namespace fettle::visuals;
using namespace fettle::visuals::test;

namespace {

/// `#` is solid.
struct Plan {
    std::vector<std::string> rows;
    bool is_free(CellPlace at) const {
        return at.y >= 0 && at.y < static_cast<int>(rows.size()) && at.x >= 0 &&
               at.x < static_cast<int>(rows[0].size()) &&
               rows[static_cast<std::size_t>(at.y)][static_cast<std::size_t>(at.x)] != '#';
    }
    /// The cells as "x,y ", or "none".
    std::string way(CellPlace from, CellPlace to, bool diagonals = true) const {
        const auto found =
            shortest_way(from, to, diagonals, [this](CellPlace at) { return is_free(at); });
        if (!found) return "none";
        std::string text;
        for (const CellPlace at : *found)
            text += std::to_string(at.x) + "," + std::to_string(at.y) + " ";
        return text;
    }
};

}  // namespace

TEST_CASE("a way leads round what is solid, and not over its corners") {
    const Plan plan{{"......", "####..", "......"}};
    CHECK(plan.way({3, 0}, {3, 2}) == "4,0 4,1 4,2 3,2 ");
    CHECK(plan.way({3, 0}, {3, 2}, false) == "4,0 4,1 4,2 3,2 ");
    CHECK(plan.way({1, 0}, {1, 0}) == "");
    CHECK(plan.way({1, 0}, {1, 1}) == "none");
    CHECK(plan.way({1, 1}, {1, 0}) == "1,0 ");  // out of a wall
    CHECK(plan.way({0, 0}, {6, 0}) == "none");
    CHECK(Plan{{"..#..", "..#..", "..#.."}}.way({0, 0}, {4, 0}) == "none");
    CHECK(Plan{{"....", "....", "...."}}.way({0, 0}, {2, 2}) == "1,1 2,2 ");
}

TEST_CASE("the way is as short as the one that a search without an estimate finds") {
    std::mt19937 random(5);
    for (int round = 0; round < 60; ++round) {
        Plan plan{std::vector<std::string>(12, std::string(16, '.'))};
        for (std::string& row : plan.rows)
            for (char& cell : row)
                if (random() % 3 == 0) cell = '#';
        plan.rows[0][0] = plan.rows[11][15] = '.';
        const bool diagonals = round % 2 == 0;
        // Lengths from the beginning, made shorter until nothing changes.
        std::vector<std::vector<int>> length(12, std::vector<int>(16, 1'000'000));
        length[0][0] = 0;
        for (bool changed = true; changed;) {
            changed = false;
            for (int y = 0; y < 12; ++y)
                for (int x = 0; x < 16; ++x)
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx) {
                            const bool slanted = dx != 0 && dy != 0;
                            if (!plan.is_free({x, y}) || !plan.is_free({x + dx, y + dy}) ||
                                (slanted && (!diagonals || !plan.is_free({x + dx, y}) ||
                                             !plan.is_free({x, y + dy}))))
                                continue;
                            const auto at = [&](int column, int row) -> int& {
                                return length[static_cast<std::size_t>(row)]
                                             [static_cast<std::size_t>(column)];
                            };
                            const int here = at(x, y) + (slanted ? 14 : 10);
                            if (here < at(x + dx, y + dy) && (dx != 0 || dy != 0)) {
                                at(x + dx, y + dy) = here;
                                changed = true;
                            }
                        }
        }
        const auto way = shortest_way({0, 0}, {15, 11}, diagonals,
                                      [&](CellPlace at) { return plan.is_free(at); });
        INFO("round " << round);
        REQUIRE(way.has_value() == (length[11][15] < 1'000'000));
        if (!way) continue;
        int sum = 0;
        CellPlace before{0, 0};
        for (const CellPlace at : *way) {
            CHECK(plan.is_free(at));
            sum += at.x != before.x && at.y != before.y ? 14 : 10;
            before = at;
        }
        CHECK(sum == length[11][15]);
    }
}

TEST_CASE_METHOD(Land, "the path of a map is a list of points in the world") {
    // Tile 1 is solid, 4 is not; 3 is solid from above only.
    write("level.tmj", level("0,0,0,0, 1,1,0,3, 4,0,0,0"));
    const Handle top = map();
    const auto path = [&](const Vec2& from, const Vec2& to) {
        return call(top, "path", {Value(from), Value(to)});
    };
    CHECK(path({0.5, 2.5}, {0.9, 0.1}) ==
          Value(List{Vec2(1.5, 2.5), Vec2(2.5, 2.5), Vec2(2.5, 1.5), Vec2(2.5, 0.5), Vec2(1.5, 0.5),
                     Vec2(0.5, 0.5)}));
    CHECK(path({0.5, 2.5}, {0.2, 2.9}) == Value(List{}));
    CHECK(path({0.5, 2.5}, {0.5, 1.5}).is_nil());  // into a wall
    CHECK(path({0.5, 2.5}, {9, 9}).is_nil());
    CHECK(path({-1e300, 1e300}, {0.5, 2.5}).is_nil());
    CHECK(path({3.5, 2.5}, {3.5, 0.5}) == Value(List{Vec2(3.5, 1.5), Vec2(3.5, 0.5)}));
    call(top, "set_tile", {Value(1), Value(1), Value(0)});
    CHECK(path({0.5, 2.5}, {0.5, 0.5}).list().size() == 4);
    // A layer that is not solid is no hindrance.
    tree.set(find(top, "ground"), "solid", Value(false));
    CHECK(path({0.5, 2.5}, {0.5, 0.5}).list().size() == 2);
}

}  // namespace tilemap_path_test
