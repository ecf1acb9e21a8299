// What remains of a console command after it has ended: functions with their text, formulas, and
// local variables that end with it.

#include <string>

#include <fettle/script/runtime.h>

#include "catch.h"
#include "stage.h"

namespace typed_commands_test {

using fettle::script::Evaluation;
using stage::Stage;
using stage::starts_with;

TEST_CASE("an error in a handler of a command shows the source of that command") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK(s.console("watch('world.ball.mass', function() error('zip') end)") == "connection");
    CHECK(s.console("watch('world.ball.mass', function()\nerror('zap') end)") == "connection");
    CHECK(s.console("7 * 6") == "42");
    s.run("world.ball.mass = 3");
    s.step();
    REQUIRE(s.errors.size() == 2);
    CHECK_THAT(s.errors[0].message, contains(":1: zip"));
    CHECK_THAT(s.errors[0].source_line, contains("error('zip')"));
    CHECK_THAT(s.errors[1].message, contains(":2: zap"));
    CHECK(s.errors[1].source_line == "error('zap') end)");
    CHECK(s.errors[0].file != s.errors[1].file);
}

TEST_CASE("a function that a command defined has its own text after other commands") {
    Stage s;
    s.run("world.a = Body {} world.b = Body {}");
    CHECK(s.console("f = function() return 3 end") == "");
    CHECK(s.console("world.a.mass = 2 -- function") != "");
    CHECK(s.console("world.b.mass = formula(f)") != "");
    CHECK_THAT(s.console("why('world.b.mass')"), contains("is function() return 3 end"));
}

TEST_CASE("an error of a command itself is at the console") {
    Stage s;
    CHECK_THAT(s.console("f = function() error('x') end"), !contains("error"));
    CHECK_THAT(s.console("error('y')"), starts_with("error: console:1: y"));
    CHECK_THAT(s.console("(function() error('z') end)()"), starts_with("error: console:1: z"));
    CHECK_THAT(s.console("f()"), contains(":1: x") && !contains("console:1"));
}

TEST_CASE("what a command itself writes is written by the console") {
    Stage s;
    s.run("world.ball = Body {}");
    s.console("edit('heavier', function() world.ball.mass = 7 end)");
    CHECK_THAT(s.console("who('world.ball.mass')"), contains("world.ball.mass: console:1"));
}

TEST_CASE("the error of a typed formula names no chunk") {
    Stage s;
    s.run("world.a = Body {} world.ball = Body {}");
    CHECK_THAT(s.console("world.a.mass is 1 + world.ball.mass"), contains("world.a.mass"));
    s.run("world.ball:delete()");
    s.step();
    const std::string why = s.console("why('world.a.mass')");
    CHECK_THAT(why, contains("in error: world.ball: no such name"));
    CHECK_THAT(s.console("world.a.mass is 1 +"), contains("the formula ends too early"));
    CHECK_THAT(s.console("world.a.mass is 1 + )"), contains("console:1: "));
}

TEST_CASE("a formula of a component says how the formula of its property is written") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.console("world.ball.velocity.x is 3"),
               contains("world.ball.velocity.x: a formula is for a whole property (write "
                        "world.ball.velocity is vec(3, ...))"));
    CHECK_THAT(s.console("world.ball.velocity.y is world.ball.mass"),
               contains("is vec(..., world.ball.mass))"));
    CHECK_THAT(s.console("world.ball.color.r is 1"), contains("world.ball.color is color(...)"));
    CHECK_THAT(s.console("world.ball.mass.x is 3"), contains("error: "));
}

TEST_CASE("reading a local variable of an earlier command says that it ended with it") {
    Stage s;
    CHECK(s.console("local a, speed = 3, 4") == "");
    CHECK_THAT(s.console("a"), contains("a: no such name; the local variable ended with its "
                                        "command (write a = ... without local)"));
    CHECK_THAT(s.console("speed * 2"), contains("ended with its command"));
    CHECK_THAT(s.console("b"), !contains("local"));
    CHECK(s.console("a = 5") == "");
    CHECK(s.console("a") == "5");
}

TEST_CASE("a command of several statements prints its last expression") {
    Stage s;
    s.run("world.ball = Body { mass = 7 }");
    CHECK(s.console("local y = 3; y") == "3");
    s.run("world.weight = Body { mass = 2 }");
    CHECK(s.console("local y = 3; world.weight.mass") == "2 kg");
    // A value inside of a block is no result: it ended the loop.
    CHECK_THAT(s.console("for i = 1, 3 do print(i); i end"), contains("syntax error near 'end'"));
    CHECK(s.console("world.ball.mass = 5; world.ball.mass + 1") == "6|world.ball.mass: 7 → 5 kg");
    CHECK(s.console("local t = { 1; 2 }; #t") == "2");
    CHECK(s.console("local text = 'a; b'; text") == "\"a; b\"");
    CHECK(s.runtime->evaluate("for i = 1, 3 do local a = 1; a").incomplete);
}

TEST_CASE("an assignment that changes nothing is no step of undo") {
    Stage s;
    s.run("world.ball = Body { mass = 7 }");
    s.console("world.ball.mass = 5");
    s.console("world.ball.mass = 5");
    s.console("world.ball.number = nil");
    CHECK(s.console("undo()") == "undo: world.ball.mass = 5|  world.ball.mass: 5 → 7 kg");
    CHECK(s.console("undo()") == "nothing to undo");
}

TEST_CASE("a child is listed as it is written behind the path of its parent") {
    Stage s;
    s.run("world['my ball'] = Body {} world.plain = Body {}");
    const std::string all = s.console("world");
    CHECK(all.find("  [\"my ball\"]") != std::string::npos);
    CHECK(all.find("  .plain") != std::string::npos);
}

TEST_CASE("several commands stand on one line although some of them are no Lua") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    CHECK_THAT(s.console("world.ball.mass = 5; undo"), contains("undo: world.ball.mass = 5"));
    CHECK(s.console("world.ball.mass") == "2 kg");
    s.console("redo");
    const std::string both = s.console("undo; redo");
    CHECK_THAT(both, contains("undo: world.ball.mass = 5"));
    CHECK_THAT(both, contains("redo: world.ball.mass = 5"));
    CHECK(s.console("world.ball.mass") == "5 kg");
    CHECK_THAT(s.console("undo\nhistory"), contains("(undone) world.ball.mass = 5"));
    CHECK_THAT(s.console("who world.ball.mass; world.ball.mass"), contains("2 kg"));
    // Each is a step of undo.
    s.console("world.ball.mass is 3 + 1; world.ball.height is 1; undo");
    CHECK(s.console("world.ball.mass") == "4 kg");
    CHECK_THAT(s.console("world.ball.height"), contains("no such name"));
    // Values alone are no statements of Lua.
    CHECK(s.console("world.ball.mass; 1 + 2") == "4 kg|3");
    // An error ends the line; semicolons in texts and blocks separate nothing.
    CHECK_THAT(s.console("undo; world.bal; redo"), contains("world.bal: no such name"));
    CHECK(s.console("print('undo; redo')") == "undo; redo");
    CHECK(s.console("for i = 1, 2 do print(i); print(i + 1) end") == "1|2|2|3");
    CHECK_THAT(s.console("undo; redoo"), contains("redoo"));
    CHECK_THAT(s.console("undo;; ; redo;"), contains("redo: "));
}

}  // namespace typed_commands_test
