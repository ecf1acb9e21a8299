// Timers and coroutines that belong to an instance.

#include <fettle/property/snapshot.h>

#include "stage.h"

namespace owned_timer_test {

using stage::joined;
using stage::Stage;

TEST_CASE("a timer of an instance calls its function with the instance") {
    Stage s;
    s.run(
        "world.ball = Body { mass = 3 } "
        "world.ball:after(0.1, function(self) print('after', self.mass) end) "
        "c = world.ball:every(0.25, function(self) print('every', self.name) end)");
    s.step(30);
    CHECK(stage::joined(s.printed) == "after\t3.0|every\tball|every\tball");
    s.run("c:stop()");
    s.step(60);
    CHECK(s.printed.size() == 3);
}

TEST_CASE("timers of an instance end when it is deleted") {
    Stage s;
    s.run(
        "world.ball = Body {} "
        "a = world.ball:after(0.5, function(self) print('after') end) "
        "b = world.ball:every(0.1, function(self) print('every') end)");
    CHECK(s.prints("print(a:active(), b:active())") == "true\ttrue");
    s.step(7);
    s.printed.clear();
    s.run("world.ball:delete()");
    CHECK(s.prints("print(a:active(), b:active())") == "false\tfalse");
    s.step(60);
    CHECK(s.printed.size() == 1);
    CHECK(s.errors.empty());
}

TEST_CASE("a coroutine of an instance ends where it waits when the instance is deleted") {
    Stage s;
    s.run(
        "world.ball = Body {} "
        "co = world.ball:run(function(self) "
        "  for i = 1, 100 do print(i, self.name) wait(0.1) end end)");
    s.step(15);
    CHECK(stage::joined(s.printed) == "1\tball|2\tball|3\tball");
    CHECK(s.prints("print(coroutine.status(co))") == "suspended");
    s.run("world.ball:delete()");
    s.step(30);
    CHECK(s.printed.size() == 1);
    CHECK(s.errors.empty());
}

TEST_CASE("the function of a timer may wait and ends there when its instance is deleted") {
    Stage s;
    s.run(
        "world.ball = Body {} world.ball:after(0.1, function() print('a') wait(0.1) print('b') "
        "wait(0.1) print('c') end)");
    s.step(14);
    s.run("world.ball:delete()");
    s.step(30);
    CHECK(stage::joined(s.printed) == "a|b");
}

TEST_CASE("an error in a coroutine of an instance goes to the caller or names the instance") {
    Stage s;
    CHECK_THAT(s.fails("world.ball = Body {} world.ball:run(function() error('now') end)"),
               contains("now"));
    s.run("world.ball:run(function() wait(0.1) error('later') end)");
    s.step(10);
    REQUIRE(s.errors.size() == 1);
    CHECK(s.errors[0].context == "coroutine of world.ball");
    CHECK_THAT(s.errors[0].message, contains("later"));
}

TEST_CASE("an error of a function of Fettle has the place where the timer was made") {
    Stage s;
    s.run("world.b = Body {}\nafter(0.1, world.b.delete)\nworld.b:every(0.1, world.b.children)");
    s.step(10);
    REQUIRE_FALSE(s.errors.empty());
    CHECK_THAT(s.errors[0].message, contains("delete: needs an instance, not nil"));
    CHECK(s.errors[0].context == "timer of main.lua:2");
}

TEST_CASE("a timer in real time goes on while no step is made") {
    Stage s;
    s.run(
        "world.ball = Body {} n = 0 "
        "first = after(0.5, function() print('once') wait(0.25) print('waited') end, "
        "{ pauses = false }) "
        "every(0.25, function() n = n + 1 end, { pauses = false }) "
        "world.ball:every(0, function(ball) print(ball.name) ball:delete() end, "
        "{ pauses = false }) "
        "after(0.1, function() print('never') end)");
    CHECK(s.prints("print(first:active())") == "true");
    s.printed.clear();
    s.runtime->advance(0.25);
    CHECK(joined(s.printed) == "ball");
    s.printed.clear();
    s.runtime->advance(0.25);
    CHECK(joined(s.printed) == "once");
    s.runtime->advance(0.25);
    CHECK(joined(s.printed) == "once|waited");
    CHECK(s.prints("print(n, first:active())") == "3\tfalse");
    // A rewind does not change them, and one call a picture is made at most.
    const auto taken = s.tree->snapshot();
    s.tree->restore(taken);
    s.runtime->advance(5);
    CHECK(s.prints("print(n)") == "4");
    CHECK_THAT(s.fails("after(1, print, { pause = false })"),
               contains("after: there is no option \"pause\" (did you mean "
                        "\"pauses\"?)"));
}

TEST_CASE("wrong arguments name the method") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.fails("world.ball:after('x', print)"), contains("after: needs a time in seconds"));
    CHECK_THAT(s.fails("world.ball:every(1e-6, print)"), contains("shorter than 0.0001 s"));
    CHECK_THAT(s.fails("world.ball:run(3)"), contains("run: needs a function"));
    CHECK_THAT(s.fails("world.ball.after(1, print)"), contains("after: needs an instance"));
}

TEST_CASE("timers of a deleted instance are there again after a restore") {
    Stage s;
    s.run("world.ball = Body {} world.ball:every(0.1, function(self) print('tick') end)");
    s.step(7);
    const auto taken = s.tree->snapshot();
    const double then = s.now;
    s.run("world.ball:delete()");
    s.step(20);
    CHECK(s.printed.size() == 1);
    s.tree->restore(taken);
    s.tree->barrier();
    s.now = then;
    s.step(12);
    CHECK(s.printed.size() == 3);
}

}  // namespace owned_timer_test
