#include <fettle/property/natural_order.h>

#include <algorithm>
#include <string>
#include <vector>

#include "catch.h"

namespace natural_order_test {

using fettle::property::NaturalOrder;

TEST_CASE("numbers in names count as numbers in the order of names") {
    std::vector<std::string> names = {"brick_10", "brick_2", "brick_1", "brick",
                                      "a.b10.c",  "a.b9.d",  "a.b9.c",  "x02",
                                      "x2",       "x1y3",    "x1y20",   ""};
    std::sort(names.begin(), names.end(), NaturalOrder{});
    CHECK(names == std::vector<std::string>{"", "a.b9.c", "a.b9.d", "a.b10.c", "brick", "brick_1",
                                            "brick_2", "brick_10", "x1y3", "x1y20", "x02", "x2"});
    for (const std::string& a : names)
        for (const std::string& b : names) {
            INFO(a << " and " << b);
            CHECK(NaturalOrder{}(a, b) + NaturalOrder{}(b, a) == (a == b ? 0 : 1));
        }
    const std::string long_number(300, '9');
    CHECK(NaturalOrder{}("n" + long_number, "n1" + long_number));
}

TEST_CASE("rows of a table are compared cell by cell") {
    using Row = std::vector<std::string>;
    CHECK(NaturalOrder{}(Row{"a2", "z"}, Row{"a10", "b"}));
    CHECK(NaturalOrder{}(Row{"a2", "b2"}, Row{"a2", "b10"}));
    CHECK_FALSE(NaturalOrder{}(Row{"a2", "b2"}, Row{"a2", "b2"}));
    CHECK(NaturalOrder{}(Row{"a2"}, Row{"a2", "b"}));
}

}  // namespace natural_order_test
