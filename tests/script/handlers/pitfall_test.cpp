// Mistakes that users of other engines make are reported once.

#include <fettle/property/snapshot.h>

#include <fstream>

#include "stage.h"
#include "temporary_folder.h"

namespace pitfall_test {

using stage::joined;
using stage::Stage;
using stage::Vec2;

namespace {

struct Game : Stage {
    Game() {
        runtime->on_note([this](std::string_view note) { notes.emplace_back(note); });
    }
    std::vector<std::string> notes;
};

}  // namespace

TEST_CASE(
    "a handler that uses an instance removed by a restore causes a note and the game goes on") {
    Game s;
    s.run(
        "function step() if mine then print(mine.mass) end print('step') end mine = nil "
        "every(0, function() print('timer', mine and mine.mass) end)");
    s.step();
    const auto taken = s.tree->snapshot();
    s.run("world.ball = Body {} mine = world.ball");
    s.step();
    s.tree->restore(taken);
    s.tree->barrier();
    s.printed.clear();
    s.errors.clear();
    s.step(3);
    CHECK(s.errors.empty());
    CHECK(s.printed.empty());      // both handlers end where they touch it
    REQUIRE(s.notes.size() == 1);  // both are in one line
    CHECK_THAT(s.notes[0], contains("by restore, when the game went back in time") &&
                               contains("the game goes on. Ask :alive() first"));
    CHECK(s.prints("print(mine:alive())") == "false");
    s.run("mine = nil");
    s.step();
    CHECK(s.errors.empty());
    CHECK(s.printed[1] == "timer\tnil");
}

TEST_CASE("an error that only quotes an error about a removed instance stays an error") {
    Game s;
    const auto taken = s.tree->snapshot();
    s.run("world.ball = Body {} mine = world.ball");
    s.step();
    s.tree->restore(taken);
    s.tree->barrier();
    s.run(
        "function step() local _, why = pcall(function() return mine.mass end) "
        "error('expected 3, got \"' .. why .. '\"') end");
    s.errors.clear();
    s.step();
    CHECK(s.errors.size() == 1);
    CHECK(s.notes.empty());
}

TEST_CASE("a chunk that uses an instance removed by a restore is an error") {
    Game s;
    const auto taken = s.tree->snapshot();
    s.run("world.ball = Body {} mine = world.ball");
    s.tree->restore(taken);
    CHECK_THAT(s.fails("print(mine.mass)"), contains("by restore"));
}

TEST_CASE("a handler that uses an instance deleted by a script is an error") {
    Game s;
    s.run("world.ball = Body {} mine = world.ball function step() print(mine.mass) end");
    s.step();
    s.run("mine:delete()");
    s.step();
    CHECK(s.errors.size() == 1);
    CHECK(s.notes.empty());
}

TEST_CASE("the name of a deleted instance is not taken for a method") {
    Game s;
    s.run("world.ball = Body {} world.ball:delete()");
    const std::string message = s.fails("print(world.ball)");
    CHECK_THAT(message, contains("world.ball: no such name"));
    CHECK(message.find("did you mean") == std::string::npos);
}

TEST_CASE("a coroutine of a timer that yields gets a note once") {
    Game s;
    s.run(
        "after(0, function() wait(0) end) for _ = 1, 2 do game:run(function()\n"
        "coroutine.yield() end) end");
    s.step();
    REQUIRE(s.notes.size() == 1);
    CHECK(s.notes[0] ==
          "main.lua:2: after coroutine.yield() only coroutine.resume goes on; wait(0) waits for "
          "the next step");
}

TEST_CASE("a coroutine that waits is ended by coroutine.close and does not go on") {
    Game s;
    s.run(
        "done = 0 "
        "local long = game:run(function() wait(0.05) done = done + 1 end) "
        "local real = game:run(function() after(0, print, { pauses = false }) wait(0.05) end) "
        "other = game:run(function() wait(0.05) done = done + 10 end) "
        "assert(coroutine.close(long) and coroutine.status(long) == 'dead') "
        "assert(coroutine.close(real))");
    for (int i = 0; i < 10; ++i) s.step();
    CHECK(s.prints("print(done, coroutine.status(other))") == "10\tdead");
    CHECK(s.errors.empty());
}

TEST_CASE("a vector in a variable is connected and a note says so once") {
    Game s;
    s.run("world.ball = Body {} world.ball.position.x = 3 world.ball.position.y = 4");
    CHECK(s.notes.empty());
    s.run("local v = world.ball.position\nv.x = 7 v.y = 8");
    REQUIRE(s.notes.size() == 1);
    CHECK(s.notes[0] ==
          "main.lua:2: v was read from world.ball.position and stays connected with it, so v.x = "
          "... writes world.ball.position; vec(v) is a copy");
    CHECK(s.get("world.ball.position").vec2() == Vec2(7, 8));
    s.run("local w = vec(world.ball.position) w.x = 1 local u = world.ball.position u.x = 5");
    CHECK(s.notes.size() == 1);
    CHECK(s.get("world.ball.position").vec2() == Vec2(5, 8));
}

TEST_CASE("a vector in a variable of an outer function gets a note too") {
    Game s;
    s.run("world.ball = Body {} local v = world.ball.position local function f() v.x = 1 end f()");
    REQUIRE(s.notes.size() == 1);
    CHECK_THAT(s.notes[0], contains("v was read from world.ball.position"));
}

namespace {

/// The notes about a game with this `main.lua`, joined with '|'.
std::string notes_about(const std::string& game) {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << game;
    Game s;
    fettle::property::ClassDescriptor keys{.name = "Keys"};
    for (const char* key : {"space", "escape", "a"})
        keys.properties.push_back({.name = key, .type = fettle::property::Type::boolean});
    s.tree->define(std::move(keys));
    fettle::property::ClassDescriptor clock{.name = "Clock"};
    clock.creatable = false;
    clock.properties = {{.name = "scale", .type = fettle::property::Type::number}};
    fettle::property::ClassDescriptor actions{.name = "Actions"};
    actions.creatable = false;
    s.tree->create(s.tree->define(std::move(actions)), s.tree->root(), "actions");
    s.tree->create(s.tree->define(std::move(clock)), s.tree->root(), "time");
    INFO(game);
    REQUIRE(s.runtime->load(folder.path));
    return stage::joined(s.notes);
}

}  // namespace

TEST_CASE("a note names the instances that a game made and does not use") {
    CHECK(notes_about("local kept = Body {} function start() world.a = kept end") == "");
    CHECK(notes_about("world.a = Body {} kept = Body {}") == "");
    CHECK_THAT(notes_about("Body {}"), contains("a Body was made, and added to nothing"));
    CHECK_THAT(notes_about("local a, b = Body {}, Body {}"), contains("a Body and 1 more were"));
    CHECK_THAT(notes_about("kept = Body {}"), contains("a Body was made and has no place"));
    CHECK_THAT(notes_about("local kept = Body {} function step() kept.mass = 2 end"),
               contains("a Body was made and has no place"));

    CHECK_THAT(notes_about("state = 'menu'"),
               contains("state is a text now, and was a function of Fettle: state("));
    CHECK(notes_about("function state() end") == "");
    CHECK(notes_about("state('throws', 0)\nthrow = 5") ==
          "main.lua:2: throw is a new variable and not a state (did you mean \"throws\"?)");
    CHECK(notes_about("state('throws', 0) throw = 'a ball' throws = 2 other = 3") == "");

    CHECK(
        notes_about("draw = 5") ==
        "draw is no function, so that the callback draw does nothing: write function draw(...), or "
        "give the variable another name");
    CHECK(notes_about("step = function() end draw = setmetatable({}, {__call = print})") == "");

    CHECK(notes_about("\nclass('Foe', Body)") ==
          "main.lua:2: no class Foe, because its class has no table (write class(\"Foe\", "
          "Body) { })");
    CHECK(notes_about("class('Foe', Body) { }") == "");

    CHECK(notes_about("-- start\nlocal function start() end") ==
          "main.lua:2: nothing calls start, because it is local: write function start(...)");
    CHECK(notes_about("local function step(n) end\nstep(3)") == "");
    for (const char* const name : {"Update", "on_update", "_process"})
        CHECK(notes_about("function " + std::string(name) + "() end") ==
              "main.lua:1: nothing calls " + std::string(name) + " (did you mean update?)");
    CHECK(notes_about("function FixedUpdate() end") ==
          "main.lua:1: nothing calls FixedUpdate (did you mean step?)");
    CHECK(notes_about("class('Foe', Body) { } function Foe:update() end") ==
          "main.lua:1: nothing calls Foe:update (did you mean step?)");

    CHECK(notes_about("function key_pressed(k)\n  if k == 'Space' then end\nend") ==
          "main.lua:2: no key is called \"Space\" (did you mean \"space\"?)");
    CHECK(notes_about("function key_released(key)\n  if key == \"esc\" then end\nend") ==
          "main.lua:2: no key is called \"esc\" (did you mean \"escape\"?)");
    CHECK(notes_about("function key_pressed(key)\n  if key == 'space' or key == 'pause_or_so' "
                      "then end\nend\nfunction other(key) return key == 'Space' end") == "");

    CHECK_THAT(notes_about("time.speed = 2"), contains("Clock has no property \"speed\", so it was "
                                                       "added to this one and changes nothing"));
    CHECK(notes_about("actions.jump = 2 game.speed = 2 world.a = Body {} world.a.lives = 2") == "");

    CHECK_THAT(notes_about("watch('world.*.velocitty', print)"),
               contains("watch: nothing matches \"world.*.velocitty\" now: no class has a property "
                        "\"velocitty\" (did you mean \"velocity\"?)"));
    CHECK_THAT(notes_about("watch('world.*.mss', print)"), contains("(did you mean \"mass\"?)"));
    CHECK(notes_about("\nwatch('wrold.*.mass', print)") ==
          "main.lua:2: watch: nothing matches \"wrold.*.mass\" now: game has no child \"wrold\" "
          "(did you mean \"world\"?)");
    CHECK_THAT(notes_about("world.enemies = Object {} watch('world.enemys.**', print)"),
               contains("world has no child \"enemys\" (did you mean \"enemies\"?)"));
    CHECK(notes_about("watch('world.*.position', print) watch('world.*.*', print)") == "");
    CHECK(notes_about("world.wheel_1 = Body {} watch('world.wheel_2.*', print) "
                      "watch('enemies.*.mass', print) watch('world.*.hp', print)") == "");
}

}  // namespace pitfall_test
