#include <catch.h>

#include <fettle/app/loop.h>
#include <limits>
#include <memory>
#include <vector>

#include "game.h"

namespace fettle::app {

namespace {

/// Prints a word for each phase.
constexpr std::string_view phases = R"(
    game.mark = Object {}
    game.mark.n = 0
    game.mark:watch("n", function(new) print("watcher" .. new) end)
    function update(dt) print("update"); game.mark.n = game.mark.n + 1 end
    function step(dt) print("step"); game.mark.n = game.mark.n + 10 end
    function key_pressed(key) print("key"); game.mark.n = game.mark.n + 100 end
)";

}  // namespace

TEST_CASE("a frame runs input then update then step with a barrier after each") {
    Game game(phases);
    game.loop.add({.name = "module", .step = [&](double) { game.printed.push_back("module"); }});
    game.tree.barrier();
    game.new_output();
    game.press("space");
    game.loop.frame(tick);
    CHECK(game.new_output() == "key watcher100 update watcher101 step watcher111 module");
    CHECK(game.errors.empty());
}

TEST_CASE("an event of a module reaches handlers at the barrier after its step") {
    Game game(R"(
        game.box = Object {}
        game.box.hits = 0
        game.box:watch("hits", function(new) print("hits " .. new) end)
        function update() print("update") end
    )");
    game.loop.add({.name = "module",
                   .step = [&](double) { game.printed.push_back("step"); },
                   .report = [&] { game.set("box.hits", game.get("box.hits").integer() + 1); }});
    game.tree.barrier();
    game.new_output();
    game.loop.frame(tick);
    CHECK(game.new_output() == "update step hits 1");
}

TEST_CASE("sixty frames of 1 s / 60 make sixty steps and one second") {
    Game game;
    for (int i = 0; i < 60; ++i) game.loop.frame(tick);
    CHECK(game.get("time.step").integer() == 60);
    CHECK(game.get("time.now").number() == 1.0);
    CHECK(game.tree.step() == 60);
}

TEST_CASE("time shorter than a step is kept for the next frame and shown by alpha") {
    Game game;
    game.loop.frame(0.25 * tick);
    CHECK(game.get("time.step").integer() == 0);
    CHECK(game.get("time.alpha").number() == Approx(0.25));
    game.loop.frame(tick);
    CHECK(game.get("time.step").integer() == 1);
    CHECK(game.get("time.alpha").number() == Approx(0.25));
}

TEST_CASE("a slow frame makes at most max_steps steps and counts the dropped ones") {
    Game game;
    game.set("time.max_steps", 3);
    game.loop.frame(10.5 * tick);
    CHECK(game.get("time.step").integer() == 3);
    CHECK(game.get("time.dropped_steps").integer() == 7);
    game.loop.frame(0.25 * tick);  // no time is left over
    CHECK(game.get("time.step").integer() == 3);
    game.loop.frame(0.5 * tick);
    CHECK(game.get("time.step").integer() == 4);
    CHECK(game.get("time.dropped_steps").integer() == 7);
}

TEST_CASE("update gets no more time than the steps of the frame") {
    Game game("function update(dt) print(dt < 0.1) end");
    game.loop.frame(3);
    CHECK(game.new_output() == "true");
}

TEST_CASE("scale makes time pass slower or faster") {
    Game game("function update(dt) game.last_dt = dt end");
    game.set("time.scale", 0.5);
    for (int i = 0; i < 60; ++i) game.loop.frame(tick);
    CHECK(game.get("time.step").integer() == 30);
    CHECK(game.get("last_dt").number() == Approx(0.5 * tick));
    game.set("time.scale", 2);
    for (int i = 0; i < 60; ++i) game.loop.frame(tick);
    CHECK(game.get("time.step").integer() == 150);
}

TEST_CASE("a length of a step that is changed in the run applies from the next step") {
    Game game("function step(dt) game.last_dt = dt end");
    for (int i = 0; i < 30; ++i) game.loop.frame(tick);
    game.set("time.dt", 0.01);
    game.loop.frame(0.0301);
    CHECK(game.get("time.step").integer() == 33);
    CHECK(game.get("last_dt").number() == 0.01);
    CHECK(game.get("time.now").number() == Approx(0.53));
}

TEST_CASE("a paused game makes no steps but calls update") {
    Game game("function update(dt) print('update ' .. dt) end function step() print('step') end");
    game.set("time.paused", true);
    game.loop.frame(1);
    CHECK(game.new_output() == "update 0.0");
    CHECK(game.get("time.alpha").number() == 1.0);
    game.set("time.paused", false);
    game.loop.frame(0.001);
    CHECK(game.get("time.step").integer() ==
          1);  // continues at once; the time of the pause is not made up for
}

TEST_CASE("step_once makes one step of a paused game and notifies its watchers") {
    Game game(R"(
        time:watch("step_once", function(new) print("once " .. tostring(new)) end)
        function step() print("step") end
    )");
    game.set("time.paused", true);
    game.loop.frame(tick);
    game.new_output();
    game.set("time.step_once", true);
    game.loop.frame(tick);
    CHECK(game.new_output() == "once true step");
    CHECK_FALSE(game.get("time.step_once").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "once false");
    CHECK(game.get("time.step").integer() == 1);
}

TEST_CASE("a game that pauses itself in a step makes no further step in the frame") {
    Game game("function step() time.paused = true end");
    game.loop.frame(4 * tick);
    CHECK(game.get("time.step").integer() == 1);
}

TEST_CASE("a headless turn makes one update and one step whatever the scale is") {
    Game game("function update() print('update') end function step() print('step') end");
    game.set("time.scale", 0.1);
    game.loop.turn();
    game.loop.turn();
    CHECK(game.new_output() == "update step update step");
    CHECK(game.get("time.step").integer() == 2);
}

TEST_CASE("the hook of step n runs before the callbacks of step n") {
    Game game("function update() print('update') end function step() print('step') end");
    game.loop.before_step([&](std::uint64_t n) { game.printed.push_back(std::to_string(n)); });
    SECTION("in a headless turn") {
        game.loop.turn();
        game.loop.turn();
        CHECK(game.new_output() == "1 update step 2 update step");
    }
    SECTION("in a frame of several steps") {
        game.loop.frame(2 * tick);
        CHECK(game.new_output() == "1 update step 2 step");
    }
    SECTION("in a frame without a step it does not run") {
        game.loop.frame(0.5 * tick);
        CHECK(game.new_output() == "update");
        game.loop.frame(tick);
        CHECK(game.new_output() == "1 update step");
    }
    SECTION("in a headless turn of a paused game it can end the pause") {
        game.loop.before_step([&](std::uint64_t n) {
            if (n == 3) game.set("time.paused", false);
        });
        game.set("time.paused", true);
        for (int i = 0; i < 3; ++i) game.loop.turn();
        CHECK(game.get("time.step").integer() == 1);
    }
}

TEST_CASE("a hook of a loop may replace itself") {
    Game game;
    std::weak_ptr<int> life;
    bool lived = false;
    // Replaces the hook while it runs; its captures must still exist afterwards.
    const auto hook = [&](auto set) {
        auto held = std::make_shared<int>();
        life = held;
        return [held, set, &life = life, &lived = lived](auto...) {
            const std::weak_ptr<int>& watched = life;
            bool& result = lived;
            set();
            result = !watched.expired();
        };
    };
    Loop& loop = game.loop;
    SECTION("between frames") {
        loop.between_frames(hook([&loop] { loop.between_frames({}); }));
    }
    SECTION("before a step") {
        loop.before_step(hook([&loop] { loop.before_step({}); }));
    }
    SECTION("after a barrier") {
        loop.after_barrier(hook([&loop] { loop.after_barrier({}); }));
    }
    loop.turn();
    CHECK(lived);
    loop.frame(tick);
    CHECK(game.get("time.step").integer() == 2);
}

TEST_CASE("functions that a loop calls may add modules and layers to it") {
    struct Adding : Layer {
        explicit Adding(Loop& to) : loop(to) {}
        bool handle(const InputEvent&) override {
            ++handled;
            if (more.size() < 20) loop.add(*more.emplace_back(std::make_unique<Adding>(loop)));
            return false;
        }
        void draw(Surface&, double) override {}
        Loop& loop;
        int handled = 0;
        std::vector<std::unique_ptr<Adding>> more{};
    };
    Game game;
    int steps = 0, reports = 0;
    const auto add = [&] {
        for (int i = 0; i < 10; ++i)
            game.loop.add(
                {.name = "more", .step = [&](double) { ++steps; }, .report = [&] { ++reports; }});
    };
    game.loop.add({.name = "first",
                   .step =
                       [&](double) {
                           if (++steps == 1) add();
                       },
                   .report =
                       [&] {
                           if (++reports == 1) add();
                       }});
    game.loop.turn();
    CHECK(steps == 11);
    CHECK(reports == 21);
    game.loop.turn();
    CHECK(steps == 32);
    Adding layer(game.loop);
    game.loop.add(layer);
    game.press("a");
    CHECK(layer.handled == 1);
    game.release("a");
    CHECK(layer.handled == 2);
    CHECK(layer.more[0]->handled == 1);
}

TEST_CASE("no step is made beyond the limit") {
    Game game;
    game.loop.frame(4 * tick, 2);
    CHECK(game.get("time.step").integer() == 2);
    CHECK(game.get("time.alpha").number() == 1.0);  // exactly that step is drawn
}

TEST_CASE("an error stops the frame at once and edits still take effect") {
    Game game(R"(
        game.mark = Object {}
        game.mark.n = 0
        game.mark:watch("n", function(new) print("n " .. new) end)
        function update() error("wrong") end
        function step() print("step") end
    )");
    game.loop.frame(tick);
    REQUIRE(game.errors.size() == 1);
    CHECK(game.loop.halted());
    CHECK(game.new_output() == "");
    game.set("mark.n", 7);
    game.loop.frame(tick);
    CHECK(game.new_output() == "n 7");
    CHECK(game.errors.size() == 1);
    CHECK(game.get("time.step").integer() == 0);
}

TEST_CASE("the game can continue after an error") {
    Game game("function update() if not game:has('mended') then error('wrong') end end");
    game.loop.frame(tick);
    CHECK(game.loop.halted());
    game.tree.set_or_add(game.tree.root(), "mended", true);
    game.loop.resume();
    game.loop.frame(tick);
    CHECK_FALSE(game.loop.halted());
    CHECK(game.get("time.step").integer() == 1);
}

TEST_CASE("quit ends the frame immediately") {
    Game game("function update() quit(4) end function step() print('step') end");
    game.loop.frame(tick);
    CHECK(game.loop.stopped());
    CHECK(game.runtime.quit_status() == 4);
    CHECK(game.new_output() == "");
}

TEST_CASE("handlers that change things without end cause an error and do not end the game") {
    Game game(R"(
        game.mark = Object {}
        game.mark.n = 0
        game.mark:watch("n", function(new) game.mark.n = new + 1 end)
    )");
    int reported = 0;
    game.loop.on_error([&](const script::ScriptError&) { ++reported; });
    game.set("mark.n", 1);
    game.loop.frame(tick);
    CHECK(reported + static_cast<int>(game.errors.size()) == 1);
}

TEST_CASE("equal runs have equal hashes and different runs have different ones") {
    constexpr auto script = "game.score = 0 function step() game.score = game.score + 1 end";
    Game one(script), two(script);
    for (int i = 0; i < 10; ++i) one.loop.turn();
    for (int i = 0; i < 10; ++i) two.loop.turn();
    CHECK(one.loop.hash() == two.loop.hash());
    two.set("score", 11);
    CHECK(one.loop.hash() != two.loop.hash());
    one.set("score", 11);
    CHECK(one.loop.hash() == two.loop.hash());
    one.set("view.height", 5);  // the view is not a part of the state
    CHECK(one.loop.hash() == two.loop.hash());
    one.loop.turn();
    CHECK(one.loop.hash() != two.loop.hash());
}

TEST_CASE("the hash contains the hashes of modules") {
    Game one, two;
    one.loop.add({.name = "m", .step = [](double) {}, .hash = [] { return std::uint64_t{1}; }});
    two.loop.add({.name = "m", .step = [](double) {}, .hash = [] { return std::uint64_t{2}; }});
    CHECK(one.loop.hash() != two.loop.hash());
}

TEST_CASE("the clock refuses invalid values") {
    Game game;
    CHECK_THROWS_WITH(game.set("time.dt", 0.0), contains("time.dt"));
    CHECK_THROWS_WITH(game.set("time.max_steps", 0), contains("time.max_steps"));
    CHECK_THROWS_WITH(game.set("time.scale", -1.0), contains("time.scale"));
    CHECK_THROWS_WITH(game.set("time.step", 4), contains("read-only"));
    CHECK_THROWS(game.set("time.dt", std::numeric_limits<double>::infinity()));
}

TEST_CASE("update gets game time and real time") {
    Game game("function update(dt, real_dt) print(dt, real_dt) end");
    game.set("time.scale", 0.5);
    game.loop.frame(0.25);
    CHECK(game.new_output() == "0.08333333333333333\t0.25");  // at most five steps
    game.set("time.max_steps", 1000);
    game.loop.frame(0.25);
    CHECK(game.new_output() == "0.125\t0.25");
    game.set("time.paused", true);
    game.loop.frame(0.5);
    CHECK(game.new_output() == "0.0\t0.5");
    CHECK(game.get("time.real").number() == 1);
    game.loop.turn();
    CHECK(game.get("time.real").number() == Approx(1 + tick));
}

}  // namespace fettle::app
