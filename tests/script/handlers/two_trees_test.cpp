#include <fettle/property/path.h>
#include <fettle/property/snapshot_remarks.h>

#include "stage.h"

namespace two_trees_test {

// Two trees with a runtime each, and formulas and timers that a snapshot or a host moves from one
// to the other.

using namespace stage;
using fettle::property::get;
using fettle::property::set;
using fettle::script::Runtime;

namespace {

struct Game {
    std::unique_ptr<Tree> tree = std::make_unique<Tree>();
    std::unique_ptr<Runtime> runtime = std::make_unique<Runtime>(*tree, unhurried());
    std::vector<std::string> printed, errors;

    Game() {
        runtime->on_error([this](const ScriptError& error) { errors.push_back(error.message); });
        runtime->on_print([this](std::string_view text) { printed.emplace_back(text); });
    }
    void run(const std::string& text) { REQUIRE(runtime->run(text, "main.lua")); }
};

}  // namespace

TEST_CASE("a formula that a snapshot copies to another tree is computed by the scripts there") {
    Game first, second;
    first.run("game.x = 1 game.y = formula(function() return game.x + 1 end)");
    first.tree->barrier();
    const auto snapshot = first.tree->snapshot();
    set(*first.tree, "x", 100);
    const int ends = GENERATE(0, 1, 2, 3);
    if (ends & 1) first.tree = nullptr;
    if (ends & 2) first.runtime = nullptr;
    second.tree->restore(snapshot);
    CHECK(fettle::property::restore_remarks(*second.tree).empty());
    second.tree->barrier();
    CHECK(get(*second.tree, "y") == Value(2));
    set(*second.tree, "x", 5);
    second.tree->barrier();
    CHECK(get(*second.tree, "y") == Value(6));
    // The formula belongs to that runtime and ends with it.
    second.runtime = nullptr;
    set(*second.tree, "x", 7);
    CHECK_THROWS_WITH(get(*second.tree, "y"), contains("its script has ended"));
}

TEST_CASE("a tree without scripts keeps the values of formulas of another tree and reports it") {
    Game first, other;
    other.runtime = nullptr;
    Tree& plain = *other.tree;
    first.run("game.x = 1 game.y = formula(function() return game.x + 1 end)");
    first.tree->barrier();
    first.runtime = nullptr;  // otherwise its part of the snapshot is missing here
    const auto snapshot = first.tree->snapshot();
    plain.restore(snapshot);
    CHECK(fettle::property::restore_remarks(plain) ==
          std::vector<std::string>{
              "y: its formula cannot be compiled here; it keeps the value that it had"});
    plain.barrier();
    CHECK(get(plain, "y") == Value(2));
}

TEST_CASE("timers of one tree do not run in another") {
    Game first, second;
    // The first function kept here has the same number as one kept there.
    first.run("every(1, function() print('first') end) after(1, function() print('once') end)");
    second.run("kept = every(1, function() print('second') end) kept:stop()");
    second.run("every(1, function() print('second') end) after(1, function() print('once') end)");
    second.tree->restore(first.tree->snapshot());
    for (int second_of_time = 1; second_of_time < 4; ++second_of_time)
        second.runtime->step(second_of_time, 1);
    CHECK(first.printed.empty());
    CHECK(second.printed.empty());
    CHECK(second.errors.empty());
}

TEST_CASE("a formula that a host copies to another tree is in error there") {
    Game first;
    first.run("game.x = 1 game.y = formula(function() return game.x + 1 end)");
    const auto& y = first.tree->property(first.tree->root(), "y");
    const fettle::property::Formula formula = *first.tree->formula(first.tree->root(), y);
    Tree plain;
    plain.set_or_add(plain.root(), "y", 0);
    plain.set_formula(plain.root(), "y", formula);
    const auto problem = [&] {
        return plain.problem(plain.root(), plain.property(plain.root(), "y"));
    };
    CHECK(problem() ==
          "it is a function of the scripts of another tree, and is computed only there");
    first.tree = nullptr;
    plain.set_formula(plain.root(), "y", formula);
    CHECK(problem() == "its script has ended");
}

}  // namespace two_trees_test
