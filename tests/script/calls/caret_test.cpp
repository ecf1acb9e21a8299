// The column of an error, to which the caret below its source line points, and its traceback.

#include <fettle/script/runtime.h>

#include <string>

#include "catch.h"
#include "stage.h"

namespace caret_test {

using fettle::script::Evaluation;
using stage::Stage;

TEST_CASE("a traceback names the callbacks of a game and no functions of Fettle") {
    Stage s;
    s.run("function update(dt) local x = world.nothing.x end");
    CHECK_FALSE(s.runtime->call("update", {fettle::property::Value(0.1)}));
    REQUIRE(!s.errors.empty());
    CHECK(s.errors.back().traceback == "  main.lua:1: in function update\n");
}

TEST_CASE("the caret of a syntax error is at the token that the message names") {
    const auto [text, column] = GENERATE(table<std::string, int>({{"local t = { a = 1 b = 2 }", 19},
                                                                  {"foo(1, 2 3)", 10},
                                                                  {"x = = 1", 5},
                                                                  {"if x then y = 1 end end", 21},
                                                                  {"local s = 'end' end x", 17},
                                                                  {"x = 1\ny = = 2", 5}}));
    Stage s;
    s.fails(text);
    INFO(text);
    CHECK(s.errors.front().column == column);
    const Evaluation typed = s.runtime->evaluate(text);
    REQUIRE(typed.error);
    CHECK(typed.error->column == column);
}

TEST_CASE("the caret of an error is at the name in error and not at the same name elsewhere") {
    // The bar marks the place.
    std::string text = GENERATE(as<std::string>(), "local d = world.a.hp - world.b.|hp",
                                "world.a.hp = 2 * (world.b.|hp or 0)",
                                "local a, b = world.a, world.b local d = a.hp - b.|hp",
                                "print('hp', world.b.|hp) -- hp", "local t = {} t.x = 1 |y.x = 2",
                                "print(|nothing, 1)");
    const std::size_t bar = text.find('|');
    text.erase(bar, 1);
    Stage s;
    s.run("world.a = Body {} world.a.hp = 1 world.b = Body {}");
    s.fails(text);
    INFO(text << "\n" << s.errors.front().message);
    CHECK(s.errors.front().column == static_cast<int>(bar) + 1);
}

TEST_CASE("the caret of an error that a script raises is at the call of error") {
    // The bar marks the place.
    std::string text = GENERATE(as<std::string>(), "|error('oops')", "local x = 1 |error(\"in x\")",
                                "local ball = 2 |error('ball: ' .. ball)",
                                "local ball if not ball then |error { code = 3 } end");
    const std::size_t bar = text.find('|');
    text.erase(bar, 1);
    Stage s;
    s.fails(text);
    INFO(text << "\n" << s.errors.front().message);
    CHECK(s.errors.front().column == static_cast<int>(bar) + 1);
    const Evaluation typed = s.runtime->evaluate(text);
    REQUIRE(typed.error);
    CHECK(typed.error->column == static_cast<int>(bar) + 1);
}

TEST_CASE("an error whose place in the line is not clear has no caret") {
    Stage s;
    s.fails("print(vec(1, 2), vec('a', 2))");
    CHECK(s.errors.front().column == 0);
}

}  // namespace caret_test
