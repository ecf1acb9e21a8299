// Games that are not trusted: every call of the host into their scripts is limited.

#include <fettle/property/painter.h>

#include "stage.h"

namespace untrusted_test {

using stage::Stage;

namespace {

fettle::script::Options limited() {
    fettle::script::Options options = stage::unhurried();
    options.memory_limit = std::size_t{48} << 20;
    options.limits = {.instructions = 1'000'000,
                      .memory = std::size_t{48} << 20,
                      .instances = 20'000,
                      .handlers = 10'000,
                      .timers = 10'000,
                      .output = 100'000};
    return options;
}

struct NoPainter : fettle::property::Painter {
    using Paint = fettle::property::Paint;
    void circle(const stage::Vec2&, double, const Paint&) override {}
    void ellipse(const stage::Vec2&, const stage::Vec2&, double, const Paint&) override {}
    void polygon(std::span<const stage::Vec2>, double, const Paint&) override {}
    void line(const stage::Vec2&, const stage::Vec2&, stage::Color, float) override {}
    void point(const stage::Vec2&, stage::Color, float) override {}
    void text(const stage::Vec2&, std::string_view, double, stage::Color,
              fettle::property::TextAlign) override {}
    void part_of(std::uint64_t) override {}
    bool shows(fettle::property::Overlay) const override { return false; }
    bool sees(const stage::Vec2&, const stage::Vec2&) const override { return true; }
    void begin_screen() override {}
    void end_screen() override {}
};

/// The error of a callback with this text.
std::string attacked(Stage& s, const std::string& text) {
    s.run("function update() " + text + " end");
    s.errors.clear();
    CHECK_FALSE(s.runtime->call("update", {}));
    return s.errors.empty() ? "" : s.errors.front().message;
}

}  // namespace

TEST_CASE("a callback of an untrusted game cannot run without end") {
    const std::string attack = GENERATE(
        as<std::string>{}, "while true do end", "while true do pcall(error) end",
        "while true do pcall(function() while true do end end) end",
        "xpcall(function() while true do end end, function() while true do end end)",
        "local function f() while true do coroutine.wrap(f)() end end f()",
        "local co = coroutine.create(function() while true do end end) "
        "while true do coroutine.resume(co) end",
        "local x <close> = setmetatable({}, { __close = function() while true do end end }) "
        "while true do end",
        "print(setmetatable({}, { __tostring = function() while true do end end }))",
        "local t = setmetatable({}, { __index = function(t, k) return t[k .. 'x'] end }) return "
        "t.x",
        "string.gsub(('x'):rep(1e6), '.', function() while true do end end)",
        "return (('a'):rep(30000)):match('.-.-.-.-b')",
        "return (('a'):rep(100)):find(('.-'):rep(50) .. 'b')",
        "while true do pcall(string.rep, 'x', 1e10) end",
        "while true do local s = ('x'):rep(1e6) end", "while true do collectgarbage() end",
        "for i = 1, 1e9 do world.luck = i end",
        "error(setmetatable({}, { __tostring = function() "
        "while true do end end }))");
    Stage s(limited());
    CAPTURE(attack);
    const std::string message = attacked(s, attack);
    CHECK_THAT(message, contains("main.lua:1: ") || contains("stopped") || contains("overflow"));
    // Later calls have a budget of their own.
    CHECK(s.prints("print(1 + 1)") == "2");
}

TEST_CASE("a chunk that the host runs has the limit of instructions of a callback") {
    Stage s(limited());
    CHECK_FALSE(s.runtime->run("while true do end", "main.lua"));
    REQUIRE(s.errors.size() == 1);
    CHECK_THAT(s.errors.front().message, contains("main.lua:1: ") && contains("instructions"));
}

TEST_CASE("an untrusted game cannot take more memory than it may") {
    const std::string attack = GENERATE(
        as<std::string>{}, "return ('x'):rep(1e10)", "local s = 'x' while true do s = s .. s end",
        "local t = {} while true do pcall(function() for i = 1, 1e9 do t[#t + 1] = i .. 'x' end "
        "end) "
        "end",
        "return table.concat(setmetatable({}, { __index = function() return 'x' end }), '', 1, "
        "1e9)",
        "table.move({}, 1, 1e9, 2)",
        "table.insert(setmetatable({}, { __len = function() return 1e15 "
        "end }), 1, 2) while true do end",
        "return ('%99.99f'):rep(1e6):format(1)", "load(('('):rep(1e5))() while true do end",
        "local function f(n) return f(n + 1) + 1 end return f(1)",
        "world.list = {} for i = 1, 1e9 do world.list[i] = i end");
    Stage s(limited());
    CAPTURE(attack);
    attacked(s, attack);
    CHECK(s.runtime->memory() < (std::size_t{50} << 20));
    s.run("local t = {} for i = 1, 100 do t[i] = {} end");
}

TEST_CASE("memory is limited over all calls and not only in one") {
    Stage s(limited());
    s.run("all = {} function update() for i = 1, 20000 do all[#all + 1] = { i } end end");
    int calls = 0;
    while (calls < 200 && s.runtime->call("update", {})) ++calls;
    CHECK(calls > 3);
    CHECK(calls < 60);
    REQUIRE_FALSE(s.errors.empty());
    CHECK_THAT(
        s.errors.front().message,
        contains("main.lua:1: ") && contains("the scripts of a game may use, 48 MB; Lua has 4"));
}

TEST_CASE("events that wait for the end of a step count as memory of an untrusted game") {
    auto options = limited();
    options.limits.instructions = std::uint64_t{1} << 50;
    Stage s(options);
    s.run(
        "world.foe = class('Foe', Object) { events = { hit = { by = '' } } } { }\n"
        "world.foe:on('hit', function() end) long = ('x'):rep(1000)\n"
        "function update() for i = 1, count do world.foe:send('hit', { by = long }) end end "
        "count = 100");
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(s.runtime->call("update", {}));
        s.step();
    }
    s.run("count = 1e6");
    CHECK_FALSE(s.runtime->call("update", {}));
    CHECK_THAT(s.errors.front().message, contains("main.lua:3: stopped: it needs more memory than "
                                                  "the scripts of a game may"));
}

TEST_CASE("events that classes declare count as memory of an untrusted game") {
    auto options = limited();
    options.limits.instructions = std::uint64_t{1} << 50;
    Stage s(options);
    const std::string attack =
        GENERATE(as<std::string>{}, "class('C' .. n, Object) { events = events }",
                 "class('C' .. n, n > 1 and 'C' .. n - 1 or Object) { events = { 'e' .. n } }");
    CAPTURE(attack);
    s.run(
        "events, n = {}, 0 for e = 1, 100 do local fields = {} "
        "for f = 1, 32 do fields['field' .. f] = 0 end events['event' .. e] = fields end\n"
        "function update() n = n + 1 " +
        attack + " end");
    int calls = 0;
    while (calls < 3000 && s.runtime->call("update", {})) ++calls;
    CHECK(calls < 3000);
    REQUIRE_FALSE(s.errors.empty());
    CHECK_THAT(s.errors.front().message, contains("main.lua:2: stopped: it needs more memory than "
                                                  "the scripts of a game may"));
}

TEST_CASE("the numbers of instances and handlers and timers of an untrusted game are limited") {
    const auto [attack, what] = GENERATE(table<std::string, std::string>({
        {"for i = 1, 3000 do all[#all + 1] = world:add(Object { }) end", "instances"},
        {"local c = all[1]:clone() all[#all + 1] = world:add(c) for i = 1, 1500 do "
         "world:add(Object "
         "{ }) end",
         "instances"},
        {"for i = 1, 3000 do world:watch('luck', print) end", "handlers"},
        {"for i = 1, 3000 do after(1e6, print) end", "timers"},
    }));
    CAPTURE(attack);
    Stage s(limited());
    s.run("world.luck = 1 all = { world:add(Object { }) } function update() " + attack + " end");
    int calls = 0;
    while (calls < 100 && s.runtime->call("update", {})) ++calls;
    CHECK(calls < 30);
    REQUIRE_FALSE(s.errors.empty());
    CHECK_THAT(s.errors.front().message, contains("main.lua:1: stopped: there are ") &&
                                             contains(what) && contains("this game may have"));
}

TEST_CASE("an untrusted game cannot flood the log") {
    Stage s(limited());
    s.run("function update() for i = 1, 1000 do print(('x'):rep(50)) end end");
    int calls = 0;
    while (calls < 100 && s.runtime->call("update", {})) ++calls;
    CHECK(calls == 1);
    CHECK_THAT(s.errors.front().message,
               contains("main.lua:1: stopped: it has printed more than 100000 bytes"));
    CHECK(s.printed.size() < 2000);
}

// The limit of time holds for functions of the host too, of which some thousand instructions may
// take minutes.
TEST_CASE("the time of a call of an untrusted game is limited by the host") {
    auto options = limited();
    options.limits.instructions = std::uint64_t{1} << 50;
    Stage s(options);
    s.runtime->limit_calls(0.2, {});
    CHECK_THAT(attacked(s, "while true do world:find('World') end"),
               contains("main.lua:1: stopped: it ran for 0.2 seconds"));
}

TEST_CASE("the drawing of an untrusted game is counted as instructions") {
    const std::string attack =
        GENERATE(as<std::string>{}, "for i = 1, 2000 do pen.circle(vec(0, 0), 1) end",
                 "for i = 1, 2000 do pen.text('x', vec(0, 0)) end",
                 "for i = 1, 2000 do pen.push() pen.pop() end",
                 "local t = {} for i = 1, 2000 do t[i] = vec(i, i * i % 7) end pen.polygon(t)");
    Stage s(limited());
    CAPTURE(attack);
    s.run("function draw(pen) " + attack + " end");
    NoPainter painter;
    s.runtime->draw(painter);
    REQUIRE_FALSE(s.errors.empty());
    CHECK_THAT(s.errors.front().message,
               contains("main.lua:1: stopped: it ran past its budget of 1000000 instructions"));
}

TEST_CASE("an untrusted game within its limits runs normally") {
    Stage s(limited());
    s.run("world.ball = Body { } function step() world.ball.mass = world.ball.mass + 1 end");
    s.step(100);
    CHECK(s.get("world.ball.mass").as_double() == 101);
    CHECK(s.errors.empty());
}

}  // namespace untrusted_test
