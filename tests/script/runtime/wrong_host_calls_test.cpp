#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include <fettle/property/error.h>
#include <fettle/property/storage/scene.h>

#include "stage.h"

namespace wrong_host_calls_test {

// Invalid arguments of a host for a runtime: each is an error with an explanation.

using namespace stage;
using fettle::property::Error;
using fettle::property::Tree;
using fettle::script::Options;
using fettle::script::Runtime;

namespace {

std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("a runtime refuses invalid times") {
    Stage stage;
    const double nan = std::nan("");
    for (const double wrong : {nan, -1.0, std::numeric_limits<double>::infinity()}) {
        CHECK_THAT(message_of([&] { stage.runtime->limit_calls(wrong, {}); }),
                   contains("limit_calls: seconds = "));
        CHECK_THAT(message_of([&] { stage.runtime->step(wrong, 0.1); }), contains("now = "));
        CHECK_THAT(message_of([&] { stage.runtime->step(1, wrong); }), contains("dt = "));
        CHECK_THAT(message_of([&] {
                       Tree tree;
                       Options options;
                       options.call_seconds = wrong;
                       Runtime runtime(tree, options);
                   }),
                   contains("Options::call_seconds = "));
    }
    CHECK(stage.runtime->step(1, 0.1));
}

TEST_CASE("a wrong time is written without superfluous digits") {
    Stage stage;
    CHECK_THAT(message_of([&] { stage.runtime->limit_calls(-1, {}); }),
               contains("limit_calls: seconds = -1: expected a time in seconds, at least 0"));
}

TEST_CASE("too little memory for a command is reported with the required amount") {
    Tree tree;
    Options options;
    options.console_memory = 0;
    CHECK_THAT(message_of([&] { Runtime runtime(tree, options); }),
               contains("Options::console_memory = 0 bytes: a command needs 65536 at least"));
    options.console_memory = std::size_t{1} << 16;
    CHECK(Runtime(tree, options).evaluate("x = {1, 2, 3}").ok);
}

TEST_CASE("too little memory for Lua is reported with the required amount") {
    Tree tree;
    Options options;
    options.memory_limit = 1000;
    CHECK_THAT(message_of([&] { Runtime runtime(tree, options); }),
               contains("Options::memory_limit = 1000 bytes: Lua with its library needs 1048576"));
    options.memory_limit = std::size_t{1} << 20;
    Runtime runtime(tree, options);
    CHECK(runtime.run("local x = 1", "main.lua"));
}

TEST_CASE("a game with an empty path is a file that cannot be read") {
    Stage stage;
    CHECK_THROWS_AS(stage.runtime->load(""), fettle::property::FileError);
    CHECK_THROWS_AS(stage.runtime->load("/nowhere/at/all"), fettle::property::FileError);
}

TEST_CASE("an exception of no known type of a function of the host is an error with a text") {
    Stage stage;
    stage.runtime->add_function("spill", [](auto) -> fettle::property::Value { throw 3; });
    std::string message;
    stage.runtime->on_print([&](std::string_view line) { message += line; });
    CHECK(stage.runtime->run("local ok, text = pcall(spill) print(text)", "main.lua"));
    CHECK(message == "main.lua:1: an exception of no known type");
}

TEST_CASE("a function of the host has a name and a function") {
    Stage stage;
    CHECK(message_of([&] { stage.runtime->add_function("spill", {}); }) ==
          "add_function: spill: expected a function, got an empty one");
    for (const char* wrong : {"", "a b", "end"}) {
        CHECK_THAT(message_of([&] {
                       stage.runtime->add_function(wrong,
                                                   [](auto) { return fettle::property::Value(); });
                   }),
                   contains("expected a name as in Lua"));
    }
}

TEST_CASE("a function for commands that destroys the tree ends the command") {
    Stage stage;
    stage.runtime->on_command([&](std::string_view) { stage.tree.reset(); });
    CHECK_THAT(message_of([&] { stage.runtime->evaluate("1 + 1"); }),
               contains("the tree of this runtime was destroyed"));
}

TEST_CASE(
    "a function of the host may restore a snapshot or step again while instances are stepped") {
    Stage stage;
    int depth = 0;
    std::function<void()> act;
    stage.runtime->add_function("disturb", [&](auto) {
        if (++depth == 1 && act) act();
        --depth;
        return fettle::property::Value();
    });
    stage.run(
        "count = 0 Walker = class('Walker', Object) {} "
        "function Walker:step() count = count + 1 disturb() end game.first = Walker {}");
    CHECK(stage.runtime->step(0.1, 0.1));
    const auto one = stage.tree->snapshot();
    const auto steps = [&] {
        stage.run("count = 0");
        CHECK(stage.runtime->step(1, 0.1));
        return stage.prints("print(count)");
    };
    act = [&] { stage.tree->restore(one); };
    stage.run("for i = 1, 500 do game['more_' .. i] = Walker {} end");
    CHECK(steps() == "1");  // the snapshot has no others
    CHECK(steps() == "1");

    act = [&] { stage.runtime->step(2, 0.1); };
    stage.run(
        "for i = 1, 500 do game['more_' .. i] = Walker {} end "
        "for i = 1, 400 do game['more_' .. i]:delete() end");
    CHECK(steps() == std::to_string(101 * 102));
    act = {};
    CHECK(steps() == "101");
}

}  // namespace wrong_host_calls_test
