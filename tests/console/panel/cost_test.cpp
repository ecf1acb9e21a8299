// The number of drawn triangles must not grow with the game. The times are those of `fettle-bench
// console`, and are not checked.

#ifdef FETTLE_BENCH_CONSOLE

#include <string>
#include <vector>

#include "catch.h"
#include "console/console_costs.h"

namespace cost_test {

using namespace fettle;

TEST_CASE("the cost of drawing the console does not grow with the game") {
    const std::vector<bench::ConsoleCost> few = bench::console_costs(1'000, 1, nullptr),
                                          many = bench::console_costs(20'000, 1, nullptr);
    REQUIRE(few.size() == many.size());
    CHECK(few.front().state == "closed");
    CHECK(few.front().drawn == 0);
    for (std::size_t i = 0; i < few.size(); ++i) {
        INFO(few[i].state);
        CHECK(few[i].state == many[i].state);
        if (i > 0) CHECK(few[i].drawn > 100);
        CHECK(many[i].drawn <= few[i].drawn + few[i].drawn / 10);
    }
}

}  // namespace cost_test

#endif
