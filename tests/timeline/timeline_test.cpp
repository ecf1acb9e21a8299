// The timeline: every moment in it is restored bit for bit.

#include <map>

#include "catch.h"

#include "playing.h"

namespace timeline_test {

using namespace fettle;
using namespace fettle::app;

namespace {

constexpr const char* busy = R"(
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    for i = 1, 25 do
        world:add(Body { position = vec(i % 5 * 1.1 - 2, 1 + i), Box {} })
    end
    world.ball = Body { position = vec(0, 40), Circle { radius = 0.4, restitution = 0.5 } }
    world.anchor = Body { type = "static", position = vec(6, 12), Circle { radius = 0.1 } }
    world.bob = Body { position = vec(9, 12), Circle { radius = 0.5 } }
    world.rope = DistanceJoint { body_a = world.anchor, body_b = world.bob }
    Coin = class("Coin", Body) { worth = 1, label = "" }
    function Coin:step(dt) self.worth = self.worth + 1 end
    made, steps = {}, 0
    game.shadow = Object {}
    game.shadow.x = formula(function() return world.ball.position.x * 2 end)
    world.ball:watch("awake", function(new) world.ball.wakes = tostring(new) end)
    world.ball:on("contact_begin", function(contact)
        world.ball.velocity = world.ball.velocity + vec(random() - 0.5, 3)
    end)
    every(0.2, function() world.bob:apply_impulse(vec(random(-3, 3), 1)) end)
    function update(dt) game.shadow.frames = steps end
    function step(dt)
        steps = steps + 1
        world.ball:apply_force(vec(math.sin(steps / 10) * 5, 0))
        if steps % 7 == 0 then
            local coin = Coin { position = vec(random() * 6 - 3, 15), Circle { radius = 0.3 } }
            world:add(coin)
            table.insert(made, coin)
        end
        if steps % 40 == 0 then table.remove(made, 1):delete() end
        if steps % 31 == 0 then world.body_3.friction = random() end
        if steps == 53 then world.body_4:move(game) end
        if steps == 90 then world.body_5.mass = 20; world.gravity = vec(1, -9) end
        if steps == 120 then game.second = World {}; game.second.thing = Body { Circle {} } end
        if steps == 150 then world.body_6.name = "renamed"; world.body_7.note = "hello" end
    end
)";

}  // namespace

TEST_CASE("every earlier step is the same after going back to it") {
    Playing game(busy);
    game.play(200);
    REQUIRE(game.time().newest() == 200);
    REQUIRE(game.time().oldest() == 0);
    REQUIRE(game.time().keyframes() > 2);
    for (const int step : {199, 3, 60, 61, 59, 120, 150, 90, 1, 180, 200}) game.check(step);
    for (int step = 1; step <= 200; step += 13) game.check(step);
}

TEST_CASE("steps in which scripts write thousands of numbers are restored too") {
    Playing game(R"(
        world.gravity = vec(0, 0)
        local bodies, n = {}, 0
        for i = 1, 8 do
            bodies[i] = Body { position = vec(3 * i, 0), Circle { radius = 0.5 } }
            world:add(bodies[i])
        end
        function step(dt)
            n = n + 1
            -- From none to some thousands, with what is reported by itself in between.
            for k = 1, n * n % 3000 do
                local body = bodies[k % 8 + 1]
                body.angular_velocity = (n * k) % 17 - 8.3
                body.velocity = vec((n + k) % 5 - 2.1, (n * k) % 3 - 1.1)
                if k % 700 == 0 then world.gravity = vec(0, k % 9 / 7) end
                if k % 900 == 0 then bodies[1]:apply_impulse(vec(k % 4, 0)) end
                if k % 1000 == 0 then bodies[2].mass = 1 + k % 3 end
            end
        end
    )");
    game.play(130);
    for (const int step : {129, 1, 12, 55, 56, 40, 100, 130}) game.check(step);
    for (int step = 1; step <= 130; step += 7) game.check(step);
}

TEST_CASE("the kept past is reviewed step by step and the present is as it was") {
    Playing game(busy);
    game.play(120);
    const auto positions = [&game](std::int64_t from) {
        std::map<std::int64_t, property::Vec2> all;
        game.time().review(from, [&](std::int64_t step) {
            CHECK(all.emplace(step, game.get("world.ball.position").vec2()).second);
        });
        return all;
    };
    const auto seen = positions(50);
    REQUIRE(seen.size() == 71);
    CHECK(seen.begin()->first == 50);
    CHECK(seen.rbegin()->first == 120);
    CHECK(game.services.clock.step == 120);
    REQUIRE(game.loop->hash() == game.hashes[120]);
    for (const std::int64_t step : {50, 51, 77, 99, 120}) {
        game.check(step);
        CHECK(seen.at(step) == game.get("world.ball.position").vec2());
    }
    // From the past only what came before; the rest is kept.
    game.time().go_to(80);
    CHECK(positions(-5).rbegin()->first == 80);
    REQUIRE(game.loop->hash() == game.hashes[80]);
    CHECK(game.time().newest() == 120);
    game.check(120);
    game.play(10);
    CHECK(game.time().newest() == 130);
}

TEST_CASE("a part of the kept past is reviewed also behind the present step") {
    Playing game(busy);
    game.play(120);
    std::map<std::int64_t, property::Vec2> all;
    for (int step = 0; step <= 120; ++step) {
        game.time().go_to(step);
        all.emplace(step, game.get("world.ball.position").vec2());
    }
    for (const std::int64_t here : {120, 80, 31})
        for (const auto& [from, to] : {std::pair<std::int64_t, std::int64_t>{50, 95},
                                       {-10, 20},
                                       {110, 400},
                                       {here, here},
                                       {here + 1, here + 3}}) {
            INFO(here << ": " << from << " to " << to);
            game.time().go_to(here);
            std::vector<std::int64_t> seen;
            game.time().review(from, to, [&](std::int64_t step) {
                seen.push_back(step);
                CHECK(game.get("world.ball.position").vec2() == all.at(step));
            });
            std::vector<std::int64_t> expected;
            for (std::int64_t step = std::max<std::int64_t>(0, from);
                 step <= std::min<std::int64_t>(120, to); ++step)
                expected.push_back(step);
            CHECK(seen == expected);
            CHECK(game.services.clock.step == here);
            REQUIRE(game.loop->hash() == game.hashes[static_cast<std::size_t>(here)]);
            CHECK(game.time().newest() == 120);
        }
}

TEST_CASE("the review of a part ends before a snapshot that was restored later") {
    Playing game(busy);
    game.play(20);
    game.runtime->run("taken = snapshot()", "test");
    game.play(30);
    game.runtime->run("restore(taken)", "test");
    game.play(30);
    game.time().go_to(10);
    std::int64_t last = -1;
    game.time().review(0, 1000, [&](std::int64_t step) { last = step; });
    CHECK(last >= 10);
    CHECK(last <= 50);
    CHECK(game.services.clock.step == 10);
    REQUIRE(game.loop->hash() == game.hashes[10]);
}

TEST_CASE("the review of the past begins where a snapshot was restored") {
    Playing game(busy);
    game.play(20);
    game.runtime->run("taken = snapshot()", "test");
    game.play(30);
    game.runtime->run("restore(taken)", "test");
    game.loop->turn();
    const std::int64_t after = game.services.clock.step;
    game.loop->turn();
    std::int64_t first = -1;
    game.time().review(0, [&](std::int64_t step) { first = first < 0 ? step : first; });
    CHECK(first >= 20);
    CHECK(first <= after);
}

TEST_CASE("the game continues from the present after going back and returning") {
    Playing game(busy), other(busy);
    game.play(150);
    other.play(150);
    game.check(20);
    game.check(150);
    game.play(60);
    other.play(60);
    // Except for local variables of the script, which were not stepped meanwhile.
    REQUIRE(game.hashes == other.hashes);
    game.check(170);
}

TEST_CASE("edits in the past start another timeline and end the old one") {
    Playing game(R"(
        world.ball = Body { position = vec(0, 10), Circle {} }
    )");
    game.play(120);
    game.console("time.paused = true");
    const double there = game.get("world.ball.position.y").number();
    game.check(30);
    game.console("world.ball.gravity_scale = -1");
    REQUIRE(game.time().newest() == 120);  // it is not cut yet
    game.console("time.paused = false");
    game.play(90);
    REQUIRE(game.time().newest() == 120);
    REQUIRE(game.get("world.ball.position.y").number() > there + 1);
    game.check(31);
    game.check(110);
    game.check(10);
}

TEST_CASE("edits made in the present are kept while the past is shown") {
    Playing game("world.ball = Body { position = vec(0, 10), Circle {} }");
    game.play(60);
    game.console("world.ball.mass = 7");
    game.check(20);
    REQUIRE(game.get("world.ball.mass").number() != 7);
    game.time().go_to(60);
    REQUIRE(game.get("world.ball.mass").number() == 7);
    game.play(10);
    game.time().go_to(65);
    REQUIRE(game.get("world.ball.mass").number() == 7);
}

TEST_CASE(
    "handlers that a repeated step calls get the time and the random numbers of that step again") {
    Playing game(R"(
        world.floor = Body { type = "static", Box { width = 20, height = 1 } }
        world.box = Body { position = vec(0, 0.99), velocity = vec(2, 0), Box {} }
        world.ball = Body { position = vec(3, 3), velocity = vec(-1, 0), Circle {} }
        every(0.05, function() world.count = random() end)
        world:on("mix_surfaces", function(told)
            told.friction = (time.step % 7) / 7 + random() / 10 + time.now / 100
        end)
        world.box:on("before_solve", function(told) told.restitution = random() end))");
    game.play(70);
    for (const int step : {3, 4, 30, 61, 70}) game.check(step);
}

TEST_CASE("undo in the past has the edits made up to then") {
    Playing game("world.ball = Body { position = vec(0, 10), Circle {} }");
    game.play(20);
    game.console("world.ball.mass = 7");
    game.play(20);
    game.console("world.ball:delete()");
    game.play(20);
    game.time().go_to(30);
    REQUIRE(game.tree.history().size() == 1);
    REQUIRE(game.tree.undo().done);
    REQUIRE(game.get("world.ball.mass").number() != 7);
    game.time().go_to(60);
    REQUIRE(game.tree.history().size() == 2);
    REQUIRE(game.tree.undo().done);
    REQUIRE(game.get("world.ball.mass").number() == 7);
}

TEST_CASE("handles of the past are valid there and those of an abandoned timeline never again") {
    Playing game("world.ball = Body { position = vec(0, 10), Circle {} }");
    game.play(30);
    game.console("world.late = Body { Circle {} }");
    const property::Handle late =
        game.tree.child(property::resolve(game.tree, "world").instance, "late");
    game.play(30);
    game.time().go_to(20);
    REQUIRE_FALSE(game.tree.alive(late));
    game.time().go_to(50);
    REQUIRE(game.tree.path(late) == "world.late");
    game.time().go_to(20);
    game.play(20);
    game.console("world.other = Body { Circle {} }");
    game.play(20);
    REQUIRE_FALSE(game.tree.alive(late));
}

TEST_CASE("rewind in a script is done at the end of the step and reported by an event") {
    Playing game(R"(
        world.ball = Body { position = vec(0, 10), Circle {} }
        game:on("restored", function(e) print("restored", e.step, "left", e.left) end)
        done = false
        function step() if time.step == 90 and not done then done = true; rewind(0.5) end end
    )");
    game.play(100);
    REQUIRE(game.printed == std::vector<std::string>{"restored\t60\tleft\t90"});
    REQUIRE(game.services.clock.step == 70);
    game.check(65);
}

TEST_CASE("snapshot and restore in scripts are done at the next barrier between steps") {
    Playing game(R"(
        world.ball = Body { position = vec(0, 10), Circle {} }
        done = false
        function step()
            if time.step == 20 then before = snapshot() end
            if time.step == 50 and not done then done = true; restore(before) end
        end
    )");
    game.play(20);
    const double y = game.get("world.ball.position.y").number();
    game.play(30);
    REQUIRE(game.services.clock.step == 20);
    REQUIRE(game.get("world.ball.position.y").number() == y);
    game.play(40);
    game.check(40);
    game.check(10);
    game.console("print(before)");
}

TEST_CASE("timers have their earlier state in the past") {
    Playing game(R"(
        game.o = Object {}
        game.o.ticks = 0
        every(0.1, function() game.o.ticks = game.o.ticks + 1 end)
        after(1, function() every(0.05, function() game.o.ticks = game.o.ticks + 100 end) end)
    )");
    game.play(120);
    const std::vector<std::uint64_t> first = game.hashes;
    game.check(40);
    game.play(80);  // the timers run again from there
    REQUIRE(game.hashes == first);
}

TEST_CASE("the length and the memory of the timeline are limited") {
    Playing game(busy);
    game.console("time.rewind_limit = 2");
    game.play(400);
    REQUIRE(game.time().newest() - game.time().oldest() <= 120 + 60);
    REQUIRE(game.time().oldest() <= 280);
    REQUIRE(game.get("time.oldest").integer() == game.time().oldest());
    REQUIRE_THROWS_AS(game.time().go_to(10), property::Error);
    game.check(game.time().oldest());
    game.check(399);
    game.time().go_to(400);
    game.console("time.rewind_limit = 0");
    game.play(2);
    REQUIRE(game.time().memory() == 0);
    REQUIRE_THROWS_AS(game.time().go_to(401), property::Error);
}

TEST_CASE("keyframes are thinned before the timeline is shortened") {
    Playing game(R"(
        for i = 1, 400 do world:add(Body { position = vec(i % 20 * 2, i), Circle {} }) end
        world.floor = Body { type = "static", position = vec(0, -1), Box { width = 160, height = 2 } }
        time.rewind_memory = 2
    )");
    game.play(700);
    REQUIRE(game.time().memory() < (std::size_t{4} << 20));
    REQUIRE(game.time().newest() - game.time().oldest() > 300);
    game.check(game.time().oldest());
    game.check(game.time().oldest() + 170);
    game.check(699);
}

TEST_CASE("a step too large for a log is followed by a keyframe") {
    Playing game(R"(
        game.o = Object {}
        game.o.text = ""
        long = ("x"):rep(100000)
        function step()
            if time.step == 50 then
                for i = 1, 400 do game.o.text = long .. i end
            end
        end
    )");
    game.play(49);
    REQUIRE(game.time().oldest() == 0);
    game.play(1);
    REQUIRE(game.time().oldest() == 50);
    game.play(60);
    REQUIRE(game.time().memory() < (std::size_t{16} << 20));
    game.check(50);
    game.check(99);
}

TEST_CASE("a write while the past is shown does not change the present") {
    Playing game(R"(
        game.o = Object {}
        game.o.n = 0.5
        world.ball = Body { position = vec(0, 10), Circle {} }
        function step() game.o.n = game.o.n + 1; world.ball.gravity_scale = random() end
    )");
    game.play(80);
    game.check(30);
    // With the typed function, and not yet reported.
    const property::Handle o = game.tree.child(game.tree.root(), "o");
    const property::Property& n = game.tree.property(o, "n");
    game.tree.set(o, n, property::Value(1000.25));
    game.check(80);
    game.check(30);
    game.play(20);
    game.check(45);
}

TEST_CASE("the steps of a run are counted on when the game goes back") {
    Playing game("world.ball = Body { position = vec(0, 10), Circle {} }");
    std::vector<std::uint64_t> announced;
    game.loop->before_step([&](std::uint64_t n) { announced.push_back(n); });
    const auto frames = [&](int count) {
        for (int i = 0; i < count; ++i) game.loop->frame(1.0 / 60, 100);
    };
    frames(50);
    game.time().go_to(20);
    frames(20);
    REQUIRE(game.services.clock.step == 40);
    REQUIRE(game.loop->steps_made() == 70);
    game.console("time.paused = true");
    frames(5);
    game.console("time.step_once = true");
    frames(1);
    game.console("time.paused = false");
    frames(60);
    REQUIRE(game.loop->steps_made() == 100);
    REQUIRE(game.services.clock.step == 70);
    REQUIRE(announced.size() == 100);
    for (std::size_t i = 0; i < announced.size(); ++i) REQUIRE(announced[i] == i + 1);
}

TEST_CASE("names given after going back are the same as before") {
    constexpr const char* script = R"(
        game.other = World {}
        kept = Body { Circle {} }
        world:add(kept)
        function step(dt)
            local body = Body {}
            world:add(body)
            body:delete()
            local guest = Body { Circle {} }
            world:add(guest)
            guest:move(game.other)
            guest:move(world)
            guest:move(nil)
            kept:add(Circle {})
            kept:children(Circle)[1]:delete()
            pcall(function() kept:move(kept:children(Circle)[1]) end)
        end
    )";
    Playing game(script), other(script);
    game.play(130);
    other.play(130);
    const auto next_name = [](property::Tree& tree, std::string_view path, std::string_view of) {
        const property::Handle made =
            tree.create(tree.class_named(of), property::resolve(tree, path).instance);
        std::string name = tree.path(made);
        tree.destroy(made);
        return name;
    };
    for (const int step : {129, 1, 10, 59, 60, 61, 130}) game.check(step);
    for (const auto& [path, of] : {std::pair("world", "Body"), std::pair("other", "Body"),
                                   std::pair("world.body_1", "Circle")}) {
        const std::string name = next_name(game.tree, path, of);
        CHECK(name == next_name(other.tree, path, of));
        CHECK(name.size() > std::string_view("body_9").size());
    }
}

TEST_CASE("showing the past does not change the reasons of deletions") {
    Playing game(
        "world.a = Body {} gone = world.a "
        "function step() if time.step == 5 then gone:delete() end end");
    game.play(10);
    const std::string ask = "print(select(2, pcall(function() return gone.mass end)))";
    game.runtime->run(ask, "ask");
    game.loop->timeline().review(0, [](std::int64_t) {});
    game.runtime->run(ask, "ask");
    REQUIRE(game.printed.size() == 2);
    CHECK_THAT(game.printed[0], contains("was deleted at step 5 by test:1"));
    CHECK(game.printed[1] == game.printed[0]);
}

TEST_CASE("the oldest step does not depend on the steps at which keyframes were made") {
    const double share = GENERATE(0.0, 1e9);
    CAPTURE(share);
    Playing game("time.rewind_limit = 1.5");
    game.loop->timeline().set_share(share);
    game.play(200);
    CHECK(game.loop->timeline().oldest() == 110);
    CHECK(property::get(game.tree, "time.oldest") == property::Value(110));
    game.loop->timeline().go_to(150);
    game.play(1);
    CHECK(game.loop->timeline().oldest() == 110);
    game.play(9);
    CHECK(game.loop->timeline().oldest() == 110);
}

}  // namespace timeline_test
