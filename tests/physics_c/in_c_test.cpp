#include "in_c.h"

#include "catch.h"

namespace in_c_test {

namespace {

void run_all(const named_c_test* test) {
    for (; test->name != nullptr; ++test) {
        const char* fault = test->run();
        INFO(test->name << ": " << (fault != nullptr ? fault : ""));
        CHECK(fault == nullptr);
    }
}

}  // namespace

TEST_CASE("worlds have the same results from C as from C++") {
    run_all(worlds_in_c);
}

TEST_CASE("worlds call functions in C and refuse edits inside them") {
    run_all(callbacks_in_c);
}

TEST_CASE("points of the world have in C the precision that they have in C++") {
    run_all(positions_in_c);
}

TEST_CASE("accounts and planes and colors are in C") {
    run_all(accounts_in_c);
}

}  // namespace in_c_test
