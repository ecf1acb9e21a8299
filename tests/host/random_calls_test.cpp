#include <fstream>
#include <set>
#include <sstream>

#include "catch.h"
#include "every_call.h"
#include "patterns.h"
#include "thorough.h"

namespace random_calls_test {

using namespace random_hosting;

namespace {

std::string text_of(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::set<std::string> functions_in_headers() {
    std::set<std::string> found;
    const std::string umbrella = text_of("bindings/host/include/fettle_host.h");
    for (const auto& file : patterns::all(umbrella, "#include <(fettle/host/\\w+\\.h)>")) {
        const std::string text = text_of("bindings/host/include/" + file[1]);
        for (const auto& function :
             patterns::all(text, "\n(?:fettle_code|bool|const char\\*) (fettle_\\w+)\\("))
            found.insert(function[1]);
    }
    return found;
}

}  // namespace

TEST_CASE("every function of the headers is called at random") {
    std::set<std::string> named;
    for (const Call& call : every_call) named.insert(call.name);
    CHECK(named == functions_in_headers());
}

TEST_CASE("calls in any order with any arguments leave a game that works") {
    const uint32_t seeds = thorough() ? 40 : 2, calls = 3000;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        CAPTURE(seed);
        Arguments arguments{Numbers(seed)};
        for (uint32_t i = 0; i < calls; ++i) any_call(arguments);
        for (int i = 0; i < 2; ++i) {
            fettle_hosted* const game = arguments.game(i);
            (void)fettle_hosted_on_print(game, nullptr, nullptr);
            (void)fettle_hosted_on_problem(game, nullptr, nullptr);
            fettle_hosted_value result;
            CHECK(fettle_hosted_evaluate(game, "1 + 1", &result, nullptr) == FETTLE_DONE);
            INFO(fettle_last_error());
            CHECK((result.type == FETTLE_VALUE_INTEGER ? double(result.as.integer)
                                                       : result.as.number) == 2);
        }
    }
}

}  // namespace random_calls_test
