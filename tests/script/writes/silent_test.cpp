// Code that works and does less than it seems to: a note says so.

#include <fstream>

#include <fettle/property/painter.h>

#include "stage.h"
#include "temporary_folder.h"

namespace silent_test {

using stage::Stage;
using stage::Value;

namespace {

struct NoPainter : fettle::property::Painter {
    void circle(const stage::Vec2&, double, const fettle::property::Paint&) override {}
    void ellipse(const stage::Vec2&, const stage::Vec2&, double,
                 const fettle::property::Paint&) override {}
    void polygon(std::span<const stage::Vec2>, double, const fettle::property::Paint&) override {}
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

/// A game of several files, and its notes.
struct Game : Stage {
    TemporaryFolder folder;
    std::vector<std::string> notes;

    Game() {
        runtime->on_note([this](std::string_view note) { notes.emplace_back(note); });
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder.path / name) << text;
    }
    bool load(const std::string& text) {
        write("main.lua", text);
        return runtime->load(folder.path);
    }
    fettle::script::Reloaded change(const std::string& text) {
        write("main.lua", text);
        return runtime->reload({"main.lua"});
    }
    std::string children(const std::string& path) {
        return prints("for _, each in ipairs(" + path + ":children()) do print(each.name) end");
    }
};

}  // namespace

TEST_CASE("a function that draws and changes the game is noted once for a property") {
    Game game;
    REQUIRE(
        game.load("Ball = class('Ball', Body) { spin = 0.0 }\n"
                  "world.a = Ball {} world.b = Ball {}\n"
                  "game.view = Object { height = 20 }\n"
                  "function Ball:draw(pen) self.spin = self.spin + 0.1 end\n"
                  "function draw(pen)\n"
                  "  world.a.position = vec(1, 1)\n"
                  "  world.a.position.x = 2\n"
                  "  view.height = 30\n"
                  "  local hidden = Body {} hidden.mass = 3\n"
                  "end\n"));
    NoPainter painter;
    game.run("world.a.position = vec(0, 0)");
    CHECK(game.notes.empty());
    for (int i = 0; i < 3; ++i) CHECK(game.runtime->draw(painter));
    REQUIRE(game.notes.size() == 2);
    CHECK_THAT(game.notes[0], stage::starts_with("main.lua:4: a function that draws changes "
                                                 "world.a.spin: "));
    CHECK_THAT(game.notes[1], stage::starts_with("main.lua:6: a function that draws changes "
                                                 "world.a.position: "));
    game.run("world.a.position = vec(0, 0)");
    CHECK(game.notes.size() == 2);
}

TEST_CASE("a function that draws and adds or deletes something is noted") {
    Game game;
    REQUIRE(
        game.load("world.a = Body {}\n"
                  "function draw(pen)\n"
                  "  world:add(Object {}, 'made')\n"
                  "  world.made = nil\n"
                  "end\n"));
    NoPainter painter;
    CHECK(game.runtime->draw(painter));
    REQUIRE(game.notes.size() == 2);
    CHECK_THAT(game.notes[0], contains("main.lua:3: a function that draws changes world.made"));
    CHECK_THAT(game.notes[1], contains("main.lua:4: a function that draws changes world.made"));
}

TEST_CASE("a function that draws and changes a variable of the game is noted") {
    Game game;
    REQUIRE(game.load("state('pictures', 0)\nfunction draw(pen) pictures = pictures + 1 end"));
    NoPainter painter;
    CHECK(game.runtime->draw(painter));
    REQUIRE(game.notes.size() == 1);
    CHECK_THAT(game.notes[0],
               stage::starts_with("main.lua:2: a function that draws changes game.pictures: "));
}

TEST_CASE("a change after snapshot in the same function is noted once") {
    Game game;
    REQUIRE(
        game.load("state('moves', 0)\n"
                  "world.a = Body {}\n"
                  "local before\n"
                  "function take() before = snapshot() end\n"
                  "function play() before = snapshot() moves = moves + 1 end\n"
                  "function push() before = snapshot()\nworld.a.mass = 2 end\n"
                  "function show() before = snapshot() view.height = 2 Body {}.mass = 2 end\n"
                  "function turn() game:run(function() snapshot() wait(0) moves = 3 end) end\n"
                  "game.view = Object { height = 20 }\n"));
    for (const char* const call : {"moves = 1 take()", "moves = 2", "show()", "turn()"}) {
        game.run(call);
        game.step(2);
        CAPTURE(call);
        CHECK(game.notes.empty());
    }
    CHECK(game.prints("print(moves)") == "3");
    game.run("push()");
    REQUIRE(game.notes.size() == 1);
    CHECK_THAT(game.notes[0],
               stage::starts_with("main.lua:7: world.a.mass changes after snapshot(), "
                                  "which holds the game as it is when this "));
    game.run("play()");
    CHECK(game.notes.size() == 1);
}

TEST_CASE("a change after snapshot is noted for a variable of the game, too") {
    Game game;
    REQUIRE(game.load("state('moves', 0)\nfunction play() snapshot() moves = moves + 1 end"));
    game.run("play()");
    REQUIRE(game.notes.size() == 1);
    CHECK_THAT(game.notes[0],
               stage::starts_with("main.lua:2: game.moves changes after snapshot()"));
}

TEST_CASE("instances that a reload drops with the old code are not noted") {
    Game game;
    REQUIRE(game.load(
        "local kept = Body { mass = 2 } function use() return kept end world.a = Body {}"));
    REQUIRE(
        game.change(
                "local kept = Body { mass = 3 } function use() return kept end world.a = Body {}")
            .done);
    CHECK(game.notes.empty());
    REQUIRE(game.change("local kept = Body { mass = 3 } world.a = Body {} Body {}").done);
    REQUIRE(game.notes.size() == 1);
    CHECK_THAT(game.notes[0], contains("made, and added to nothing"));
}

TEST_CASE("a class that two files of a game define is noted with both places") {
    Game game;
    game.write("other.lua", "\nFoe = class('Foe', Body) { lives = 3 }");
    REQUIRE(game.load("Foe = class('Foe', Body) { lives = 3 }\nrequire 'other'"));
    REQUIRE(game.notes.size() == 1);
    CHECK_THAT(game.notes[0], stage::starts_with("other.lua:2: class Foe is defined already, at "
                                                 "main.lua:1: "));
    game.notes.clear();
    game.console("Foe = class('Foe', Body) { lives = 3 }");
    CHECK(game.notes.empty());
    CHECK(game.change("Foe = class('Foe', Body) { lives = 4 }").done);
    CHECK(game.notes.empty());
}

TEST_CASE("another base of a class names the first one, and a reload the way out") {
    Game game;
    CHECK_FALSE(game.load("class('Foe', Body) {}\n\nclass('Foe', Object) {}"));
    REQUIRE(game.errors.size() == 1);
    CHECK_THAT(game.errors[0].message,
               contains("Foe: exists already with another base, Body, from main.lua:1"));
    Game again;
    REQUIRE(again.load("class('Enemy', Body) {}"));
    const auto result = again.change("class('Enemy', Object) {}");
    REQUIRE(result.error);
    CHECK_THAT(result.error->message, contains("restart() in the console begins the game again"));
}

TEST_CASE("a coroutine can be stopped as a timer can") {
    Stage s;
    s.run(
        "ticks = 0 world.ball = Body {} "
        "walk = world.ball:run(function() while true do wait(0.1) ticks = ticks + 1 end end)");
    s.step(20);
    CHECK(s.prints("print(ticks, walk:active())") == "3\ttrue");
    s.run("walk:stop()");
    s.step(20);
    CHECK(s.prints("print(ticks, walk:active())") == "3\tfalse");
    s.run("walk:stop()");
    CHECK_THAT(s.fails("walk:pause()"), contains("a coroutine has no pause"));
    CHECK_THAT(s.fails("walk.stop()"), contains("stop: needs a coroutine"));
    CHECK_THAT(s.fails("coroutine.wrap(function() coroutine.running():stop() end)()"),
               contains("cannot close a running coroutine"));
    CHECK(s.prints("print(getmetatable(walk), tostring(walk))") == "thread\tthread");
}

TEST_CASE("a reload that removes a state notes the instances that are in it") {
    Game game;
    const std::string place = "world.a, world.b = Door {}, Door {}";
    REQUIRE(
        game.load("Door = class('Door', Body) { current_state = 'shut', states = { shut = {}, "
                  "open = {} } } " +
                  place));
    game.step(2);
    game.run("world.b:state('open')");
    const auto result = game.change(
        "Door = class('Door', Body) { current_state = 'shut', states = { shut = {} } } " + place);
    REQUIRE(result.done);
    REQUIRE(result.notes.size() == 1);
    CHECK_THAT(result.notes[0],
               contains("world.b is in the state \"open\", which Door has no more"));
}

TEST_CASE("a reload puts new children where they are in the file") {
    Game game;
    const auto menu = [](const std::string& inside) {
        return "game.menu = Object { " + inside + " }";
    };
    const auto button = [](const std::string& name) {
        return "Object { name = '" + name + "' }, ";
    };
    REQUIRE(game.load(menu(button("play") + button("quit"))));
    CHECK(game.change(menu(button("play") + button("help") + button("quit"))).done);
    CHECK(game.children("game.menu") == "play|help|quit");
    CHECK(
        game.change(menu(button("first") + button("play") + button("help") + button("quit"))).done);
    CHECK(game.children("game.menu") == "first|play|help|quit");
    game.run("game.menu:add(Object {}, 'made_by_the_game')");
    CHECK(game.change(menu(button("quit") + button("first") + button("play"))).done);
    CHECK(game.children("game.menu") == "quit|first|play|made_by_the_game");
    // Nothing moves if the order of the file is the same.
    game.run("game.menu.first:move(world)");
    CHECK(game.change(menu(button("quit") + button("first") + button("play"))).done);
    CHECK(game.children("game.menu") == "quit|play|made_by_the_game");
}

TEST_CASE("an instance at the top level of a file comes before those that stand behind it") {
    Game game;
    REQUIRE(game.load("world.floor = Body {} world.hero = Body {}"));
    CHECK(game.change("world.floor = Body {} world.wall = Body {} world.hero = Body {}").done);
    CHECK(game.children("world") == "floor|wall|hero");
}

TEST_CASE("a set names the way to a method or a property that only its instances have") {
    Stage s;
    s.run("Foe = class('Foe', Body) {} function Foe:hit() end world.a = Foe {}");
    CHECK_THAT(
        s.fails("world:find(Foe):hit()"),
        contains("a set of instances has no hit (write :each(function(one) one:hit(...) end) "
                 "for all of them)"));
    CHECK_THAT(s.fails("world:find(Foe):tween('mass', 2, 1)"), contains("one:tween(...)"));
    CHECK_THAT(s.fails("print(world:find(Foe).mass)"),
               contains("(write one.mass in a loop: for _, one in ipairs(set) do ... end)"));
    CHECK_THAT(s.fails("world:find(Foe):frobnicate()"),
               contains("has no frobnicate; it has add, delete, each and set, and ipairs"));
    CHECK_THAT(s.fails("world:find('World'):explode()"), contains("a set of instances has no"));
}

}  // namespace silent_test
