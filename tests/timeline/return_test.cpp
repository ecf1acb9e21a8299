// Going back in time and on: what is not a value of the tree goes on as it did.

#include "catch.h"

#include "playing.h"

namespace return_test {

using namespace fettle::app;
using fettle::property::Value;

namespace {

/// Plays to `end`, goes back to `step`, plays to `end` again. The states must be the same.
void check_again(Playing& game, std::int64_t step, int end) {
    game.play(end - static_cast<int>(game.services.clock.step));
    const std::vector<std::uint64_t> first = game.hashes;
    CAPTURE(step);
    game.services.clock.timeline.go_to(step);
    for (std::int64_t next = step + 1; next <= end; ++next) {
        CAPTURE(next);
        game.play(1);
        REQUIRE(game.services.clock.step == next);
        REQUIRE(game.loop->hash() == first[std::size_t(next)]);
    }
}

}  // namespace

TEST_CASE("ready is called once however often time goes back") {
    Playing game(R"(
        Ball = class("Ball", Object) { n = 0 }
        function Ball:ready() self.n = self.n + 1 end
        function step()
            if time.step == 3 then kept = Ball { } end
            if time.step == 5 then world.ball = kept end
            if time.step == 12 then world.ball:move(nil) end
            if time.step == 15 then world:add(kept, "ball") end
            if time.step == 20 then world.other = world.ball:clone() end
        end
        kept = nil)");
    for (const std::int64_t step : {4, 7, 13, 16, 21}) check_again(game, step, 25);
    CHECK(game.get("world.ball.n") == Value(1));
}

TEST_CASE("after going back into a transition it continues as before") {
    Playing game(R"(
        class("A", Object) { } class("B", Object) { n = 0 }
        function B:step() self.n = self.n + 1 end
        function step()
            if time.step == 2 then go_to_scene("A") end
            if time.step == 5 then go_to_scene("B", { transition = "fade", seconds = 0.5 }) end
        end)");
    for (const std::int64_t step : {5, 8, 20, 34}) check_again(game, step, 50);
    CHECK(game.get("game.scene.n").integer() > 10);
}

TEST_CASE("a change of the scene that is due is made after going back to that step") {
    Playing game(R"(
        class("A", Object) { } class("B", Object) { n = 0 }
        function B:enter(args) self.n = args.n end
        function step()
            if time.step == 2 then go_to_scene("A") end
            if time.step == 5 then go_to_scene("B", { args = { n = 7 } }) end
        end)");
    for (const std::int64_t step : {4, 5, 6}) check_again(game, step, 12);
    CHECK(game.get("game.scene.n") == Value(7));
    CHECK_FALSE(bool(game.tree.child(game.tree.root(), "transition")));
}

}  // namespace return_test
