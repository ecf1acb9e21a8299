// Calls of scripts that do not return.

#include <thread>

#include "stage.h"

namespace long_call_test {

using fettle::script::LongCall;
using stage::Stage;
using stage::starts_with;

namespace {

constexpr double patience = 0.03;  // s: the loops in these tests run longer on any machine

}  // namespace

TEST_CASE("an endless loop in a game is stopped if the host does not extend its time") {
    const std::string loop =
        GENERATE(as<std::string>{}, "while true do end", "while true do pcall(error) end",
                 "while true do pcall(function() while true do end end) end",
                 "coroutine.wrap(function() while true do end end)()",
                 "while true do coroutine.wrap(function() for i = 1, 900 do end end)() end",
                 "xpcall(function() while true do end end, function() while true do end end)",
                 "local x <close> = setmetatable({}, { __close = function() while true do end end "
                 "}) while true do end",
                 "goto top ::top:: goto top", "return (('a'):rep(30000)):match('.-.-.-.-b')",
                 "table.sort({3, 2, 1, 4, 5}, function() while true do end end)",
                 "while true do world.scale = world.scale + 1 end",
                 "string.gsub(('x'):rep(1e6), '.', function() while true do end end)",
                 "return tostring(setmetatable({}, { __tostring = function() while true do end end "
                 "}))");
    Stage s;
    s.runtime->limit_calls(patience, {});
    CAPTURE(loop);
    s.errors.clear();
    CHECK_FALSE(s.runtime->run("local n = 1\n" + loop, "main.lua"));
    REQUIRE(s.errors.size() == 1);
    CHECK_THAT(s.errors.front().message, starts_with("main.lua:2: stopped: it ran for "));
    CHECK(s.errors.front().line == 2);
    CHECK(s.errors.front().source_line != "");
    // The game continues, and calls that return in time are not stopped.
    CHECK(s.prints("local n = 0 for i = 1, 10000 do n = n + 1 end print(n)") == "10000");
    CHECK(s.console("1 + 1") == "2");
}

TEST_CASE("an endless loop is stopped in every kind of call by the host", "[long]") {
    Stage s;
    s.run(R"lua(
function update() if loops == "update" then while true do end end end
Thing = class("Thing", Object) {}
calls = 0
function Thing:step() calls = calls + 1 if loops == "step" then while true do end end end
for i = 1, 5 do world["t" .. i] = Thing {} end
world:watch("scale", function() if loops == "watcher" then while true do end end end)
after(0.01, function() if loops == "timer" then while true do end end end)
loops = ""
)lua");
    s.runtime->limit_calls(patience, {});
    const auto reported = [&] {
        REQUIRE(s.errors.size() == 1);
        const auto error = s.errors.front();
        s.errors.clear();
        CHECK_THAT(error.message, contains("stopped: it ran for "));
        return error.context + " " + std::to_string(error.line);
    };
    s.run("loops = 'update'");
    CHECK_FALSE(s.runtime->call("update", {}));
    CHECK(reported() == "update 2");
    s.run("loops = 'timer'");
    s.step();
    CHECK(reported() == "timer 8");
    // Stopping the first endless instance of the class is enough: the others run in the next step.
    s.run("loops = 'step' calls = 0");
    s.step();
    CHECK(reported() == "Thing:step of world.t1 5");
    CHECK(s.prints("print(calls)") == "1");
    s.run("loops = 'watcher' world.scale = 3");
    s.tree->barrier();
    CHECK(reported() == "watcher of world.scale 7");
    s.run("loops = ''");
    s.step(3);
    CHECK(s.errors.empty());
}

TEST_CASE("the host gets the place of a long call and may extend its time", "[long]") {
    Stage s;
    std::vector<std::string> places;
    std::string said;
    s.runtime->limit_calls(patience, [&](const LongCall& call) {
        places.push_back(call.where.file + ":" + std::to_string(call.where.line) + " " +
                         call.where.source_line);
        CHECK(call.seconds >= patience);
        CHECK_THAT(call.where.traceback, contains("in function spin"));
        CHECK_THAT(call.where.locals, contains("apples = 7"));
        // The console works during the question, and its commands have their budget.
        if (places.size() == 1) said = s.console("while true do end");
        if (places.size() == 3) said += "|" + s.console("done = true");
        return true;
    });
    s.run(R"lua(
done = false
local function spin()
    local apples = 7
    while not done do end
    return apples
end
result = spin()
)lua");
    CHECK(places.size() >= 3);
    CHECK(places.front() == "main.lua:5     while not done do end");
    CHECK_THAT(said, starts_with("error: console:1: stopped"));
    CHECK(s.prints("print(result)") == "7");
}

TEST_CASE(
    "the function of the host for long calls is called at intervals until the call is stopped",
    "[long]") {
    Stage s;
    int host_calls = 0;
    s.runtime->limit_calls(patience, [&](const LongCall&) { return ++host_calls < 4; });
    s.fails("while true do end");
    CHECK(host_calls == 4);
    // The same within a coroutine.
    host_calls = 0;
    s.fails("coroutine.wrap(function() while true do end end)()");
    CHECK(host_calls == 4);
}

TEST_CASE("a long call whose runtime is destroyed is stopped with any answer") {
    Stage s;
    fettle::script::Runtime& runtime = *s.runtime;
    runtime.limit_calls(patience, [&](const LongCall&) {
        s.runtime.reset();
        return true;
    });
    CHECK_FALSE(runtime.run("while true do end", "main.lua"));
    CHECK(s.runtime == nullptr);
}

TEST_CASE("calls are limited only if the host requests it", "[long]") {
    Stage s;
    s.runtime->limit_calls(patience, {});
    s.runtime->limit_calls(0, {});
    s.run("local t = os.clock() while os.clock() - t < 0.2 do end");
    CHECK(s.errors.empty());
}

TEST_CASE("a console command keeps its own budget while calls are limited") {
    Stage s;
    int host_calls = 0;
    s.runtime->limit_calls(patience, [&](const LongCall&) { return ++host_calls > 0; });
    CHECK_THAT(s.console("while true do end"), contains("instructions") || contains("seconds"));
    CHECK(host_calls == 0);
}

TEST_CASE("an endless call is stopped by default for every kind of runtime", "[long]") {
    CHECK(fettle::script::Options().call_seconds == 10);
    fettle::script::Options options;
    options.call_seconds = patience;
    Stage s(options);
    s.run("function update() while true do end end function draw() while true do end end");
    CHECK_FALSE(s.runtime->run("while true do end", "chunk"));
    CHECK_FALSE(s.runtime->call("update", {}));
    REQUIRE(s.errors.size() == 2);
    CHECK_THAT(s.errors[0].message, starts_with("chunk:1: stopped: it ran for "));
    CHECK_THAT(s.errors[1].message, starts_with("main.lua:1: stopped: it ran for "));
    s.errors.clear();
    s.run("x = 1");
}

TEST_CASE("nested calls of two runtimes are limited separately") {
    fettle::script::Options options;
    options.call_seconds = patience;
    Stage inner(options), outer(options);
    int reported = 0;
    outer.runtime->on_print([&](std::string_view) {
        ++reported;
        CHECK_FALSE(inner.runtime->run("while true do end", "inner"));
    });
    CHECK_FALSE(outer.runtime->run("print('go') while true do end", "outer"));
    CHECK(reported == 1);
    REQUIRE(inner.errors.size() == 1);
    CHECK_THAT(inner.errors[0].message, starts_with("inner:1: stopped"));
    REQUIRE(outer.errors.size() == 1);
    CHECK_THAT(outer.errors[0].message, starts_with("outer:1: stopped"));
}

TEST_CASE("a runtime whose calls are limited may be called on any thread") {
    fettle::script::Options options;
    options.call_seconds = patience;
    Stage s(options);
    s.run("x = 1");
    std::thread([&] { CHECK_FALSE(s.runtime->run("while true do end", "chunk")); }).join();
    REQUIRE(s.errors.size() == 1);
    CHECK_THAT(s.errors[0].message, starts_with("chunk:1: stopped"));
}

}  // namespace long_call_test
