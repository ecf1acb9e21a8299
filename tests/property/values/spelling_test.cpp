// Search for the nearest spelling of a name.

#include <fettle/property/spelling.h>

#include <algorithm>
#include <random>
#include <string>

#include "catch.h"

namespace spelling_test {

using fettle::property::contains_ignoring_case;
using fettle::property::edit_distance;

namespace {

/// The definition: what the last letters of both cost, and the rest.
std::size_t by_definition(std::string_view a, std::string_view b) {
    if (a.empty() || b.empty()) return a.size() + b.size();
    const std::string_view less_a = a.substr(0, a.size() - 1), less_b = b.substr(0, b.size() - 1);
    std::size_t best = std::min({by_definition(less_a, b) + 1, by_definition(a, less_b) + 1,
                                 by_definition(less_a, less_b) + (a.back() == b.back() ? 0 : 1)});
    if (a.size() > 1 && b.size() > 1 && a.back() == b[b.size() - 2] && b.back() == a[a.size() - 2])
        best =
            std::min(best, by_definition(a.substr(0, a.size() - 2), b.substr(0, b.size() - 2)) + 1);
    return best;
}

}  // namespace

TEST_CASE("the distance of two names is the least number of edits and transpositions") {
    CHECK(edit_distance("velocty", "velocity", 3) == 1);
    CHECK(edit_distance("Velcoity", "velocity", 3) == 1);
    CHECK(edit_distance("brick_4", "brick_12", 3) == 2);
    CHECK(edit_distance("", "", 3) == 0);
    CHECK(edit_distance("mass", "mass", 0) == 0);
    CHECK(edit_distance("mass", "friction", 3) == 4);
    std::minstd_rand random(7);
    for (int i = 0; i < 3000; ++i) {
        std::string a, b;
        for (std::string* text : {&a, &b})
            for (std::size_t size = random() % 7; text->size() < size;)
                *text += static_cast<char>('a' + random() % 3);
        CAPTURE(a, b);
        for (const std::size_t limit : {1, 2, 9})
            REQUIRE(edit_distance(a, b, limit) == std::min(by_definition(a, b), limit + 1));
    }
}

TEST_CASE("a search that ignores case finds letters of either case and other bytes exactly") {
    CHECK(contains_ignoring_case("world.Ball", "BALL"));
    CHECK(contains_ignoring_case("world.Ball", ""));
    CHECK_FALSE(contains_ignoring_case("world.Ball", "bal_"));
    CHECK_FALSE(contains_ignoring_case("[", "{"));
    CHECK_FALSE(contains_ignoring_case("", "a"));
}

TEST_CASE("x and y are not taken for the last word of a name") {
    const std::vector<std::string> names = {"locked_x", "locked_y", "body_a"};
    CHECK(fettle::property::suggestion("x", names).empty());
    CHECK(fettle::property::suggestion("y", names).empty());
    CHECK(fettle::property::suggestion("a", names) == " (did you mean \"body_a\"?)");
}

TEST_CASE("of several names that a name begins the shortest is meant") {
    const std::vector<std::string> names = {"randomseed", "random", "randomness"};
    CHECK(fettle::property::suggestion("rand", names) == " (did you mean \"random\"?)");
    CHECK(fettle::property::suggestion("randoms", names) == " (did you mean \"random\"?)");
    CHECK(fettle::property::suggestion("randomn", names) == " (did you mean \"random\"?)");
    CHECK(fettle::property::suggestion("ra", names).empty());
    CHECK(fettle::property::suggestion("r", {}).empty());
}

}  // namespace spelling_test
