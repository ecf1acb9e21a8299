// The cost of properties in Lua, in a function that the host calls like a game's callbacks.

#include <iostream>
#include <stdexcept>
#include <string>

#include "costs/bare_lua.h"
#include "costs/cost_table.h"
#include "costs/love.h"
#include "engines/hosted_engine.h"

namespace fettle::bench {
namespace {

constexpr int unrolled = 10;  // reduces the share of the loop itself
constexpr int rounds = 200;   // per call
constexpr int operations = unrolled * rounds;
// As many accesses in a step as a busy game makes. With many more, the log for going back in time
// would reach its limit and stop, and its cost would not be measured.
constexpr int calls_a_step = 10;
// LÖVE's clock has a resolution of microseconds, so its runs are longer.
constexpr int rounds_in_love = 100 * rounds;

std::string repeated(const std::string& first, const std::string& second) {
    std::string text;
    for (int i = 0; i < unrolled; ++i) text += i % 2 == 0 ? first : second;
    return text;
}

/// A global function that repeats one operation; the same in Fettle, LÖVE and bare Lua.
std::string function_of(const std::string& name, const std::string& ball, const std::string& before,
                        const std::string& inside) {
    return "function " + name + "(rounds)\n  local ball = " + ball + "\n  " + before +
           "\n  for i = 1, rounds do " + inside + "end\nend\n";
}

/// The cost of the loop itself.
std::string empty_loop(const std::string& ball) {
    return function_of("nothing", ball, "local x", "");
}

std::string scalar_get(const std::string& ball, const std::string& property) {
    const std::string get = "x = ball." + property + " ";
    return function_of("get_" + property, ball, "local x", repeated(get, get));
}

// Values alternate, because a write of an equal value stops early.
std::string scalar_set(const std::string& ball, const std::string& property) {
    return function_of("set_" + property, ball, "local a, b = 1.5, 2.5",
                       repeated("ball." + property + " = a ", "ball." + property + " = b "));
}

std::string vec2_set(const std::string& ball, const std::string& property) {
    return function_of("set_" + property, ball, "local a, b = vec(1, 2), vec(2, 1)",
                       repeated("ball." + property + " = a ", "ball." + property + " = b "));
}

/// The same loops with the methods of a body in LÖVE.
std::string functions_in_love() {
    const std::string mass = "x = ball:getMass() ", position = "x, y = ball:getPosition() ";
    return empty_loop("ball") + function_of("getMass", "ball", "local x", repeated(mass, mass)) +
           function_of("getPosition", "ball", "local x, y", repeated(position, position)) +
           function_of("setAngularVelocity", "ball", "local a, b = 1.5, 2.5",
                       repeated("ball:setAngularVelocity(a) ", "ball:setAngularVelocity(b) ")) +
           function_of("setLinearVelocity", "ball", "local a, b = 1, 2",
                       repeated("ball:setLinearVelocity(a, b) ", "ball:setLinearVelocity(b, a) "));
}

BareLua& bare_lua() {
    static BareLua lua(empty_loop("ball") + scalar_get("ball", "mass") +
                       scalar_set("ball", "mass"));
    return lua;
}

HeadlessGame& bench_game() {
    static HeadlessGame made;
    static const bool running = [] {
        const std::string ball = "world.ball";
        const bool loaded = made.runtime.run(
            "world.ball = Body { position = vec(0, 8), Circle { radius = 0.5 } }\n" +
                empty_loop(ball) + scalar_get(ball, "mass") + scalar_get(ball, "angular_velocity") +
                scalar_get(ball, "position") + scalar_set(ball, "angular_velocity") +
                scalar_set(ball, "linear_damping") + vec2_set(ball, "velocity"),
            "bench");
        // Steps complete the work that edits left, as in a running game.
        for (int i = 0; i < 10; ++i) made.loop.turn();
        return loaded;
    }();
    if (!running) throw std::runtime_error("the script to be measured did not run");
    return made;
}

CostLoop in_game(const std::string& function) {
    return [function](benchmark::State& state) {
        HeadlessGame& playing = bench_game();
        if (!playing.runtime.defines(function)) throw std::logic_error("no " + function);
        int called = 0;
        for (auto _ : state) {
            playing.runtime.call(function, {rounds});
            if (++called % calls_a_step != 0) continue;
            state.PauseTiming();
            playing.loop.turn();
            state.ResumeTiming();
        }
        playing.loop.turn();
    };
}

CostLoop in_bare_lua(const char* function) {
    return [function](benchmark::State& state) {
        BareLua& lua = bare_lua();
        for (auto _ : state) lua.call(function, rounds);
    };
}

Love& love() {
    static Love love(functions_in_love());
    return love;
}

CostLoop in_love(const char* function) {
    return [function](benchmark::State& state) {
        for (auto _ : state) state.SetIterationTime(love().seconds(function, rounds_in_love));
    };
}

const std::string loop_itself = "Lua: the loop itself";
const std::string loop_in_love = "L\u00d6VE: the loop itself";

void add_love_costs(CostTable& table) {
    if (!love().running()) {
        std::cerr << "L\u00d6VE is not installed: its rows are left out\n";
        return;
    }
    const auto row = [&](const std::string& name, const char* function) {
        table.add({.name = name,
                   .operations = double{unrolled} * rounds_in_love,
                   .loop = in_love(function),
                   .without = name == loop_in_love ? std::vector<std::string>{}
                                                   : std::vector{loop_in_love},
                   .own_clock = true,
                   .shown = name != loop_in_love});
    };
    row(loop_in_love, "nothing");
    row("L\u00d6VE: body:getMass()", "getMass");
    row("L\u00d6VE: body:getPosition()", "getPosition");
    row("L\u00d6VE: body:setAngularVelocity(w)", "setAngularVelocity");
    row("L\u00d6VE: body:setLinearVelocity(x, y)", "setLinearVelocity");
}

}  // namespace

void add_lua_costs(CostTable& table) {
    const std::string get = "Lua: the barest metamethod that gets";
    const std::string set = "Lua: the barest metamethod that sets";
    const std::string bare_loop = "Lua: the loop of the barest itself";
    add_love_costs(table);
    table.add({.name = bare_loop,
               .operations = operations,
               .loop = in_bare_lua("nothing"),
               .shown = false});
    table.add({.name = loop_itself,
               .operations = operations,
               .loop = in_game("nothing"),
               .shown = false});
    const auto bare = [&](const std::string& name, const char* function) {
        table.add({.name = name,
                   .operations = operations,
                   .loop = in_bare_lua(function),
                   .without = {bare_loop}});
    };
    const auto row = [&](const std::string& name, const char* function,
                         std::vector<CostTable::Against> against) {
        table.add({.name = name,
                   .operations = operations,
                   .loop = in_game(function),
                   .against = std::move(against),
                   .without = {loop_itself}});
    };
    // Bounds of the design: a scalar and a vec2 relative to the bare metamethod, and a vec2
    // relative to LÖVE.
    const Bound scalar = at_most(1.75), vec2 = at_most(3), vec2_in_love = at_most(1.5);
    bare(get, "get_mass");
    row("Lua: get ball.mass", "get_mass", {{get, scalar}, {"L\u00d6VE: body:getMass()"}});
    row("Lua: get ball.angular_velocity", "get_angular_velocity", {{get, scalar}});
    row("Lua: get ball.position", "get_position",
        {{get, vec2}, {"L\u00d6VE: body:getPosition()", vec2_in_love}});
    bare(set, "set_mass");
    row("Lua: set ball.angular_velocity", "set_angular_velocity",
        {{set, scalar}, {"L\u00d6VE: body:setAngularVelocity(w)"}});
    row("Lua: set ball.linear_damping", "set_linear_damping", {{set, scalar}});
    row("Lua: set ball.velocity", "set_velocity",
        {{set, vec2}, {"L\u00d6VE: body:setLinearVelocity(x, y)", vec2_in_love}});
}

}  // namespace fettle::bench
