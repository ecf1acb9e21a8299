// Where the time of a frame goes. No test compares measured times with others than those of its own
// run.

#include <catch.h>

#include "game.h"

namespace timings_test {

using namespace fettle;
using app::FrameLog;
using app::Game;
using app::tick;

TEST_CASE("a headless run has timings") {
    Game game("function step() local x = 0 for i = 1, 20000 do x = x + i end end");
    CHECK(game.get("time.timings.scripts").number() == 0);
    for (int i = 0; i < 3; ++i) game.loop.turn();
    CHECK(game.get("time.timings.scripts").number() > 0);
    CHECK(game.get("time.timings.frame").number() >= game.get("time.timings.scripts").number());
    CHECK(game.get("time.fps").number() == 0);
    const auto& frames = game.services.clock.frames.frames();
    REQUIRE(frames.size() == 3);
    CHECK(frames.back().step == 3);
    CHECK(frames.back().ms.scripts > 0);
    CHECK(frames.back().ms.frame >= frames.back().ms.work());
}

TEST_CASE("a frame lasts until the next one and the rest of it is waiting") {
    Game game;
    game.loop.frame(tick);
    game.loop.frame(0.5);
    const auto& frames = game.services.clock.frames.frames();
    REQUIRE(frames.size() == 2);
    CHECK(frames[0].ms.frame == Approx(500));
    CHECK(frames[0].ms.wait == Approx(500 - frames[0].ms.work()));
    CHECK(frames[1].ms.frame == 0);
    CHECK(game.get("time.timings.wait").number() > 0);
}

TEST_CASE("frames of a paused game are not kept unless they make a step") {
    Game game;
    game.loop.frame(tick);
    game.set("time.paused", true);
    for (int i = 0; i < 5; ++i) game.loop.frame(tick);
    CHECK(game.services.clock.frames.frames().size() == 1);
    game.set("time.step_once", true);
    game.loop.frame(tick);
    CHECK(game.services.clock.frames.frames().size() == 2);
}

TEST_CASE("the oldest frames are dropped") {
    FrameLog log;
    for (int i = 0; i < 310; ++i) log.add({.ms = {.input = 1}, .frame = i});
    CHECK(log.frames().size() == FrameLog::most);
    CHECK(log.frames().front().frame == 10);
    REQUIRE(log.complete(4) != nullptr);
    CHECK(log.frames().back().ms.wait == Approx(3));
    CHECK(log.complete(9) == nullptr);
    CHECK(log.frames().back().ms.frame == Approx(4));
}

}  // namespace timings_test
