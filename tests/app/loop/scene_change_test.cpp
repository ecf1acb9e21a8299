// go_to_scene.

#include <catch.h>

#include <fettle/property/snapshot.h>

#include "game.h"

namespace scene_change_test {

using namespace fettle::app;
using fettle::property::Value;

TEST_CASE("a scene is replaced at a barrier and its timers and watchers end") {
    Game game(R"(
        class("First", Object) { }
        function First:enter(args)
            print("first", args.n)
            self:every(0, function() print("own") end)
            every(0, function() print("made") end)
            watch("view.height", function() print("watched") end)
        end
        function First:leave() print("left", game.scene == self) end
        class("Second", Object) { }
        function enter(args) print("enter", args) end
        function leave() print("leave") end
        every(0, function() print("game") end)
        go_to_scene("First", { args = { n = 3 } })
        print(game:has("scene")))");
    CHECK(game.errors.empty());
    CHECK(game.new_output() == "false");
    game.loop.turn();
    CHECK(game.new_output() == "first\t3 game own made");
    game.set("view.height", Value(10.0));
    game.loop.turn();
    CHECK(game.new_output() == "watched game own made");
    game.runtime.run("go_to_scene('Second', { args = 7 })", "test");
    game.loop.turn();
    CHECK(game.new_output() == "left\ttrue enter\t7 game");
    game.set("view.height", Value(11.0));
    game.loop.turn();
    CHECK(game.new_output() == "game");
    game.runtime.run("go_to_scene('Second')", "test");
    game.loop.turn();
    CHECK(game.new_output() == "leave enter\tnil game");
    CHECK(game.errors.empty());
}

TEST_CASE("a transition replaces the scene in its middle in real time") {
    Game game(R"(class("A", Object) { }  class("B", Object) { }
        function B:enter() print("b") end
        go_to_scene("A"))");
    game.loop.turn();
    game.runtime.run("time.paused = true  go_to_scene('B', { transition = 'wipe', seconds = 1 })",
                     "test");
    for (int i = 0; i < 20; ++i) game.loop.turn();
    CHECK(game.new_output().empty());
    CHECK(game.get("transition.progress").number() == Approx(20.0 / 60));
    // Called again, the new scene is the target.
    game.runtime.run("go_to_scene('A', { transition = 'fade', seconds = 1 })", "test");
    game.runtime.run("go_to_scene('B', { transition = 'fade', seconds = 1 })", "test");
    for (int i = 0; i < 11; ++i) game.loop.turn();
    CHECK(game.new_output() == "b");
    for (int i = 0; i < 31; ++i) game.loop.turn();
    CHECK_FALSE(bool(game.tree.child(game.tree.root(), "transition")));
    CHECK(game.errors.empty());
}

TEST_CASE("wrong calls of go to scene are errors with the nearest name") {
    Game game(R"(class("Level", Object) { }
        local function try(...) local _, why = pcall(go_to_scene, ...) print(why) end
        try("Levle") try("Level", { transtion = "fade" }) try("Level", { transition = "fad" })
        try("Level", { seconds = -1 }) try("Level", { args = { f = print } }) try("Level", 3) try()
        try("Object") try("../x"))");
    const std::string output = game.new_output();
    for (const char* part : {"did you mean \"Level\"", "did you mean \"transition\"",
                             "did you mean \"fade\"", "expected 0 to 3600", "args.f"})
        CHECK(output.find(part) != std::string::npos);
    game.loop.turn();
    CHECK_FALSE(bool(game.tree.child(game.tree.root(), "scene")));
}

TEST_CASE("a snapshot brings the old scene back") {
    Game game(R"(class("A", Object) { n = 0 }  class("B", Object) { }
        function A:step() self.n = self.n + 1 end
        function A:enter() self:every(0, function() print("a") end) end
        go_to_scene("A"))");
    for (int i = 0; i < 5; ++i) game.loop.turn();
    const auto then = game.tree.snapshot();
    const Value n = game.get("game.scene.n");
    game.runtime.run("go_to_scene('B', { transition = 'fade', seconds = 0.1 })", "test");
    for (int i = 0; i < 20; ++i) game.loop.turn();
    CHECK(game.tree.class_of(game.tree.child(game.tree.root(), "scene")).name() == "B");
    game.tree.restore(then);
    game.new_output();
    CHECK(game.get("game.scene.n") == n);
    game.loop.turn();
    CHECK(game.new_output() == "a");
    CHECK(game.get("game.scene.n").integer() == n.integer() + 1);
}

TEST_CASE("going back in time before a transition and into one") {
    Game game(R"(class("A", Object) { } class("B", Object) { }
        go_to_scene("A"))");
    game.loop.turn();
    const auto before = game.tree.snapshot();
    game.runtime.run("go_to_scene('B', { transition = 'fade', seconds = 0.2 })", "test");
    for (int i = 0; i < 3; ++i) game.loop.turn();
    const auto within = game.tree.snapshot();
    const Value progress = game.get("transition.progress");
    game.tree.restore(before);
    CHECK_FALSE(bool(game.tree.child(game.tree.root(), "transition")));
    game.runtime.run("game.other = Object { }", "test");
    game.tree.restore(within);
    CHECK(game.get("transition.progress") == progress);
    for (int i = 0; i < 20; ++i) game.loop.turn();
    CHECK(game.tree.class_of(game.tree.child(game.tree.root(), "scene")).name() == "B");
    game.tree.restore(before);
    CHECK(game.tree.class_of(game.tree.child(game.tree.root(), "scene")).name() == "A");
    CHECK(game.errors.empty());
}

TEST_CASE("timers and watchers made in enter belong to their scene also after going back in time") {
    Game game(R"(
        class("A", Object) { }  class("B", Object) { }
        function A:enter()
            every(0, function() print("a") end)
            coroutine.wrap(function() while true do wait(0) print("waited") end end)()
        end
        function B:enter()
            every(0, function() print("b") end)
            watch("view.height", function() print("watched") end)
        end
        go_to_scene("A"))");
    for (int i = 0; i < 3; ++i) game.loop.turn();
    const auto then = game.tree.snapshot();
    game.runtime.run("go_to_scene('B')", "test");
    for (int i = 0; i < 3; ++i) game.loop.turn();
    game.tree.restore(then);
    game.new_output();
    game.set("view.height", Value(10.0));
    game.loop.turn();
    // Functions of timers come back, coroutines that ended do not, and the scene B is not there.
    CHECK(game.new_output() == "a");
    game.runtime.run("go_to_scene('B') every(0, function() print('game') end)", "test");
    game.loop.turn();
    game.new_output();
    game.loop.turn();
    CHECK(game.new_output() == "game b");
    CHECK(game.errors.empty());
}

TEST_CASE("callbacks of scenes may go on to another scene or delete theirs") {
    Game game(R"(class("A", Object) { }  class("B", Object) { }  class("C", Object) { }
        function A:enter() go_to_scene("B") end
        function A:leave() self:delete() end
        function B:enter() error("wrong") end
        function C:enter() self:delete() print("c") end
        go_to_scene("A"))");
    game.loop.turn();
    game.loop.turn();
    REQUIRE(game.errors.size() == 1);
    CHECK(game.errors[0].message.find("wrong") != std::string::npos);
    game.loop.resume();
    game.runtime.run("go_to_scene('C')", "test");
    game.loop.turn();
    CHECK(game.new_output() == "c");
    CHECK_FALSE(bool(game.tree.child(game.tree.root(), "scene")));
}

}  // namespace scene_change_test
