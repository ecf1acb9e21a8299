#include <algorithm>
#include <set>
#include <string>

#include "catch.h"
#include "every_call.h"
#include "header_text.h"
#include "thorough.h"

namespace random_calls_test {

using namespace random_arguments;

TEST_CASE("the list of calls has every function of the headers") {
    std::set<std::string> listed = {
        // Without arguments, or the pointer must not be used afterwards.
        "fettle_last_error", "fettle_physics_version", "fettle_owner_destroy",
        "fettle_replay_destroy"};
    for (const Call& call : every_call) listed.insert(call.name);
    REQUIRE(listed == header_text::functions_in_c());
}

TEST_CASE("calls in any order with any arguments leave consistent worlds") {
    uint32_t most_touching = 0;
    const uint32_t seeds = thorough() ? 300 : 30;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        Arguments arguments{Numbers(seed)};
        for (int i = 0; i < 3000; ++i) {
            const Call& call = any_call(arguments);
            INFO("seed " << seed << ", call " << i << ", the last one " << call.name);
            REQUIRE_FALSE(arguments.wrote_after_error());
            if (i % 100 != 0) continue;
            for (int k = 0; k < 3; ++k) {
                const char* fault = nullptr;
                REQUIRE(fettle_world_validate(arguments.world(k), &fault) == FETTLE_DONE);
                INFO((fault != nullptr ? fault : ""));
                REQUIRE(fault == nullptr);
                fettle_statistics statistics;
                REQUIRE(fettle_world_statistics(arguments.world(k), &statistics) == FETTLE_DONE);
                most_touching = std::max(most_touching, statistics.touching);
            }
        }
    }
    REQUIRE(most_touching > 3);  // the calls had worlds with something in them
}

}  // namespace random_calls_test
