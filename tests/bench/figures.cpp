// Statistics and formatting of the measurements of benchmarks.

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "catch.h"
#include "measure/timing.h"
#include "report/bounds.h"
#include "report/json_lines.h"
#include "report/table.h"

using namespace fettle::bench;

namespace {

/// 1 to n, shuffled.
std::vector<double> ranks(int n) {
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.begin(), values.end(), 1.0);
    std::mt19937 random(7);
    std::shuffle(values.begin(), values.end(), random);
    return values;
}

}  // namespace

TEST_CASE("the median is the middle value or the mean of the middle two") {
    CHECK(median({3}) == 3);
    CHECK(median({5, 1, 3}) == 3);
    CHECK(median({4, 1, 3, 2}) == 2.5);
}

TEST_CASE("the interval of the median agrees with the tables of order statistics") {
    // P(X <= 5) = 2.07 %, P(X <= 6) = 5.77 % for 20 fair coins: the 6th and the 15th value.
    CHECK(median_interval(ranks(20)).low == 6);
    CHECK(median_interval(ranks(20)).high == 15);
    // P(X <= 9) = 2.14 %, P(X <= 10) = 4.94 % for 30.
    CHECK(median_interval(ranks(30)).low == 10);
    CHECK(median_interval(ranks(30)).high == 21);
    // P(X <= 0) = 3.13 % for 5 is too much, so the interval contains all five values.
    CHECK(median_interval(ranks(5)).low == 1);
    CHECK(median_interval(ranks(5)).high == 5);
    CHECK(median_interval(ranks(6)).low == 1);
    CHECK(median_interval(ranks(9)).low == 2);
}

TEST_CASE("a figure is printed with three significant digits") {
    CHECK(figure(0) == "0");
    CHECK(figure(0.12345) == "0.123");
    CHECK(figure(1.2345) == "1.23");
    CHECK(figure(12.345) == "12.3");
    CHECK(figure(1234.5) == "1234");
    CHECK(figure(-0.5) == "-0.500");
    CHECK(figure(1.00009, 5) == "1.0001");
    CHECK(figure(0.0000123) == "1.23e-05");
}

TEST_CASE("a bound applies to its figures and never holds for NaN") {
    CHECK(below(50).holds(49.9));
    CHECK_FALSE(below(50).holds(50));
    CHECK(at_most(1.75).holds(1.75));
    CHECK_FALSE(at_most(1.75).holds(1.7501));
    CHECK(at_least(1.7).holds(1.7));
    CHECK_FALSE(at_least(1.7).holds(1.69));
    CHECK(exactly(15).holds(15));
    CHECK_FALSE(exactly(15).holds(14));
    CHECK(other_than(0).holds(-0.1));
    CHECK_FALSE(other_than(0).holds(0));
    CHECK(Bound{}.holds(1e9));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Bound& bound : {below(1), at_most(1), at_least(1), exactly(1), other_than(1)})
        CHECK_FALSE(bound.holds(nan));
}

TEST_CASE("a table marks the figures beyond their bounds and lists them at the end") {
    Verdict verdict("tree");
    CHECK(verdict.mark("get ball.mass", 1.5, at_most(1.75), "1.50", "of the barest") == "1.50");
    CHECK(verdict.mark("get ball.mass", 2, at_most(1.75), "2.00", "of the barest") == "2.00 !");
    CHECK(verdict.mark("a row without a bound", 2, {}, "2.00") == "2.00");
    CHECK(verdict.mark("stack, jitter", 1, below(1, "stands"), "1.00", "mm/s") == "1.00 !");
    CHECK(text_with_note(below(1, "stands")) == "< 1: stands");
    std::ostringstream out;
    verdict.print(out);
    CHECK(out.str() ==
          "\n3 bounds, 2 exceeded\n"
          "exceeded: tree \"get ball.mass\" 2.00 of the barest (bound <= 1.75)\n"
          "exceeded: tree \"stack, jitter\" 1.00 mm/s (bound < 1)\n");
}

TEST_CASE("columns of a table are as wide as their widest cell") {
    Table table({"scene", "ms"});
    table.add({"large_pyramid", "1"});
    table.add({"smash", "12.5"});
    CHECK(table.text() ==
          "scene            ms\n"
          "-------------------\n"
          "large_pyramid     1\n"
          "smash          12.5\n");
}

TEST_CASE("a JSON line keeps the order and writes NaN as null") {
    CHECK(json_line({{"scene", std::string("a \"b\"")},
                     {"steps", 3LL},
                     {"ms", 1.5},
                     {"ratio", JsonField()},
                     {"nan", std::numeric_limits<double>::quiet_NaN()}}) ==
          R"({"scene":"a \"b\"","steps":3,"ms":1.5,"ratio":null,"nan":null})");
}

TEST_CASE("the longest bar of a group fills the chart and a missing value has no bar") {
    const Chart chart{.title = "a < b",
                      .unit = "ms",
                      .series = {"one", "two", "three"},
                      .groups = {{"group", {4.0, std::nullopt, 1.0}}}};
    const std::string svg = svg_of(chart);
    CHECK_THAT(svg, contains("a &lt; b"));
    CHECK_THAT(svg, contains("width=\"420\""));
    CHECK_THAT(svg, contains("width=\"105\""));
    CHECK_THAT(svg, contains(">4.00 ms<"));
    std::size_t bars = 0;
    for (std::size_t at = svg.find("height=\"13\""); at != std::string::npos;
         at = svg.find("height=\"13\"", at + 1)) {
        ++bars;
    }
    CHECK(bars == 2);
}

TEST_CASE("a chart that cannot be written is reported with the file") {
    CHECK_THROWS_WITH(write_svg({}, "/no/such/folder/chart.svg"),
                      contains("/no/such/folder/chart.svg"));
}
