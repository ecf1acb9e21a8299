#include <fettle/property/error.h>

#include "stage.h"

namespace lifetime_test {

// Runtimes that are destroyed before, after and during the use of their trees and callbacks.

using namespace stage;
using fettle::property::Error;
using fettle::script::Options;
using fettle::script::Runtime;

namespace {

std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("a tree has one runtime at a time and can get another one afterwards") {
    Stage stage;
    const Handle ball = stage.tree->create(stage.tree->class_named("Body"), stage.world, "ball");
    stage.run(
        "world.ball.friction = 0 world.ball.mass = formula(function() return world.ball.friction + "
        "2 end)");
    CHECK(stage.tree->get(ball, "mass") == Value(2.0));
    CHECK(message_of([&] { Runtime second(*stage.tree, {}); }) ==
          "the tree has a runtime already: it has one at a time");
    stage.run("world.ball.friction = 0.25");  // the first still works
    stage.runtime = nullptr;
    stage.tree->set(ball, "friction", 1);
    CHECK(stage.tree->problem(ball, stage.tree->property(ball, "mass"))
              .find("its script has ended") != std::string::npos);
    Runtime second(*stage.tree, {});
    CHECK(second.run("world.ball.mass = 3", "main.lua"));
    CHECK(stage.tree->get(ball, "mass") == Value(3.0));
}

TEST_CASE("a runtime that outlives its tree reports this and ends without harm") {
    auto tree = std::make_unique<Tree>();
    Runtime runtime(*tree, {});
    runtime.on_print([](std::string_view) {});
    REQUIRE(runtime.run(
        "kept = snapshot() node = Object {} game.node = node\n"
        "node.speed = 1 node:watch('speed', print) game.f = formula(function() return 1 end)\n"
        "every(1, print) Ball = class('Ball', Object) { lives = 3 }\n"
        "function Ball:step() end game.ball = Ball {}",
        "main.lua"));
    tree.reset();
    const std::vector<std::function<void()>> calls = {
        [&] { runtime.run("print(1)", "main.lua"); },
        [&] { runtime.call("update", {0.1}); },
        [&] { runtime.step(1, 1); },
        [&] { runtime.evaluate("game"); },
        [&] { runtime.complete("gam", 3); },
        [&] { (void)runtime.defines("update"); },
        [&] { runtime.load("nowhere.lua"); },
    };
    for (const auto& call : calls)
        CHECK_THAT(message_of(call), contains("the tree of this runtime was destroyed"));
    CHECK(runtime.memory() > 0);
    CHECK_FALSE(runtime.quit_status());
}

TEST_CASE("a function called by a runtime may destroy the runtime") {
    for (const std::string way :
         {"print", "error", "command", "print in a handler", "print in a timer", "method",
          "print in a class", "print in a formula"}) {
        INFO(way);
        Stage stage;
        int calls = 0;
        const auto end = [&] {
            ++calls;
            stage.runtime.reset();
        };
        stage.runtime->on_print([&](std::string_view) { end(); });
        stage.runtime->on_error([&](const ScriptError&) { end(); });
        Runtime& runtime = *stage.runtime;
        if (way == "print") {
            CHECK(
                runtime.run("print(1) local t = {} for i = 1, 1000 do t[i] = {} end", "main.lua"));
        } else if (way == "error") {
            CHECK_FALSE(runtime.run("error('no')", "main.lua"));
        } else if (way == "command") {
            runtime.on_command([&](std::string_view) { end(); });
            CHECK(runtime.evaluate("1 + 1").lines.empty());
        } else if (way == "print in a handler") {
            runtime.run("game:watch('speed', function() print(1) end)", "main.lua");
            stage.tree->set_or_add(stage.tree->root(), "speed", 3);
            stage.tree->barrier();
        } else if (way == "print in a timer") {
            runtime.run("every(0, function() print(1) end) every(0, function() print(2) end)",
                        "main.lua");
            runtime.step(1, 1);
        } else if (way == "print in a class") {
            runtime.run(
                "Ball = class('Ball', Object) {}\n"
                "function Ball:step() print(1) end function Ball:speed() end\n"
                "for i = 1, 3 do game['ball' .. i] = Ball {} end",
                "main.lua");
            runtime.step(1, 1);
        } else if (way == "print in a formula") {
            runtime.run("game.f = formula(function() print(1) return 5 end)", "main.lua");
            (void)message_of([&] { (void)stage.tree->get(stage.tree->root(), "f"); });
        } else {
            static std::function<void()> to_call;
            to_call = end;
            stage.tree->define(
                {.name = "Bomb",
                 .methods = {{.name = "explode",
                              .call = [](void*, Tree&, Handle, fettle::property::Row,
                                         std::span<const Value>) -> fettle::property::Result {
                                  to_call();
                                  return Value(1);
                              }}}});
            CHECK(runtime.run("game.bomb = Bomb {} local n = game.bomb:explode() game.n = n + 1",
                              "main.lua"));
            CHECK(stage.tree->get(stage.tree->root(), "n") == Value(2));
        }
        CHECK(calls == 1);
        CHECK(stage.runtime == nullptr);
        stage.tree->barrier();
        Runtime next(*stage.tree, {});
        CHECK(next.run("local n = 1", "main.lua"));
    }
}

TEST_CASE("an error handler whose own scripts fail does not run without end") {
    Stage stage;
    int reported = 0;
    stage.runtime->on_error([&](const ScriptError&) {
        ++reported;
        stage.runtime->run("error('and again')", "main.lua");
    });
    CHECK_FALSE(stage.runtime->run("error('no')", "main.lua"));
    CHECK(reported == 16);
    CHECK_FALSE(stage.runtime->run("error('no')", "main.lua"));
    CHECK(reported == 32);
    CHECK(stage.runtime->run("local n = 1", "main.lua"));
}

TEST_CASE("a method that throws an unknown type is an error of the script") {
    Stage stage;
    std::string said;
    stage.runtime->on_print([&](std::string_view text) { said += text; });
    stage.tree->define(
        {.name = "Bomb",
         .methods = {
             {.name = "explode",
              .call = [](void*, Tree&, Handle, fettle::property::Row,
                         std::span<const Value>) -> fettle::property::Result { throw 5; }}}});
    CHECK(stage.runtime->run("game.bomb = Bomb {} print(pcall(function() game.bomb:explode() end))",
                             "main.lua"));
    CHECK_THAT(said, contains("bomb:explode(): an exception of no known type"));
}

TEST_CASE("a callback of a runtime may replace itself") {
    Stage stage;
    std::string said;
    stage.runtime->on_print([&, kept = std::string(100, 'a')](std::string_view) {
        stage.runtime->on_print([&](std::string_view text) { said += text; });
        said += kept.substr(0, 3);
    });
    stage.runtime->on_error([&, kept = std::string(100, 'e')](const ScriptError&) {
        stage.runtime->on_error([&](const ScriptError&) { said += "later"; });
        said += kept.substr(0, 3);
    });
    CHECK(stage.runtime->run("print('first') print('second')", "main.lua"));
    CHECK_FALSE(stage.runtime->run("error('no')", "main.lua"));
    CHECK_FALSE(stage.runtime->run("error('no')", "main.lua"));
    CHECK(said == "aaasecondeeelater");
}

TEST_CASE("loading a game while a script of the runtime runs is refused") {
    Stage stage;
    std::string said;
    stage.runtime->on_print(
        [&](std::string_view) { said = message_of([&] { stage.runtime->load("main.lua"); }); });
    CHECK(stage.runtime->run("print(1)", "main.lua"));
    CHECK_THAT(said, contains("no game can be loaded while a script"));
}

TEST_CASE("a runtime with too little memory is refused and the tree is unchanged") {
    Tree tree;
    int refused = 0;
    for (const std::size_t limit :
         {0u, 1'000u, 5'000u, 10'000u, 20'000u, 50'000u, 100'000u, 150'000u}) {
        INFO(limit);
        Options options;
        options.memory_limit = limit;
        const std::string message = message_of([&] { Runtime runtime(tree, options); });
        refused += message != "no error";
        CHECK(tree.parts().empty());
        CHECK(tree.watcher_count() == 0);
    }
    CHECK(refused > 3);
    Runtime runtime(tree, {});
    CHECK(runtime.run("game.n = 1", "main.lua"));
}

TEST_CASE("a runtime can end at a barrier before a snapshot requested by its script is taken") {
    Tree tree;
    auto runtime = std::make_unique<Runtime>(tree, Options{});
    REQUIRE(runtime->run("S = snapshot() restore(S)", "main.lua"));
    runtime = nullptr;
    tree.barrier();
    CHECK(Runtime(tree, {}).run("print(1)", "main.lua"));
}

}  // namespace lifetime_test
