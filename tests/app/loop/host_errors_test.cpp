// Errors of a host that uses a loop.

#include <catch.h>
#include <last_words.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "game.h"

namespace host_errors_test {

using namespace fettle;
using namespace fettle::app;

TEST_CASE("an exception from a function of the host after a barrier leaves the turn") {
    Game game;
    bool throws = true;
    game.loop.after_barrier([&] {
        if (throws) throw std::runtime_error("mine");
    });
    CHECK_THROWS_WITH(game.loop.turn(), "mine");
    CHECK_THROWS_WITH(game.loop.frame(tick), "mine");
    // The exception of the barrier itself is reported first; the function is called all the same.
    game.tree.at_barrier([] { throw std::runtime_error("the barrier's"); });
    int called = 0;
    game.loop.after_barrier([&] { ++called; });
    CHECK_THROWS_WITH(game.loop.turn(), "the barrier's");
    CHECK(called == 1);
    throws = false;
    game.loop.turn();
    CHECK(game.get("time.step").integer() == 1);
}

TEST_CASE("an exception from an observer at the end of a frame leaves the frame") {
    struct Throwing : LoopObserver {
        void event(const InputEvent&, bool) override {}
        void frame_begins(double, std::int64_t) override {}
        void turn_begins() override {}
        void frame_ends() override { throw std::runtime_error("observer"); }
        void stepped() override {}
    } observer;
    Game game;
    game.loop.set_observer(&observer);
    CHECK_THROWS_WITH(game.loop.turn(), "observer");
    game.loop.after_barrier([] { throw std::runtime_error("mine"); });
    CHECK_THROWS_WITH(game.loop.frame(tick), "mine");
}

TEST_CASE("an invalid clock is refused and does no harm") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Game game;
    game.loop.turn();
    Clock& clock = game.services.clock;
    const auto refused = [&](const std::string& named) {
        CHECK_THROWS_WITH(game.loop.turn(), contains(named));
        CHECK_THROWS_WITH(game.loop.frame(tick), contains(named));
    };
    for (const double dt : {std::nan(""), infinity, 0.0, -1.0, 1e300}) {
        CAPTURE(dt);
        const double good = std::exchange(clock.dt, dt);
        refused("time.dt = ");
        clock.dt = good;
    }
    clock.scale = infinity;
    refused("time.scale");
    clock.scale = 1;
    clock.rewind_limit = std::nan("");
    refused("time.rewind_limit");
    clock.rewind_limit = 60;
    clock.rewind_memory = std::nan("");
    refused("time.rewind_memory");
    clock.rewind_memory = 128;
    for (const double seconds : {std::nan(""), infinity})
        CHECK_THROWS_WITH(game.loop.frame(seconds), contains("a frame of"));
    CHECK(clock.step == 1);
    game.loop.turn();
    game.loop.frame(tick);
    CHECK(clock.step == 3);
    CHECK(clock.now == 3 * tick);
    game.tree.restore(game.tree.snapshot());
}

TEST_CASE("a clock made invalid in the middle of a turn does no harm either") {
    Game game;
    bool spoil = true;
    game.loop.after_barrier([&] {
        if (spoil) game.services.clock.dt = std::nan("");
    });
    CHECK_THROWS_WITH(game.loop.turn(), contains("time.dt"));
    CHECK(game.services.clock.now == 0);
    spoil = false;
    game.services.clock.dt = tick;
    game.loop.turn();
    CHECK(game.services.clock.now == tick);
}

TEST_CASE("a module without a step is refused by name") {
    Game game;
    CHECK_THROWS_AS(game.loop.add({.name = "wind"}), std::invalid_argument);
    CHECK_THROWS_WITH(game.loop.add({.name = "wind"}), contains("\"wind\""));
    game.loop.turn();
}

TEST_CASE("a loop whose runtime was destroyed reports this and ends without harm") {
    property::Tree tree;
    Services services{tree};
    auto runtime = std::make_unique<script::Runtime>(tree, script::Options{});
    Loop loop(tree, *runtime, services);
    runtime->on_print([&](std::string_view) { runtime.reset(); });
    if (GENERATE(true, false)) {
        runtime->run("function update() print(1) end function step() print(2) end", "test");
        loop.turn();  // destroys the runtime in the middle of the turn
    } else {
        runtime.reset();
    }
    CHECK(runtime == nullptr);
    CHECK(loop.stopped());
    CHECK_THROWS_WITH(loop.turn(), contains("the runtime of this loop was destroyed"));
    CHECK_THROWS_WITH(loop.frame(tick), contains("the runtime of this loop was destroyed"));
}

TEST_CASE("a loop that is destroyed by a function it calls ends the program with a message") {
    const auto destroyed_in = [](const char* where, const std::function<void(Loop&)>& call,
                                 const std::function<void(Loop&, std::function<void()>)>& hook) {
        CAPTURE(where);
        property::Tree tree;
        Services services{tree};
        script::Runtime runtime(tree, script::Options{});
        auto loop = std::make_unique<Loop>(tree, runtime, services);
        hook(*loop, [&] { loop.reset(); });
        CHECK_THAT(termination_message([&] { call(*loop); }),
                   contains("the loop is destroyed by a function that its `" + std::string(where) +
                            "` is calling, which must not do so"));
    };
    const auto turn = [](Loop& loop) { loop.turn(); };
    const auto frame = [](Loop& loop) { loop.frame(tick); };
    destroyed_in("turn", turn, [](Loop& loop, auto end) { loop.after_barrier(end); });
    destroyed_in("frame", frame, [](Loop& loop, auto end) { loop.between_frames(end); });
    destroyed_in("turn", turn,
                 [](Loop& loop, auto end) { loop.before_step([end](std::uint64_t) { end(); }); });
    destroyed_in("step", turn, [](Loop& loop, auto end) {
        loop.add(SteppedModule{.name = "wind", .step = [end](double) { end(); }});
    });
}

}  // namespace host_errors_test
