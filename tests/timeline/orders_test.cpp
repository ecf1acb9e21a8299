// Functions that change the time of a game, in one frame and in any order: the game continues, and
// can be saved afterwards.

#include "catch.h"

#include "playing.h"
#include "temporary_folder.h"
#include "thorough.h"

namespace orders_test {

using namespace fettle;
using namespace fettle::app;

namespace {

constexpr const char* game = R"(
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    for i = 1, 6 do world:add(Body { position = vec(i * 1.1 - 2, 1 + i), Box {} }) end
    Coin = class("Coin", Body) { worth = 1 }
    function Coin:step(dt) self.worth = self.worth + 1 end
    world.coin = Coin { position = vec(3, 5), Circle {} }
    world.note = Object {}
    world.note.twice = formula(function() return world.coin.worth * 2 end)
    every(0.05, function() world.body_1:apply_impulse(vec(random(-1, 1), 1)) end)
    made, held = 0, false
    actions = {
        snapshot = function() held = snapshot() end,
        restore = function() restore(early) end,
        restore_new = function() restore(held or early) end,
        rewind = function() rewind(0.1) end,
        rewind_far = function() rewind(100) end,
        forth = function() time:go_to(time.newest) end,
        save = function() save_game("one") end,
        load = function() load_game("one") end,
        delete_save = function() pcall(delete_save, "two") save_game("two") delete_save("two") end,
        undo = function() undo() end,
        redo = function() redo() end,
        edit = function() edit("e", function() world.gravity = vec(random(), -9) end) end,
        clone = function() made = made + 1 world["copy" .. made] = world.body_1:clone() end,
        delete = function() local b = world:find("Body")[3] if b then edit("d", function() b:delete() end) end end,
        step_once = function() time.step_once = true end,
        pause = function() time.paused = not time.paused end,
    }
    names = {}
    for name in pairs(actions) do table.insert(names, name) end
    table.sort(names)
)";

/// The game continues without an error, and a save of it can be restored.
void play_on(Playing& played) {
    played.console("time.paused = false");
    played.play(7);
    CHECK_FALSE(played.physics.world(property::resolve(played.tree, "world").instance).validate());
    const auto saved = property::Snapshot::from_bytes(played.tree.snapshot().to_bytes());
    const std::uint64_t then = played.loop->hash();
    played.play(3);
    played.tree.restore(saved);
    CHECK(played.loop->hash() == then);
    played.play(4);
}

}  // namespace

TEST_CASE(
    "after any two or three jumps through time in one frame the game continues and is saved") {
    const TemporaryFolder folder;
    Playing played(game, folder.path);
    played.play(10);
    played.console("early = snapshot()");
    played.console("save_game('one')");
    played.play(30);
    // The game goes on from order to order; it is restored to this state after every 40 orders.
    const property::Snapshot begin = played.tree.snapshot();
    const int count = int(property::Value(played.runtime->evaluate("#names").result).integer());
    REQUIRE(count > 12);
    const auto call = [](int action) {
        return "actions[names[" + std::to_string(action + 1) + "]]()\n";
    };
    int order = 0;
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b)
            for (int c = -1; c < count; ++c) {
                // Only some of the orders of three are run: all of them would take minutes.
                if (c >= 0 && (a * 7 + b * 5 + c) % (thorough() ? 3 : 29) != 0) continue;
                if (++order % 40 == 0) played.tree.restore(begin);
                const std::string chunk = call(a) + call(b) + (c >= 0 ? call(c) : "");
                INFO(chunk << " after order " << order);
                REQUIRE(played.runtime->run(chunk, "order"));
                played.play(1);
                play_on(played);
            }
}

TEST_CASE("rewind after a restore in one frame counts from the restored state") {
    Playing played("world.ball = Body { position = vec(0, 100), Circle {} }");
    played.play(60);
    played.console("kept = snapshot()");
    played.play(60);
    played.runtime->run("restore(kept) rewind(0.5)", "test");
    played.play(1);
    CHECK(played.services.clock.step == 31);  // 60 - 30, and the step made now
    played.check(31);
    played.check(10);
}

TEST_CASE("the restored state is the newest moment until a step is made from it") {
    Playing played("world.ball = Body { position = vec(0, 100), Circle {} }");
    played.play(60);
    played.console("kept = snapshot()");
    played.play(60);
    played.runtime->run("restore(kept) time:go_to(time.newest)", "test");
    played.play(1);
    CHECK(played.services.clock.step == 61);
    CHECK(played.time().newest() == 61);
    // The same after going back from the edited state and returning to it.
    played.runtime->run("restore(kept)", "test");
    played.tree.barrier();
    REQUIRE(played.services.clock.step == 60);
    played.runtime->run("world.made = Object { Object {} } world.ball:delete()", "test");
    played.tree.barrier();
    played.time().go_to(30);
    CHECK(property::resolve(played.tree, "world.ball").instance);
    REQUIRE(played.time().newest() == 60);
    played.time().go_to(60);
    CHECK_THROWS(property::resolve(played.tree, "world.ball"));
    CHECK(property::resolve(played.tree, "world.made.object").instance);
    played.play(70);
    for (const std::int64_t step : {59, 61, 100, 20, 130}) played.check(step);
}

TEST_CASE("thinned keyframes do not keep data that no step needs") {
    // Random data that cannot be compressed, so that six keyframes take megabytes.
    Playing played(R"(
        world.ball = Body { position = vec(0, 100), Circle {} }
        local all = {}
        for i = 1, 400000 do all[i] = string.char(random(1, 255)) end
        world.text = table.concat(all)
    )");
    played.play(200);
    played.console("kept = snapshot()");
    played.play(5);
    played.runtime->run("restore(kept)", "test");
    played.tree.barrier();
    played.runtime->run("world.gravity = vec(3, 5)", "test");
    played.play(30);
    const std::int64_t step = played.services.clock.step - 20;
    const std::size_t frames = played.time().keyframes();
    std::size_t fewest = frames;
    for (double memory = 8; memory > 1; memory *= 0.9) {
        played.console("time.rewind_memory = " + std::to_string(memory));
        played.play(1);
        if (played.time().oldest() > step) break;
        fewest = played.time().keyframes();
        played.check(step);
        played.time().go_to(played.time().newest());
    }
    CHECK(fewest < frames);
}

TEST_CASE("a restore after a rewind in one frame gives the restored state") {
    Playing played("world.ball = Body { position = vec(0, 100), Circle {} }");
    played.play(60);
    played.console("kept = snapshot()");
    played.play(60);
    played.runtime->run("rewind(1.5) restore(kept)", "test");
    played.play(1);
    CHECK(played.services.clock.step == 61);
    played.check(20);
}

TEST_CASE("saving and loading in one frame gives the saved state") {
    const TemporaryFolder folder;
    Playing played("world.score = 1", folder.path);
    played.play(2);
    played.runtime->run("world.score = 7 save_game('a') load_game('a') world.score = 8", "test");
    played.play(1);
    CHECK(played.get("world.score") == property::Value(8));  // the value at the barrier
    played.runtime->run("save_game('b') world.score = 9 load_game('a')", "test");
    played.play(1);
    CHECK(played.get("world.score") == property::Value(8));
    played.runtime->run("delete_save('b')", "test");
    CHECK(played.runtime->evaluate("pcall(load_game, 'b')").lines.front().starts_with("false"));
}

TEST_CASE("a save that is deleted in its frame is not written") {
    const TemporaryFolder folder;
    Playing played("world.score = 1", folder.path);
    played.play(2);
    played.runtime->run("save_game('a') delete_save('a')", "test");
    played.play(2);
    CHECK(played.saves->slots().list().empty());
}

TEST_CASE("rewind before the first keyframe does nothing") {
    Playing played("world.ball = Body { position = vec(0, 100), Circle {} } rewind(1)");
    played.play(3);
    CHECK(played.services.clock.step == 3);
    played.console("time.rewind_limit = 0");
    played.play(2);
    played.runtime->run("rewind(1)", "test");
    played.play(2);
    CHECK(played.services.clock.step == 7);
    CHECK_FALSE(played.runtime->run("time:go_to(2)", "test"));
    REQUIRE(played.errors.size() == 1);
    CHECK(played.errors[0].find("there is no past to go to") != std::string::npos);
}

}  // namespace orders_test
