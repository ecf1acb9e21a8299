// Long random runs compared with the model. FETTLE_MODEL_OPERATIONS and FETTLE_MODEL_SEED set the
// number of operations and the seed; both are printed.

#include <rapidcheck.h>

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <tuple>

#include "catch.h"
#include "random_operations.h"

namespace random_operations_test {

using namespace fettle::property::testing;

namespace {

constexpr int longest = 400;  // operations per run

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr && *text != '\0' ? std::strtoull(text, nullptr, 10) : otherwise;
}

rc::Gen<Operation> operation() {
    return rc::gen::map(
        rc::gen::tuple(rc::gen::weightedElement<Operation::Kind>({{6, Operation::create},
                                                                  {2, Operation::destroy},
                                                                  {4, Operation::move},
                                                                  {12, Operation::set},
                                                                  {10, Operation::set_formula},
                                                                  {3, Operation::clear},
                                                                  {6, Operation::read},
                                                                  {5, Operation::barrier},
                                                                  {3, Operation::simulate},
                                                                  {2, Operation::begin_edit},
                                                                  {3, Operation::end_edit},
                                                                  {5, Operation::undo},
                                                                  {4, Operation::redo},
                                                                  {4, Operation::watch},
                                                                  {1, Operation::stop},
                                                                  {2, Operation::rename},
                                                                  {2, Operation::explain},
                                                                  {2, Operation::snapshot},
                                                                  {1, Operation::restore}}),
                       rc::gen::container<std::array<int, 4>>(rc::gen::inRange(0, 10'000))),
        [](const std::tuple<Operation::Kind, std::array<int, 4>>& parts) {
            return Operation{std::get<0>(parts), std::get<1>(parts)};
        });
}

/// True if tree and model agree in `operations` random operations in total; `people`: all edits are
/// made by a person.
bool agree(bool people, std::uint64_t operations, std::uint64_t seed) {
    std::uint64_t made = 0;
    const auto holds = [&] {
        const auto list = *rc::gen::resize(
            longest, rc::gen::container<std::vector<Operation>>(rc::gen::resize(100, operation())));
        auto run = std::make_unique<RandomRun>(people);
        try {
            for (const Operation& each : list) run->run(each);
            run->settle();
        } catch (...) {
            (void)run.release();  // the destructor of a broken tree may crash
            throw;
        }
        made += list.size();
    };
    rc::detail::TestParams params;
    params.maxSuccess = 50;
    while (made < operations) {
        params.seed = seed++;
        const auto result = rc::detail::checkTestable(holds, rc::detail::TestMetadata(), params);
        if (!result.template is<rc::detail::SuccessResult>()) {
            std::ostringstream text;
            rc::detail::printResultMessage(result, text);
            UNSCOPED_INFO("seed " << params.seed << "\n" << text.str());
            return false;
        }
    }
    std::cout << made << " operations of " << (people ? "people" : "scripts") << ", seeds up to "
              << seed - 1 << "\n";
    return true;
}

}  // namespace

TEST_CASE("random edits by people with undo and redo and formulas agree with the model",
          "[model]") {
    CHECK(agree(true, from_environment("FETTLE_MODEL_OPERATIONS", 20'000) / 2,
                from_environment("FETTLE_MODEL_SEED", 1)));
}

TEST_CASE("random edits by scripts and handlers with formulas agree with the model", "[model]") {
    CHECK(agree(false, from_environment("FETTLE_MODEL_OPERATIONS", 20'000) / 2,
                from_environment("FETTLE_MODEL_SEED", 1)));
}

}  // namespace random_operations_test
