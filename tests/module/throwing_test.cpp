// Exceptions of a module in C++ never cross the C interface: an error or a printed line names the
// callback, and the game goes on.

#include <catch.h>

#include <functional>
#include <string>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/snapshot.h>

#include "weather.h"

namespace throwing_test {

using namespace fettle;
using namespace fettle::module::testing;
using property::Handle;
using property::List;
using property::Value;

namespace {

struct Game {
    Game() {
        thrower.on_print([this](std::string_view line) { printed.emplace_back(line); });
        thrower.attach(tree);
        one = tree.create(tree.class_named("Fragile"), tree.root(), "one");
    }
    /// What the act prints, or its error, while this callback throws.
    std::string outcome(const char* callback, const std::function<void()>& act) {
        printed.clear();
        tree.set(one, "fails", callback);
        std::string error;
        try {
            act();
        } catch (const std::exception& problem) {
            error = problem.what();
        }
        tree.set(one, "fails", "");
        return printed.empty() ? error : printed.front();
    }

    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& thrower = plugins.open(built("thrower"));
    std::vector<std::string> printed;
    Handle one;
};

}  // namespace

TEST_CASE("exceptions of a module in C++ are reported with their callback") {
    Game game;
    property::Tree& tree = game.tree;
    const bool of_no_class = GENERATE(false, true);
    tree.set(game.one, "of_no_class", of_no_class);
    const auto expected = [&](const char* callback) {
        return of_no_class ? "an exception of no known type"
                           : "no " + std::string(callback) + " today";
    };
    CHECK(game.outcome("step", [&] { game.thrower.step(0.1); }) ==
          "thrower: step: " + expected("step"));
    CHECK(game.outcome("report", [&] { game.thrower.report(tree); }) ==
          "thrower: report: " + expected("report"));
    CHECK(game.outcome("hash", [&] { (void)game.thrower.hash(); }) ==
          "thrower: hash: " + expected("hash"));
    CHECK(game.outcome("base", [&] { (void)tree.get(game.one, "weight"); }) ==
          "Fragile.weight: " + expected("base"));
    CHECK(game.outcome("destroy", [&] {
        tree.destroy(tree.create(tree.class_named("Fragile"), tree.root(), "two"));
        tree.barrier();
    }) == "thrower: destroy of Fragile: " + expected("destroy"));
    CHECK(game.outcome("save", [&] { (void)tree.snapshot(); }) ==
          "module thrower cannot be saved: " + expected("save"));
    const property::Snapshot kept = tree.snapshot();
    CHECK(game.outcome("finish", [&] { tree.restore(kept); }) ==
          "thrower: restore: " + expected("finish"));
    CHECK(tree.get(game.one, "weight") == Value(1.0));
}

TEST_CASE("errors of functions of a module without a status have a receiver") {
    Game game;
    std::vector<std::string> errors;
    game.thrower.on_error([&](const std::string& message) { errors.push_back(message); });
    CHECK(game.outcome("step", [&] { game.thrower.step(0.1); }).empty());
    CHECK(game.outcome("destroy",
                       [&] {
                           game.tree.destroy(game.one);
                           game.tree.barrier();
                           game.one = game.tree.create(game.tree.class_named("Fragile"),
                                                       game.tree.root(), "two");
                       })
              .empty());
    game.thrower.step(0.1);
    CHECK(errors ==
          std::vector<std::string>{"step: no step today", "destroy of Fragile: no destroy today"});
}

TEST_CASE("the elements of lists in a list may be anything") {
    Game game;
    const List rows = {List{std::int64_t{1}, "a"}, List{}, List{List{true}}};
    game.tree.set(game.one, "rows", rows);
    CHECK(game.tree.get(game.one, "rows") == Value(rows));
    CHECK_THROWS_WITH(game.tree.set(game.one, "rows", List{List{}, 5.0}),
                      Catch::Matchers::StartsWith("one.rows[2]: expected a list of lists, got"));
}

TEST_CASE("arguments of a method have the class and the elements that it declares") {
    Game game;
    property::Tree& tree = game.tree;
    CHECK_NOTHROW(tree.call(game.one, "measure", {Value(game.one), List{1.0, 2.0}}));
    CHECK_THROWS_WITH(
        tree.call(game.one, "measure", {Value(tree.root()), List{}}),
        Catch::Matchers::StartsWith("one:measure(): argument \"from\": expected a Fragile"));
    CHECK_THROWS_WITH(
        tree.call(game.one, "measure", {Value(game.one), List{1.0, "x"}}),
        Catch::Matchers::StartsWith("one:measure(): argument \"at\"[2]: expected a number"));
}

}  // namespace throwing_test
