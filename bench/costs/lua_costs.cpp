// What properties cost in Lua, in a function that the host calls as it calls a game's callbacks.

#include <memory>
#include <stdexcept>
#include <string>

#include "costs/bare_lua.h"
#include "costs/cost_table.h"
#include "engines/hosted_engine.h"

namespace fettle::bench {
namespace {

constexpr int unrolled = 10;  // so that the loop itself counts little
constexpr int rounds = 200;   // a call
constexpr int operations = unrolled * rounds;

std::string repeated(const std::string& first, const std::string& second) {
    std::string text;
    for (int i = 0; i < unrolled; ++i) text += i % 2 == 0 ? first : second;
    return text;
}

/// Of the same text in both: a global function that does one thing again and again.
std::string function_of(const std::string& name, const std::string& ball, const std::string& before,
                        const std::string& inside) {
    return "function " + name + "(rounds)\n  local ball = " + ball + "\n  " + before +
           "\n  for i = 1, rounds do " + inside + "end\nend\n";
}

// Values alternate: an equal one would stop half way.
std::string scalar_get(const std::string& ball, const std::string& property) {
    const std::string get = "x = ball." + property + " ";
    return function_of("get_" + property, ball, "local x", repeated(get, get));
}

std::string scalar_set(const std::string& ball, const std::string& property) {
    return function_of("set_" + property, ball, "local a, b = 1.5, 2.5",
                       repeated("ball." + property + " = a ", "ball." + property + " = b "));
}

std::string vec2_set(const std::string& ball, const std::string& property) {
    return function_of("set_" + property, ball, "local a, b = vec(1, 2), vec(2, 1)",
                       repeated("ball." + property + " = a ", "ball." + property + " = b "));
}

BareLua& bare_lua() {
    static BareLua lua(scalar_get("ball", "mass") + scalar_set("ball", "mass"));
    return lua;
}

HeadlessGame& game() {
    static HeadlessGame game;
    static const bool loaded = game.runtime.run(
        "world.ball = Body { position = vec(0, 8), Circle { radius = 0.5 } }\n" +
            scalar_get("world.ball", "mass") + scalar_get("world.ball", "angular_velocity") +
            scalar_get("world.ball", "position") + scalar_set("world.ball", "angular_velocity") +
            scalar_set("world.ball", "linear_damping") + vec2_set("world.ball", "velocity"),
        "bench");
    if (!loaded) throw std::runtime_error("the script to be measured did not run");
    // What a step leaves to do after an edit has been done, as in any game that runs.
    static const bool running = [] {
        for (int i = 0; i < 10; ++i) game.loop.turn();
        return true;
    }();
    if (!running) throw std::logic_error("the game did not start");
    return game;
}

CostLoop in_game(const std::string& function) {
    return [function](benchmark::State& state) {
        HeadlessGame& playing = game();
        if (!playing.runtime.defines(function)) throw std::logic_error("no " + function);
        for (auto _ : state) playing.runtime.call(function, {rounds});
        playing.tree.barrier();
    };
}

CostLoop in_bare_lua(const char* function) {
    return [function](benchmark::State& state) {
        BareLua& lua = bare_lua();
        for (auto _ : state) lua.call(function, rounds);
    };
}

}  // namespace

void add_lua_costs(CostTable& table) {
    const std::string get = "Lua: the barest metamethod that gets";
    const std::string set = "Lua: the barest metamethod that sets";
    table.add(get, "", operations, in_bare_lua("get_mass"));
    table.add("Lua: get ball.mass", get, operations, in_game("get_mass"));
    table.add("Lua: get ball.angular_velocity", get, operations, in_game("get_angular_velocity"));
    table.add("Lua: get ball.position", get, operations, in_game("get_position"));
    table.add(set, "", operations, in_bare_lua("set_mass"));
    table.add("Lua: set ball.angular_velocity", set, operations, in_game("set_angular_velocity"));
    table.add("Lua: set ball.linear_damping", set, operations, in_game("set_linear_damping"));
    table.add("Lua: set ball.velocity", set, operations, in_game("set_velocity"));
}

}  // namespace fettle::bench
