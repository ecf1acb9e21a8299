// The files of a game change while it runs: numbers, instances, classes, handlers, errors.

#include "reloaded_game.h"

namespace reload_test {

using reloaded_game::Game;
using stage::Stage;
using stage::Value;
using stage::Vec2;

TEST_CASE("a number that changed in the file changes the living instance and nothing else") {
    Game game("world.ball = Body { mass = 2, number = 5 }");
    game.run("world.ball.number = 50; world.ball.title = 'played'; kept = world.ball");
    CHECK(game.change("world.ball = Body { mass = 3, number = 5 }").empty());
    CHECK(game.number("world.ball.mass") == 3);
    CHECK(game.number("world.ball.number") == 50);
    CHECK(game.get("world.ball.title") == Value("played"));
    CHECK(game.prints("print(kept == world.ball, kept:alive())") == "true\ttrue");
    CHECK(game.change("world.ball = Body { mass = 3, number = 6 }").empty());
    CHECK(game.number("world.ball.number") == 6);
}

TEST_CASE("a reload reports that start has changed and is not called again") {
    const auto code = [](const std::string& above, const std::string& gravity) {
        return above + "function start() print('start') world.size = " + gravity + " end";
    };
    Game game("world.size = 0 " + code("", "-10"));
    const auto notes = [&](const std::string& text) {
        game.write("main.lua", text);
        return game.runtime->reload({"main.lua"}).notes;
    };
    CHECK(notes("world.size = 0 " + code("local x = 1\n", "-10")).empty());
    const std::vector<std::string> reported = notes("world.size = 0 " + code("", "-2"));
    REQUIRE(reported.size() == 1);
    CHECK_THAT(reported[0], contains("start() has changed"));
    CHECK(stage::joined(game.printed) == "start");
    CHECK(notes("world.size = 0 " + code("", "-2")).empty());
    CHECK(notes("world.size = 0").empty());
}

TEST_CASE(
    "a snapshot from before a reload is restored with the handlers and timers of the new code") {
    const auto code = [](const std::string& age) {
        return "game.a = Object { x = 0 } a:watch('x', function() print('" + age +
               "') end) every(0.1, function() print('" + age + " timer') end)";
    };
    Game game(code("old"));
    game.step(3);
    const auto then = game.tree->snapshot();
    const double now = game.now;
    REQUIRE(game.change(code("new")).empty());
    game.step(30);
    game.tree->restore(then);
    game.now = now;
    game.printed.clear();
    game.run("a.x = 7");
    game.step(12);
    int handlers = 0, timers = 0;
    for (const std::string& line : game.printed) {
        CAPTURE(line);
        CHECK(line.find("old") == std::string::npos);
        handlers += line == "new" ? 1 : 0;
        timers += line == "new timer" ? 1 : 0;
    }
    CHECK(handlers == 1);
    CHECK(timers == 2);
}

TEST_CASE("a value that the file does not give any more is the default again") {
    Game game("world.ball = Body { mass = 2, props = { luck = 7 } }");
    CHECK(game.change("world.ball = Body { }").empty());
    CHECK(game.number("world.ball.mass") == 1);
    CHECK(game.prints("print(world.ball:has('luck'))") == "false");
}

TEST_CASE("loading the same file again changes nothing") {
    const std::string text = R"(
        world.ball = Body { mass = 2, target = world, child = Circle { radius = 1 }, Circle { } }
        for i = 1, 3 do world:add(Body { number = random() }) end
        world.ball.position.x = 3
        world.ball.mass = world.ball.mass * 2
        world.size = 4
        world.size = world.size + 1
        state('score', 0)
    )";
    Game game(text);
    const auto before = game.tree->snapshot();
    const std::string numbers = game.prints("print(world.body_1.number, world.body_3.number)");
    CHECK(game.again().empty());
    CHECK(game.again().empty());
    CHECK(game.tree->children(game.world).size() == 4);
    CHECK(game.number("world.ball.mass") == 4);
    CHECK(game.number("world.size") == 5);
    CHECK(game.prints("print(world.body_1.number, world.body_3.number)") == numbers);
    game.run("world.ball.position = vec(9, 9); world.size = 70");
    CHECK(game.again().empty());
    CHECK(game.get("world.ball.position") == Value(Vec2(9, 9)));
    CHECK(game.number("world.size") == 70);
}

TEST_CASE("new instances are created and those that the file does not make any more are deleted") {
    Game game("world.a = Body { } world.b = Body { Circle { } } world.c = Body { }");
    game.run("world.played = Body { }");
    CHECK(game.change("world.a = Body { } world.d = Body { Circle { } } "
                      "world.b = Body { Circle { }, Circle { radius = 2 } }")
              .empty());
    CHECK(
        game.prints("print(world:has('a'), world:has('c'), world:has('d'), world:has('played'))") ==
        "true\tfalse\ttrue\ttrue");
    CHECK(game.number("world.b.circle_2.radius") == 2);
    CHECK(game.change("world.a = Circle { }").empty());
    CHECK(game.prints("print(world.a.class, world:has('b'), world:has('played'))") ==
          "Circle\tfalse\ttrue");
}

TEST_CASE("children and values that the file adds to game itself are compared with the old file") {
    Game game("game:add(Object { n = 1 }, 'sounds') game.menu = Object { n = 1 } game.level = 3");
    game.run("game.sounds.played = true kept = game.menu game.level = 7");
    CHECK(game.change("game:add(Object { n = 2 }, 'sounds') game.menu = Object { n = 1 } "
                      "game.level = 3 game.more = Object { n = 5 }")
              .empty());
    CHECK(game.number("sounds.n") == 2);
    CHECK(game.get("sounds.played").boolean());
    CHECK(game.number("more.n") == 5);
    CHECK(game.number("level") == 7);  // the value in the file has not changed
    game.run("assert(game.menu == kept)");
    CHECK(game.change("game:add(Object { n = 2 }, 'sounds') game.level = 4").empty());
    CHECK(game.number("level") == 4);
    game.run("assert(not kept:alive()) assert(game.sounds.played)");
}

TEST_CASE(
    "an instance that the game deleted stays deleted and one that it renamed gets the changes") {
    Game game("world.a = Body { mass = 2 } world.b = Body { mass = 2 }");
    game.run("world.a = nil; world.b.name = 'c'");
    CHECK(game.change("world.a = Body { mass = 3 } world.b = Body { mass = 3 } "
                      "world.a:on('contact_begin', print) world.a.mass = 4")
              .empty());
    CHECK(game.prints("print(world:has('a'), world:has('b'), world.c.mass)") ==
          "false\tfalse\t3.0");
}

TEST_CASE("references between instances of the file lead to the living ones") {
    Game game("world.a = Body { } world.b = Body { target = world.a }");
    CHECK(game.change("local a = Body { } world.a = a; world.b = Body { } world.b.target = a "
                      "world.c = Body { target = a, number = 1 } "
                      "function who() return a == world.a, world.c.target == world.a, a.class end")
              .empty());
    CHECK(game.prints("print(who())") == "true\ttrue\tBody");
    CHECK(game.prints("print(world.b.target == world.a)") == "true");
    CHECK(game.tree->children(game.world).size() == 3);
}

TEST_CASE("handlers of the top level are replaced and those of callbacks stay") {
    Game game(R"(
        world.size = 1
        local ball = Body { }
        ball:watch('mass', function() print('old') end)
        world.ball = ball
        world:watch('size', function() print('old size') end)
        watch('world.ball.number', function() print('old number') end)
        function start() world.ball:watch('mass', function() print('of start') end) end
    )");
    const std::string poke =
        "world.ball.mass = world.ball.mass + 1; world.size = world.size + 1; "
        "world.ball.number = world.ball.number + 1";
    game.run(poke);
    game.tree->barrier();
    CHECK(stage::joined(game.printed) == "old|of start|old size|old number");
    CHECK(game.change(R"(
        world.size = 1
        local ball = Body { }
        ball:watch('mass', function() print('new') end)
        world.ball = ball
        world:watch('size', function() print('new size') end)
        watch('world.ball.number', function() print('new number') end)
    )")
              .empty());
    game.printed.clear();
    game.run(poke);
    game.tree->barrier();
    CHECK(stage::joined(game.printed) == "of start|new|new size|new number");
}

TEST_CASE("timers of the top level are replaced and keep their time") {
    Game game("every(1, function() print('old') end) after(0.5, function() print('once') end)");
    game.step(45);
    CHECK(stage::joined(game.printed) == "once");
    CHECK(game.change(
                  "every(1, function() print('new') end) after(0.5, function() print('once') end)")
              .empty());
    game.step(20);
    CHECK(stage::joined(game.printed) == "once|new");
    CHECK(game.change("every(0.25, function() print('fast') end)").empty());
    game.printed.clear();
    game.step(60);
    CHECK(stage::joined(game.printed) == "fast|fast|fast|fast");
}

TEST_CASE("a timer of the top level keeps its time at whatever step the file changes") {
    for (int step = 1; step < 30; ++step) {
        CAPTURE(step);
        Game game("every(0.5, function() print('old') end)");
        game.step(step);
        // Another one before it changes nothing.
        CHECK(game.change("after(9, function() end) every(0.5, function() print('new') end)")
                  .empty());
        game.step(29 - step);
        CHECK(game.printed.empty());
        game.step(2);
        CHECK(stage::joined(game.printed) == "new");
    }
}

TEST_CASE("coroutines of the top level begin again and are not doubled") {
    const auto text = [](const std::string& word) {
        return "world:run(function() while true do wait(0.1) print('" + word + "') end end)";
    };
    Game game(text("old"));
    game.step(12);
    CHECK(stage::joined(game.printed) == "old|old");
    CHECK(game.change(text("new")).empty());
    game.printed.clear();
    game.step(12);
    CHECK(stage::joined(game.printed) == "new|new");
}

TEST_CASE("classes get new functions and defaults and properties in place") {
    Game game(R"(
        Ball = class("Ball", Body) { lives = 3, mass = 2, speed = 1 }
        function Ball:say() return 'old' end
        function Ball:gone() end
        Fast = class("Fast", Ball) { turbo = 1 }
        world.a = Ball { }
        world.b = Ball { lives = 7 }
        world.f = Fast { }
    )");
    game.run("world.c = Ball { }; world.d = Ball { lives = 9 }; world.f.turbo = 4; kept = world.a");
    CHECK(game.change(R"(
        Ball = class("Ball", Body) { lives = 5, mass = 4, speed = "quick", shield = 0.5 }
        function Ball:say() return 'new ' .. self.shield end
        Fast = class("Fast", Ball) { turbo = 1, boost = vec(1, 2) }
        world.a = Ball { }
        world.b = Ball { lives = 7 }
        world.f = Fast { }
    )")
              .empty());
    CHECK(game.prints(
              "print(kept:say(), world.a.lives, world.b.lives, world.c.lives, world.d.lives)") ==
          "new 0.5\t5\t7\t5\t9");
    CHECK(game.prints(
              "print(world.a.mass, world.c.mass, world.f.turbo, world.f.boost, world.f.shield)") ==
          "4.0\t4.0\t4\tvec(1, 2)\t0.5");
    CHECK(game.prints("world.a.speed = 'slow' print(world.a.speed, world.c.speed)") ==
          "slow\tquick");
    CHECK_THAT(game.fails("world.a:gone()"), contains("no such name"));
    CHECK(
        game.prints("local x = Fast { shield = 2, turbo = 3 } print(x.shield, x.turbo, x.boost)") ==
        "2.0\t3\tvec(1, 2)");
    const auto now = game.tree->snapshot();
    game.run("world.a.shield = 9; world.f.boost = vec(0, 0)");
    game.tree->restore(now);
    CHECK(game.number("world.a.shield") == 0.5);
    CHECK(game.get("world.f.boost") == Value(Vec2(1, 2)));
}

TEST_CASE("a snapshot from before a class changed is restored with the new properties") {
    Game game("Ball = class('Ball', Body) { lives = 3 } world.a = Ball { lives = 4 }");
    const auto before = game.tree->snapshot();
    CHECK(game.change("Ball = class('Ball', Body) { lives = 3, shield = 2 } world.a = Ball { }")
              .empty());
    game.tree->restore(before);
    CHECK(game.prints("print(world.a.lives, world.a.shield)") == "4\t2");
}

TEST_CASE("a property that a class does not declare any more is gone") {
    Game game("Ball = class('Ball', Body) { lives = 3, speed = 2 } world.a = Ball { speed = 3 }");
    CHECK(game.change("Ball = class('Ball', Body) { lives = 3 } world.a = Ball { }").empty());
    CHECK_THAT(game.fails("print(world.a.speed)"), contains("no such name"));
    CHECK(game.change("Ball = class('Ball', Body) { lives = 3, speed = 6 } world.a = Ball { }")
              .empty());
    CHECK(game.prints("print(world.a.speed)") == "6");
}

TEST_CASE("a file in error changes nothing and the game goes on as it was") {
    const std::string text = R"(
        Ball = class("Ball", Body) { lives = 3 }
        function Ball:say() return 'old' end
        world.ball = Ball { mass = 2 }
        world.ball:watch('mass', function() print('old handler') end)
        every(1, function() print('tick') end)
        function who() return 'old' end
        score = 1
    )";
    Game game(text);
    game.run("score = 5; played = 1");
    const std::string message = GENERATE(
        "world.ball = Ball { mass = = 3 }", "world.ball = Ball { mass = 7 } error('broken')",
        "Ball = class('Ball', Body) { lives = 'many', more = 1 } function Ball:say() return 'new' "
        "end "
        "world.other = Ball { } world.ball = Ball { mass = 9 } world.size = 77 score = 2 who = nil "
        "world.ball:watch('mass', function() print('new handler') end) "
        "every(0.1, function() print('new tick') end) world.ball.frictoin = 1");
    CAPTURE(message);
    CHECK_FALSE(game.change(message).empty());
    CHECK(game.prints(
              "print(world.ball.mass, world.ball:say(), who(), score, played, world.ball.lives)") ==
          "2.0\told\told\t5\t1\t3");
    CHECK(game.prints("print(world:has('other'), world:has('size'))") == "false\tfalse");
    CHECK(game.tree->size() == 3);
    game.printed.clear();
    game.run("world.ball.mass = 3");
    game.step(61);
    CHECK(stage::joined(game.printed) == "old handler|tick");
    CHECK(game.change(text).empty());
    CHECK(game.prints("print(world.ball.mass, who(), score)") == "3.0\told\t1");
}

TEST_CASE("modules are loaded again with the game") {
    Stage s;
    const TemporaryFolder folder;
    const auto write = [&](const char* name, const char* text) {
        std::ofstream(folder.path / name) << text;
    };
    write("part.lua",
          "local part = {} function part.make() world.ball = Body { mass = 2 } end return part");
    write("main.lua", "local part = require('part') part.make()");
    REQUIRE(s.runtime->load(folder.path));
    write("part.lua",
          "local part = {} function part.make() world.ball = Body { mass = 5 } end return part");
    CHECK(s.runtime->reload({"part.lua"}).done);
    CHECK(s.get("world.ball.mass").as_double() == 5);
    write("part.lua", "local part = {}\nerror('broken part')");
    const auto failed = s.runtime->reload({"part.lua"});
    REQUIRE(failed.error);
    CHECK(failed.error->message == "part.lua:2: broken part");
    CHECK(failed.error->source_line == "error('broken part')");
    std::filesystem::remove(folder.path / "part.lua");
    const auto missing = s.runtime->reload({"part.lua"});
    REQUIRE(missing.error);
    CHECK_THAT(missing.error->message, contains("no module \"part\""));
    CHECK(s.get("world.ball.mass").as_double() == 5);
}

TEST_CASE("globals of the top level begin again and those of callbacks stay") {
    Game game("score = 1; old = 2; function draw() end function start() found = 3 end");
    game.run("score = 10; played = 4");
    CHECK(game.change("score = 1; new = 5").empty());
    CHECK(game.prints("print(score, old, new, found, played, draw)") == "1\tnil\t5\t3\t4\tnil");
}

TEST_CASE("formulas of the top level are the new ones and keep reading living instances") {
    Game game(
        "world.a = Body { } world.b = Body { mass = formula(function() return world.a.mass + 1 "
        "end) }");
    game.run("world.a.mass = 5");
    CHECK(game.number("world.b.mass") == 6);
    CHECK(game.change("local a = Body { } world.a = a "
                      "world.b = Body { mass = formula(function() return a.mass + 10 end) }")
              .empty());
    CHECK(game.number("world.b.mass") == 15);
    game.run("world.a.mass = 6");
    CHECK(game.number("world.b.mass") == 16);
}

TEST_CASE(
    "values that the file gives to instances of the framework are compared with the old file") {
    Game game("world.size = 4 world.luck = 1 world.own = 1");
    game.run("world.luck = 9");
    CHECK(game.change("world.size = 5 world.luck = 1 world.more = 2").empty());
    CHECK(game.prints("print(world.size, world.luck, world.more, world:has('own'))") ==
          "5\t9\t2\tfalse");
    CHECK(game.change("world.luck = 1 world.gravity = vec(0, -5) world.gravity.x = 1").empty());
    CHECK(game.get("world.gravity") == Value(Vec2(1, -5)));
    game.run("world.gravity = vec(7, 7)");
    CHECK(game.change("world.luck = 1 world.gravity = vec(0, -5) world.gravity.x = 1").empty());
    CHECK(game.get("world.gravity") == Value(Vec2(7, 7)));
    CHECK(game.change("world.luck = 1").empty());
    CHECK(game.get("world.gravity") == Value(Vec2(0, -10)));
    CHECK(game.prints("print(world:has('size'))") == "false");
}

TEST_CASE("methods are called for new instances only") {
    Game game("world.a = Body { } world.a:nudge(vec(1, 0))");
    CHECK(game.change("world.a = Body { } world.a:nudge(vec(1, 0)) "
                      "world.b = Body { } world.b:nudge(vec(2, 0))")
              .empty());
    CHECK(game.get("world.a.position") == Value(Vec2(1, 0)));
    CHECK(game.get("world.b.position") == Value(Vec2(2, 0)));
}

TEST_CASE("ready is called for new instances only and reloaded gets the names of the files") {
    Game game(
        "Ball = class('Ball', Body) { } function Ball:ready() print('ready', self.name) end "
        "world.a = Ball { }");
    game.printed.clear();
    CHECK(game.change("Ball = class('Ball', Body) { } function Ball:ready() print('ready', "
                      "self.name) end "
                      "world.a = Ball { } world.b = Ball { } "
                      "function reloaded(files) print('reloaded', files[1]) end")
              .empty());
    CHECK(stage::joined(game.printed) == "ready\tb|reloaded\tmain.lua");
}

TEST_CASE("a class with another base needs a restart and says so") {
    Game game("Ball = class('Ball', Body) { } world.a = Ball { }");
    CHECK_THAT(game.change("Ball = class('Ball', Circle) { } world.a = Ball { }"),
               contains("another base"));
    CHECK(game.prints("print(world.a:is_a(Body))") == "true");
}

TEST_CASE("a game cannot be loaded again while its script runs or before it is loaded") {
    Stage s;
    CHECK_THROWS_WITH(s.runtime->reload({}), contains("only when one is loaded"));
}

TEST_CASE("events of a class are declared again in place and keep their handlers") {
    const auto code = [](const std::string& events) {
        return "Foe = class('Foe', Object) { events = { " + events +
               " } } world.ogre = Foe { } told = 0";
    };
    Game game(code("hit = { damage = 1 }"));
    game.run("world.ogre:on('hit', function(event) told = event.damage end)");
    CHECK(game.change(code("hit = { damage = 2, by = '' }, 'died'")).empty());
    game.run("world.ogre:send('hit', { by = 'x' }) world.ogre:send('died')");
    game.step();
    CHECK(game.prints("print(told)") == "2");
    CHECK(game.change(code("'died'")).empty());
    CHECK_THAT(game.fails("world.ogre:send('hit')"), contains("declares no event \"hit\""));
    CHECK(game.change(code("hit = { damage = 7 }")).empty());
    game.run("world.ogre:send('hit')");
    game.step();
    CHECK(game.prints("print(told)") == "7");
    // A file in error changes nothing.
    CHECK_THAT(game.change(code("hit = { damage = 9 }") + " error('no')"), contains("no"));
    game.run("world.ogre:send('hit')");
    game.step();
    CHECK(game.prints("print(told)") == "7");
    CHECK(game.change("Foe = class('Foe', Object) { hit = 3 } world.ogre = Foe { }").empty());
    CHECK(game.number("world.ogre.hit") == 3);
}

}  // namespace reload_test
