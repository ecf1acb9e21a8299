// Invalid values through the C interface: the host reports them and continues.

#include <catch.h>

#include <cmath>
#include <limits>
#include <string>

#include <fettle/module/host.h>

#include "weather.h"

namespace c_values_test {

using namespace fettle;
using namespace fettle::module::testing;

namespace {

template <class Act>
std::string message_of(const Act& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

std::string reading(const char* name) {
    module::Plugins plugins;
    property::Tree tree;
    plugins.open(built("odd")).attach(tree);
    return message_of([&] { property::get(tree, name); });
}

}  // namespace

TEST_CASE("a column of a module without memory is reported by name") {
    CHECK_THAT(reading("odd.hollow"), contains("Odd.hollow: it has no memory"));
}

TEST_CASE("a getter that fails or sets no value is an error with its reason") {
    CHECK_THAT(reading("odd.failing"), contains("Odd.failing: the sensor is wet"));
    CHECK_THAT(reading("odd.typeless"), contains("there is no type number 99"));
    CHECK_THAT(reading("odd.wordless"), contains("a text of length 3 has no memory"));
    CHECK_THAT(reading("odd.empty"), contains("a list of length 3 has no memory"));
}

TEST_CASE("a list that contains itself is refused") {
    CHECK_THAT(reading("odd.endless"), contains("lists are in lists more than 64 deep"));
}

TEST_CASE("arrays without memory or with elements of size zero are refused") {
    for (const char* wrong : {"odd_without_data", "odd_without_size"}) {
        module::Plugins plugins;
        property::Tree tree;
        CHECK_THAT(message_of([&] { plugins.open(built(wrong)).attach(tree); }),
                   contains("an array of 6 elements"));
    }
}

TEST_CASE("the stride of a column must suit its elements") {
    for (const char* wrong : {"odd_stride", "odd_small_stride"}) {
        module::Plugins plugins;
        property::Tree tree;
        CHECK_THAT(message_of([&] { plugins.open(built(wrong)).attach(tree); }),
                   contains("bytes, expected 8 to 1073741824"));
    }
}

TEST_CASE("a module makes rows only for its own classes and the classes derived from them") {
    module::Plugins plugins;
    property::Tree tree;
    CHECK_NOTHROW(plugins.open(built("odder")).attach(tree));
    CHECK(tree.class_named("Odder").base() == &tree.class_named("Odd"));
    module::Plugins others;
    property::Tree other;
    others.open(built("weather")).attach(other);
    CHECK_THAT(message_of([&] { others.open(built("odd_cloud")).attach(other); }),
               contains("class Odd: `lifecycle`: it inherits") &&
                   contains("that the lifecycle of Cloud makes"));
}

TEST_CASE("a module with save must also have restore") {
    module::Plugins plugins;
    CHECK_THAT(message_of([&] { (void)plugins.open(built("half_saved")); }),
               contains("both `save` and `restore`"));
}

TEST_CASE("the time step of a game in C must be valid") {
    fettle_game* const game = fettle_game_open();
    const fettle_host* const host = fettle_game_host(game);
    for (const double wrong :
         {std::nan(""), -1.0, 1e300, std::numeric_limits<double>::infinity()}) {
        CHECK(fettle_game_step(game, wrong) != FETTLE_OK);
        CHECK_THAT(std::string(host->last_error(host->self)), contains("seconds = "));
    }
    CHECK(fettle_game_step(game, 1e300) != FETTLE_OK);
    CHECK(host->last_error(host->self) ==
          std::string("fettle_game_step: seconds = 1e+300: expected a time from 0 to 3.4e38 s"));
    CHECK(fettle_game_step(game, 0.1) == FETTLE_OK);
    fettle_game_close(game);
}

TEST_CASE("a game in C that is null and a module without a path are refused") {
    fettle_game* const game = fettle_game_open();
    const fettle_host* const host = fettle_game_host(game);
    for (const char* none : {static_cast<const char*>(nullptr), ""}) {
        CHECK(fettle_game_load(game, none) != FETTLE_OK);
        CHECK_THAT(std::string(host->last_error(host->self)), contains("expected the path"));
    }
    fettle_game_close(game);
    CHECK(fettle_game_step(nullptr, 0.1) == FETTLE_ERR_FAILED);
    CHECK(fettle_game_load(nullptr, "physics.so") == FETTLE_ERR_FAILED);
    CHECK(fettle_game_host(nullptr) == nullptr);
    fettle_game_close(nullptr);
}

}  // namespace c_values_test
