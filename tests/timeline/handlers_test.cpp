// When the game goes to another moment, its instances have the handlers of that moment.

#include <catch.h>

#include <fettle/property/snapshot.h>

#include "playing.h"

namespace handlers_test {

using fettle::app::Playing;

namespace {

/// The printed lines since the last call, joined by spaces.
std::string new_output(Playing& game) {
    std::string all;
    for (const std::string& line : game.printed) all += (all.empty() ? "" : " ") + line;
    game.printed.clear();
    return all;
}

std::string run(Playing& game, const std::string& chunk) {
    INFO(chunk);
    CHECK(game.runtime->run(chunk, "later"));
    game.loop->turn();
    return new_output(game);
}

void go_to(Playing& game, std::int64_t step) {
    game.loop->timeline().go_to(step);
    (void)new_output(game);
}

const char* const levels = R"(
    class("Level", Object) { number = 0, alarm = 0 }
    function Level:enter(args)
        self.number = args
        local lamp = Object { props = { lit = 0 } }
        self:add(lamp, "lamp")
        lamp:watch("lit", function(new) print("lit", self.number, new) end)
        lamp:on("deleted", function() print("gone", self.number) end)
        self:watch("alarm", function() print("first") end)
        self:watch("alarm", function() print("second") end)
        watch("game.scene.alarm", function() print("global") end)
    end
    go_to_scene("Level", { args = 1 })
    function step() if time.step == 20 then go_to_scene("Level", { args = 2 }) end end
)";

}  // namespace

TEST_CASE("the handlers of a scene come back with it and go with it") {
    Playing game(levels);
    game.play(40);
    (void)new_output(game);
    go_to(game, 10);
    CHECK(run(game, "game.scene.lamp.lit = 5") == "lit\t1\t5");
    CHECK(run(game, "game.scene.alarm = 1") == "first second global");
    CHECK(run(game, "game.scene.lamp:delete()") == "gone\t1");
    // The game leaves the scene again, and the next scene has handlers of its own.
    while (game.services.clock.step < 30) game.loop->turn();
    (void)new_output(game);
    CHECK(run(game, "game.scene.lamp.lit = 6") == "lit\t2\t6");
    CHECK(run(game, "game.scene.alarm = 1") == "first second global");
    go_to(game, 15);
    CHECK(run(game, "game.scene.alarm = 2") == "first second global");
    CHECK(game.errors.empty());
}

TEST_CASE("a watcher learns whether a rewind has changed the value") {
    Playing game(R"(
        state("points", 0)
        game:watch("points", function(new, old, change) print(old, new, change.restored) end)
        function step() if time.step % 10 == 0 then points = points + 1 end end
    )");
    game.play(25);
    CHECK(new_output(game) == "0\t1\tfalse 1\t2\tfalse");
    game.loop->timeline().go_to(15);
    game.play(10);
    CHECK(new_output(game) == "2\t1\ttrue 1\t2\tfalse");
    CHECK(game.errors.empty());
}

TEST_CASE("going back and forth in time connects each handler once") {
    Playing game(levels);
    game.play(40);
    for (const std::int64_t step : {10, 40, 5, 25, 12, 40, 21, 19}) game.check(step);
    go_to(game, 40);
    CHECK(run(game, "game.scene.alarm = 1 game.scene.lamp.lit = 2") ==
          "first second global lit\t2\t2");
    CHECK(game.errors.empty());
}

TEST_CASE("going back undoes the connecting and the stopping of handlers") {
    Playing game(R"(
        game.ball = Object { x = 0 }
        first = ball:watch("x", function() print("first") end)
        second = ball:watch("x", function() print("second") end)
        function step()
            if time.step == 10 then first:stop() end
            if time.step == 15 then ball:watch("x", function() print("third") end) end
            if time.step == 20 then ball:delete() end
        end
    )");
    game.play(30);
    go_to(game, 17);
    CHECK(run(game, "ball.x = 1") == "second third");
    go_to(game, 5);
    CHECK(game.runtime->evaluate("first:active(), second:active()").ok);
    CHECK(run(game, "ball.x = 2") == "first second");
    game.play(1);
    while (game.services.clock.step < 17) game.loop->turn();
    (void)new_output(game);
    CHECK(run(game, "ball.x = 3") == "second third");
    CHECK(game.errors.empty());
}

TEST_CASE("handlers of a snapshot are those of its moment") {
    Playing game(R"(
        game.ball = Object { x = 0 }
        ball:watch("x", function() print("early") end)
    )");
    game.play(3);
    const auto then = game.tree.snapshot();
    game.runtime->run("ball:watch('x', function() print('late') end)  ball:delete()", "later");
    game.play(3);
    game.tree.restore(then);
    CHECK(run(game, "ball.x = 1") == "early");
    // A snapshot from bytes contains no functions: instances that live on keep their handlers.
    const auto file = fettle::property::Snapshot::from_bytes(game.tree.snapshot().to_bytes());
    game.runtime->run("ball:watch('x', function() print('late') end)", "later");
    game.tree.restore(file);
    CHECK(run(game, "ball.x = 2") == "early late");
}

TEST_CASE("a watcher that was made in the console stays after going back") {
    Playing game("game.ball = Object { x = 0 }");
    game.play(20);
    CHECK(game.runtime->evaluate("ball:watch('x', function() print('seen') end)").ok);
    go_to(game, 5);
    CHECK(run(game, "ball.x = 1") == "seen");
}

TEST_CASE("handlers of questions of physics are those of each repeated step") {
    Playing game(R"(
        world.gravity = vec(0, -10)
        class("Level", Object) { }
        function Level:enter()
            world:on("filter_pair", function(event) if game.hollow then event.collide = false end end)
        end
        world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
        for i = 1, 6 do world:add(Body { position = vec(i, 1 + i / 3), Circle { radius = 0.4 } }) end
        game.hollow = false
        go_to_scene("Level")
        function step()
            if time.step == 40 then game.hollow = true end
            if time.step == 50 then go_to_scene("Level") end
            if time.step == 70 then game.hollow = false game.scene:delete() end
        end
    )");
    game.play(120);
    for (const std::int64_t step : {110, 45, 65, 30, 90, 55, 120}) game.check(step);
    CHECK(game.errors.empty());
}

TEST_CASE("handlers of a constructor come back with the instance") {
    Playing game(R"(
        class("Crate", Object) { }
        game.crate = Crate { deleted = function() print("deleted") end }
        function step() if time.step == 10 then game.crate:delete() end end
    )");
    game.play(20);
    CHECK(new_output(game) == "deleted");
    go_to(game, 5);
    while (game.services.clock.step < 15) game.loop->turn();
    CHECK(new_output(game) == "deleted");
    CHECK(game.errors.empty());
}

TEST_CASE("a coroutine that began later ends with the first step from an earlier moment") {
    Playing game(R"(
        game.a = Object { x = 0 }
        function step()
            if time.step == 30 then a:run(function(o) while true do wait(0.05) o.x = o.x + 1 end end) end
        end
    )");
    game.play(50);
    const auto x = game.get("a.x");
    go_to(game, 10);
    // Going forward again restores the value.
    go_to(game, 50);
    CHECK(game.get("a.x") == x);
    game.play(30);
    const auto later = game.get("a.x");
    CHECK(later.integer() > x.integer());
    go_to(game, 10);
    while (game.services.clock.step < 29) game.loop->turn();
    CHECK(game.get("a.x").integer() == 0);
    while (game.services.clock.step < 80) game.loop->turn();
    CHECK(game.get("a.x") == later);
    CHECK(game.errors.empty());
}

TEST_CASE("a coroutine that only waited since a moment waits from there as it did") {
    Playing game(R"(
        game.a = Object { x = 0 }
        after(0, function() wait(1) a.x = time.step end)
    )");
    std::vector<std::string> notes;
    game.runtime->on_note([&](std::string_view note) { notes.emplace_back(note); });
    game.play(40);
    go_to(game, 5);
    game.play(100);
    CHECK(game.get("a.x").integer() == 61);
    CHECK(notes.empty());
    CHECK(game.errors.empty());
}

TEST_CASE("a coroutine that has run since a moment goes on where it was and a note says so") {
    Playing game(R"(
        game.a = Object { x = 0, done = 0 }
        after(0, function() while true do wait(0.5) a.x = time.step end end)
        after(0, function() wait(0.25) a.done = time.step end)
    )");
    std::vector<std::string> notes;
    game.runtime->on_note([&](std::string_view note) { notes.emplace_back(note); });
    game.play(40);
    go_to(game, 10);  // the first one waits for 21 steps more, the second one has ended
    go_to(game, 40);
    game.play(1);
    CHECK(notes.empty());  // the game has gone on from where it was
    go_to(game, 10);
    game.play(40);
    CHECK(game.get("a.x").integer() == 30);
    CHECK(game.get("a.done").integer() == 0);
    REQUIRE(notes.size() == 1);
    CHECK(
        notes[0] ==
        "coroutines do not go back in time: 1 goes on where it was (test:3), and 1 that has ended "
        "since does not run again; what must go back belongs to a step, a state, a timer or a "
        "tween");
    go_to(game, 20);
    game.play(5);
    CHECK(notes.size() == 1);
    CHECK(game.errors.empty());
}

TEST_CASE("a rewind calls no deleted handler for the instances that it removes") {
    Playing game(R"(
        game.killed = 0
        class("Enemy", Object) { }
        function Enemy:deleted() game.killed = game.killed + 1 end
        Enemy:on("created", function() game.killed = game.killed + 100 end)
        game.first = Enemy { }
        game.first:on("deleted", function() game.killed = game.killed + 10 end)
        function step()
            if time.step == 20 then game.second = Enemy { } end
            if time.step == 30 then game.first:delete() end
        end
    )");
    game.play(40);
    game.services.clock.paused = true;
    for (const std::int64_t step : {35, 10, 25, 40, 10}) {
        game.check(step);
        game.loop->turn();
        CHECK(game.get("game.killed").integer() == (step < 20 ? 100 : step < 30 ? 200 : 211));
        game.check(step);
    }
    CHECK(game.errors.empty());
}

TEST_CASE("a zoom that was set is restored by going back") {
    Playing game(
        "function step() if time.step == 30 then view.zoom = 2 elseif time.step == 36 then "
        "view.zoom = 4.5 end end");
    game.play(40);
    for (const std::int64_t step : {10, 35, 29, 40, 36}) {
        game.check(step);
        CHECK(game.get("view.zoom").number() == Approx(step < 30 ? 40 : step < 36 ? 2 : 4.5));
    }
}

}  // namespace handlers_test
