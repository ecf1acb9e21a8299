// What a reload leaves alone, and what it reports: code that asks what is there already, classes
// that are gone, a game that goes back to before a reload.

#include "reloaded_game.h"

namespace second_reload_test {

using reloaded_game::Game;
using stage::Value;

TEST_CASE("code that asks whether something is there already goes its first way in a reload") {
    const std::string ways = GENERATE(
        "if not world:has('ball') then world.ball = Body { number = 5 } end",
        "if not pcall(function() return world.ball end) then world.ball = Body { number = 5 } end",
        "world.ball = world:has('ball') and world.ball or Body { number = 5 }",
        "if #world:find(Body) < 1 then world.ball = Body { number = 5 } end",
        "if #world:children() < 1 then world.ball = Body { number = 5 } end",
        "local function once(name, make) if not world:has(name) then world[name] = make() end end "
        "once('ball', function() return Body { number = 5 } end)",
        "while #world:all(Body) < 3 do world:add(Body {}, 'x' .. #world:all(Body)) end "
        "world.ball = Body { number = 5 }");
    const std::string score = " if not game:has('score') then game.score = 7 end";
    INFO(ways);
    Game game(ways + score);
    game.run("kept = world.ball world.ball.number = 50 game.score = 70 made = game:add(Object {})");
    for (int i = 0; i < 4; ++i) {
        CHECK(game.change(ways + score + " -- " + std::to_string(i)).empty());
        CHECK(game.prints("print(kept == world.ball, kept:alive(), made:alive())") ==
              "true\ttrue\ttrue");
        CHECK(game.number("world.ball.number") == 50);
        CHECK(game.number("score") == 70);
    }
    CHECK(game.change("").empty());
    CHECK(game.prints("print(kept:alive(), game:has('score'), made:alive())") ==
          "false\tfalse\ttrue");
}

TEST_CASE("a reload reports a class that the files do not define any more, once") {
    Game game("Coin = class('Coin', Object) {} world.a = Object {}");
    game.run("world:add(Coin {}) world:add(Coin {})");
    const auto notes = [&](const std::string& text) {
        game.write("main.lua", text);
        return game.runtime->reload({"main.lua"}).notes;
    };
    const std::vector<std::string> reported = notes("Gem = class('Gem', Object) {}");
    REQUIRE(reported.size() == 1);
    CHECK_THAT(reported[0], contains("class Coin, which was at main.lua:1, is no longer defined; "
                                     "2 instances of it are left"));
    CHECK(notes("Gem = class('Gem', Object) {} -- again").empty());
}

TEST_CASE("an integer that becomes a number in the file counts as the same value") {
    const auto code = [](const std::string& level) {
        return "Tower = class('Tower', Object) { level = " + level +
               " } world.one = Tower { level = 2 } world.two = Tower {}";
    };
    Game game(code("1"));
    game.run("world.one.level = 9 world.two.level = 9");
    CHECK(game.change(code("1.0")).empty());
    CHECK(game.get("world.one.level") == Value(9.0));
    CHECK(game.get("world.two.level") == Value(9.0));
}

TEST_CASE("a note says that the game has gone back to before a reload, once") {
    Game game("world.a = Object { size = 1 }");
    std::vector<std::string> notes;
    game.runtime->on_note([&](std::string_view note) { notes.emplace_back(note); });
    game.step(5);
    const auto early = game.tree->snapshot();
    game.step(5);
    CHECK(game.change("world.a = Object { size = 2 }").empty());
    game.step(1);
    CHECK(notes.empty());
    for (int i = 0; i < 3; ++i) {
        game.tree->restore(early);
        game.tree->barrier();
        game.step(1);
        REQUIRE(notes.size() == 1);
        CHECK_THAT(notes[0], contains("restart() begins with the new ones"));
    }
    game.step(10);
    const auto late = game.tree->snapshot();
    CHECK(game.change("world.a = Object { size = 2 } -- only a comment").empty());
    game.step(5);
    game.tree->restore(late);
    game.tree->barrier();
    game.step(1);
    CHECK(notes.size() == 1);
}

}  // namespace second_reload_test
