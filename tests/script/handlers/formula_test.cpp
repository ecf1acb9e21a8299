// Formulas and history in scripts and in the console.

#include "stage.h"

namespace formula_test {

using stage::Stage;

TEST_CASE("a formula of a script follows its sources") {
    Stage s;
    s.run("world.ball = Body { mass = 2 } world.shadow = Body {}");
    s.run("world.shadow.mass = formula(function() return world.ball.mass * 2 end)");
    CHECK(s.prints("print(world.shadow.mass)") == "4.0");
    CHECK(s.prints("world.ball.mass = 5 print(world.shadow.mass)") == "10.0");
    s.run("world.score = formula(function() return world.shadow.mass + 1 end)");
    CHECK(s.prints("print(world.score, world.shadow:formula('mass') ~= nil, "
                   "world.ball:formula('mass'))") == "11.0\ttrue\tnil");
    s.run("world.shadow.mass = 1");
    CHECK(s.prints("print(world.score, world.shadow:formula('mass'))") == "2.0\tnil");
    s.run("world.third = Body { mass = formula(function() return world.ball.mass end) }");
    CHECK(s.prints("print(world.third.mass)") == "5.0");
}

TEST_CASE("name and parent cannot have a formula") {
    Stage s;
    s.run("world.ball = Body {}");
    for (const std::string name : {"name", "parent"}) {
        INFO(name);
        const std::string reason =
            name + ": cannot have a formula: it is the place of the instance";
        CHECK_THAT(s.fails("world.ball." + name + " = formula(function() return 'a' end)"),
                   contains("world.ball." + reason));
        CHECK_THAT(s.fails("world.b = Body { " + name + " = formula(function() return 1 end) }"),
                   contains(reason));
        CHECK_THAT(s.console("world.ball." + name + " is \"abc\""), contains(reason));
        CHECK_THAT(s.console("undo()"), !contains("error"));
    }
    CHECK_THAT(s.fails("world.ball.class = formula(function() return 'a' end)"),
               contains("world.ball.class is read-only"));
    CHECK_THAT(s.fails("print(world.b)"), contains("no such name"));
    const auto snapshot = s.tree->snapshot();
    s.tree->restore(snapshot);
    CHECK(s.prints("print(world.ball.name)") == "ball");
}

TEST_CASE("a script that replaces a typed formula is named once") {
    Stage s;
    std::vector<std::string> notes;
    s.runtime->on_note([&](std::string_view text) { notes.emplace_back(text); });
    s.run("world.ball = Body { mass = 2 }");
    s.console("world.ball.mass is 1 + 2");
    s.console("world.ball.gravity_scale is 3");
    s.run("for i = 1, 3 do\nworld.ball.mass = i\nend");
    REQUIRE(notes.size() == 1);
    CHECK(notes[0] ==
          "main.lua:2: this line replaces the formula that was typed for "
          "world.ball.mass: is 1 + 2");
    // A person, and a script that replaces a formula of a script, know what they do.
    s.console("world.ball.gravity_scale = 1");
    s.run("world.ball.mass = formula(function() return 3 end) world.ball.mass = 4");
    CHECK(notes.size() == 1);
    s.console("world.ball.mass is 5");
    s.run("world.ball.mass = formula(function() return 3 end)");
    REQUIRE(notes.size() == 2);
    CHECK_THAT(notes[1], contains("main.lua:1: this line replaces the formula"));
}

TEST_CASE("reading a formula in error raises and the formula recovers") {
    Stage s;
    s.run("world.total = formula(function() return world.ball.mass end)");
    CHECK_THAT(s.prints("print(world:problem('total'))"), contains("world.ball: no such name"));
    CHECK_THAT(s.fails("print(world.total)"), contains("world.total is in error"));
    s.run("world.ball = Body { mass = 3 }");
    CHECK(s.prints("print(world.total, world:problem('total'))") == "3.0\tnil");
    s.run("world.ball = nil");
    CHECK_THAT(s.prints("print(world:problem('total'))"), contains("no such name"));
    s.step();
    CHECK(s.errors.empty());
}

TEST_CASE("the message of who reads a formula in error has the hint of its error once") {
    Stage s;
    s.run(
        "world.ball = Body {} "
        "world.total = formula(function() return world.ball:mass() end) "
        "world.twice = formula(function() return 2 * world.total end)");
    const std::string hint = "(write .mass without brackets: it is a property)";
    for (const char* const name : {"total", "twice"}) {
        const std::string message = s.fails("print(world." + std::string(name) + ")");
        INFO(message);
        CHECK(message.find(hint) != std::string::npos);
        CHECK(message.find(hint) == message.rfind(hint));
    }
}

TEST_CASE("further arguments of formula are refused and not ignored") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    CHECK_THAT(s.fails("world.ball:formula('mass', '3 + 4')"),
               contains("takes only the name of a property"));
    CHECK_THAT(s.fails("world.ball.mass = formula(function() return 1 end, 'walk')"),
               contains("takes one function and nothing else"));
    CHECK(s.prints("print(world.ball.mass)") == "2.0");
}

TEST_CASE("a formula may compute and do nothing else") {
    Stage s;
    s.run("world.ball = Body {}");
    s.run("world.a = formula(function() world.ball.mass = 2 return 1 end)");
    CHECK_THAT(s.prints("print(world:problem('a'))"), contains("cannot write"));
    s.run("world.b = formula(function() while true do end end)");
    CHECK_THAT(s.prints("print(world:problem('b'))"), contains("budget"));
    s.run("world.c = formula(function() coroutine.yield() end)");
    CHECK_THAT(s.prints("print(world:problem('c'))"), contains("yield"));
    s.run("world.d = formula(function() return print end)");
    CHECK(s.prints("print(world:problem('d') ~= nil)") == "true");
    CHECK_THAT(s.fails("world.e = formula(3)"), contains("needs a function"));
    CHECK(s.prints("print(world.ball.mass)") == "1.0");
    s.run(
        "co = coroutine.wrap(function() world.f = formula(function() return world.ball.mass end) "
        "return world.f end)");
    CHECK(s.prints("print(co())") == "1.0");
}

TEST_CASE("the console defines formulas and reports a replaced one") {
    Stage s;
    s.run("world.ball = Body { mass = 2 } world.shadow = Body {}");
    CHECK(s.console("world.shadow.mass is world.ball.mass * 2") ==
          "world.shadow.mass: is world.ball.mass * 2 = 4 kg");
    CHECK(s.console("world.ball.mass = 4") == "world.ball.mass: 2 → 4 kg");
    CHECK(s.console("world.shadow.mass") == "8 kg");
    CHECK(s.console("why('world.shadow.mass')") ==
          "world.shadow.mass = 8 kg   is world.ball.mass * 2|  world.ball.mass = 4 kg");
    CHECK(s.console("world.shadow.mass = 3") ==
          "world.shadow.mass: 8 → 3 kg (replaces its formula)");
    CHECK_THAT(s.console("world.shadow.mass is world.nobody.mass"),
               contains("in error") && contains("nobody"));
    CHECK_THAT(s.console("world.shadow.mass is"), contains("error"));
    CHECK_THAT(s.console("ball is 3"), contains("instance.property"));
    s.runtime->set_selected(s.tree->child(s.world, "ball"));
    CHECK_THAT(s.console("it.mass is 7"), contains("world.ball.mass: is 7 = 7 kg"));
}

TEST_CASE("a command of the console is one step of undo") {
    Stage s;
    s.run("world.ball = Body { mass = 2 } world.other = Body {}");
    s.console("world.ball.mass = 5 world.other.mass = 6");
    s.console("world.new = Body { mass = 9, Circle {} }");
    s.console("world.ball = nil");
    CHECK_THAT(s.console("history()"), contains("world.ball = nil"));
    CHECK_THAT(s.console("undo"), contains("undo: world.ball = nil"));
    CHECK(s.console("world.ball.mass") == "5 kg");
    CHECK_THAT(s.console("undo()"), contains("undo: world.new"));
    CHECK(s.console("world:has('new')") == "false");
    s.console("undo");
    CHECK(s.prints("print(world.ball.mass, world.other.mass)") == "2.0\t1.0");
    CHECK(s.console("undo") == "nothing to undo");
    s.console("redo");
    s.console("redo");
    CHECK(s.prints("print(world.ball.mass, world.new.mass)") == "5.0\t9.0");
    CHECK_THAT(s.console("who('world.ball.mass')"), contains("world.ball.mass: "));
    CHECK_THAT(s.console("who('world.ball')"), contains("world.ball.mass: undo"));
    // What a script wrote may have been changed by the simulation since.
    s.run("world.ball.position = vec(3, 4)");
    CHECK_THAT(s.console("who('world.ball.position')"), !contains("later steps"));
    s.step(5);
    CHECK_THAT(s.console("who('world.ball.position')"), contains("; later steps may have"));
    s.console("world.ball.position = vec(5, 6)");
    s.step(5);
    CHECK_THAT(s.console("who('world.ball.position')"), !contains("later steps"));
    {
        const fettle::property::Tree::CauseScope loading(*s.tree, fettle::property::Writer::load);
        s.tree->set(s.tree->child(s.world, "ball"), "position", fettle::property::Vec2(7, 8));
    }
    s.step(5);
    CHECK_THAT(s.console("who('world.ball.position')"),
               contains("load, step") && contains("; later steps may have"));
}

TEST_CASE("the console refuses a formula whose value its property cannot have") {
    Stage s;
    s.run("world.ball = Body { velocity = vec(1, 2) } world.n = 3 world.t = 'text'");
    s.console("world.ball.mass is world.n + 1");
    const std::size_t edits = s.tree->history().size();
    const std::string refused = s.console("world.ball.velocity is world.n");
    INFO(refused);
    // The message is that of the value.
    const std::string said = "world.ball.velocity: expected a vec2 in m/s, got integer 3";
    CHECK(refused.find(said) != std::string::npos);
    CHECK(s.console("world.ball.velocity = 3").find(said) != std::string::npos);
    CHECK(s.console("world.ball.velocity") == "vec(1, 2) m/s");
    CHECK(s.console("world.ball.mass is world.t").find("error") == 0);
    CHECK(s.console("world.ball.mass = formula(function() return world.t end)").find("error") == 0);
    s.step();
    CHECK(s.console("world.ball.mass") == "4 kg");  // the earlier formula is still there
    CHECK(s.tree->history().size() == edits);
    // What fails now, or has no value yet, may have one later.
    CHECK(s.console("world.ball.velocity is nothing_yet and world.n").find("is nothing") !=
          std::string::npos);
    s.console("world.u = vec(3, 4)");
    CHECK(s.console("world.ball.velocity is world.u").find("= vec(3, 4) m/s") != std::string::npos);
}

TEST_CASE("an error that goes through many formulas names the last one and where it began") {
    Stage s;
    s.run(R"(
        for i = 1, 300 do
            local object, before = Object {}, i > 1 and world["o" .. i - 1]
            world:add(object, "o" .. i)
            object.v = 1
            if before then object.v = formula(function() return before.v + 1 end) end
        end
    )");
    CHECK(s.prints("print(world.o300.v)") == "300");
    s.run("world.o1.v = formula(function() error('here it began') end)");
    const std::string broken = s.fails("print(world.o300.v)");
    CHECK_THAT(broken, contains("world.o300.v is in error: world.o1.v is in error: ") &&
                           contains("here it began"));
    CHECK(broken.size() < 200);
    CHECK(s.prints("print(world.o300:problem('v'))").size() < 200);
    s.run("world.o1.v = formula(function() return world.o300.v end)");
    const std::string cycle = s.fails("print(world.o150.v)");
    CHECK_THAT(cycle, contains("it depends on itself, through more than 24 other formulas"));
    CHECK(cycle.size() < 400);
    s.step();
    for (const auto& error : s.errors) CHECK(error.message.size() < 400);
    s.run("world.o1.v = 5");
    CHECK(s.prints("print(world.o300.v)") == "304");
}

TEST_CASE("changes by a script can be undone only within an edit") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    s.run("world.ball.mass = 3");
    s.run("edit('heavier', function() world.ball.mass = 30 world.ball.friction = 0 end)");
    CHECK_THAT(s.fails("edit('broken', function() world.ball.mass = 31 error('stop') end)"),
               contains("stop"));
    s.run("undo()");
    CHECK(s.prints("print(world.ball.mass)") == "30.0");
    s.run("undo()");
    CHECK(s.prints("print(world.ball.mass, world.ball.friction > 0)") == "3.0\ttrue");
}

}  // namespace formula_test
