// Messages for mistakes that are easily made: texts without quotes, names that are taken, brackets
// in each other.

#include <cstdlib>

#include <fettle/script/syntax.h>

#include "stage.h"

namespace mistakes_test {

using fettle::script::Evaluation;
using stage::Stage;
using stage::starts_with;

TEST_CASE("a text without quotes is shown with quotes where a property takes one of several") {
    Stage s;
    s.run("world.ball = Body {}");
    const auto [code, hint] = GENERATE(table<std::string, std::string>({
        {"world.ball.type = static", "type = \"static\""},
        {"world.ball.type=static", "type = \"static\""},
        {"world.ball.type = Kinematik", "type = \"kinematic\""},
        {"world.b = Body {\n  mass = 2,\n  type = kinematic,\n}", "type = \"kinematic\""},
        {"if world.ball.type == static then end", "\"static\""},
        {"world.ball:watch(static, print)", "\"static\""},
    }));
    INFO(code);
    const std::string expected = "no such name (a text needs quotes: did you mean " + hint + "?)";
    CHECK_THAT(s.fails(code), contains(expected));
    const Evaluation typed = s.runtime->evaluate(code);
    REQUIRE(typed.error);
    CHECK_THAT(typed.error->message, contains(expected));
}

TEST_CASE("a name without quotes that no property takes keeps its hint") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.fails("world.ball.mass = wrold"), contains("(did you mean \"world\"?)"));
    CHECK_THAT(s.fails("world.ball.type = static.x"), contains("type = \"static\""));
    CHECK(s.fails("static()").find("quotes") == std::string::npos);
    CHECK(s.fails("local x = static").find("quotes") == std::string::npos);
    CHECK(s.fails("local x = (static or 0) + 1").find("quotes") == std::string::npos);
    // In a line that has the word very often, only the first places are examined.
    std::string line = "x = static world.ball.type = static";
    CHECK_THAT(s.fails(line), contains("type = \"static\""));
    for (int i = 0; i < 100; ++i) line.insert(0, "x = static ");
    CHECK(s.fails(line).find("quotes") == std::string::npos);
}

TEST_CASE("what beginners type at the console is answered by what they may have meant") {
    Stage s;
    s.run("world.stage = Object {} world.stage.ball = Body {}");
    const auto [typed, hint] = GENERATE(table<std::string, std::string>({
        {"world.stage.ball.position = (5, 3)", "(write vec(x, y))"},
        {"world.stage.ball.mass = 5 kg", "(write the number without its unit)"},
        {"world.stage.ball.mass = 2.5 kg", "(write the number without its unit)"},
        {"world.stage.ball.position.x = 5 m/s", "(write the number without its unit)"},
        {"world.stage.ball.mass 5", "(write world.stage.ball.mass = 5)"},
        {"world:gravity = vec(0, 1)", "(write a.b = value)"},
        {"world.stage.ball.mass is", "(write path is expression)"},
        {"delete world.stage.ball", "(write world.stage.ball:delete())"},
        {"set mass 5", "(write mass = 5)"},
        {"for i = 0; i < 5; i++ do print(i) end", "(write for i = 1, n do ... end)"},
        {"for (i = 0, 5) do print(i) end", "(write for i = 1, n do ... end)"},
        {"for i in 1..5 do print(i) end", "(write for i = 1, n do ... end)"},
        {"print(1..5)", "(write a .. b with blanks)"},
        {"math.sqr(4)", "(did you mean \"sqrt\"?)"},
        {"string.uper('a')", "(did you mean \"upper\"?)"},
        {"world.ball", "(did you mean world.stage.ball?)"},
        {"world.ball.mass = 3", "(did you mean world.stage.ball?)"},
        {"mass * 2", "(did you mean \"world.stage.ball.mass\"?)"},
        {"Gravity", "(did you mean \"world.gravity\"?)"},
        {"raycast_all(vec(), vec(1, 0))", "(did you mean \"world:raycast_all(...)\"?)"},
        {"rewind 5", "(write rewind(5))"},
        {"bind f5 restart()", "(write bind(\"f5\", \"restart()\"))"},
        {"select world.stage.ball", "(write it = world.stage.ball)"},
        {"world.stage.ball.awake = yes", "(write true)"},
        {"world.stage.ball:goto(1)", "(goto is a word of Lua and no name)"},
        {"string.repeat('a', 3)", "(repeat is a word of Lua and no name)"},
        {"sleep(1)", "(write after(seconds, action))"},
        {"cd", "(write it = world.name to select an instance)"},
        {"cd world.stage", "(write it = world.stage)"},
        {"cd ..", "(write it = world.name to select an instance)"},
        {"ls", "(write game to see what is in it)"},
        {"ls world.stage", "(write world.stage to see what is in it)"},
        {"ls -l", "(write game to see what is in it)"},
        {"ls(\"world\")", "(write world to see what is in it)"},
        {"get world.gravity", "(write world.gravity)"},
        {"set world.gravity 0", "(write world.gravity = 0)"},
        {"set world.gravity to 0", "(write world.gravity = 0)"},
        {"world.stage.ball.mass += 1", "(write a = a + b)"},
        {"world.gravity: 0", "(write world.gravity = 0)"},
        {"undo 3", "(write undo(3))"},
        {"redo 2", "(write redo(2))"},
        {"exec setup.lua", "(write exec(\"setup.lua\"))"},
        {"alias heavy world.stage.ball.mass =",
         "(write alias(\"heavy\", \"world.stage.ball.mass =\"))"},
        {"bind F5 = restart()", "(write bind(\"F5\", \"restart()\"))"},
        {"goto world.stage", "(write it = world.stage)"},
        {"goto 100", "(write time:go_to(100))"},
        {"select Body where mass > 3", "(write it = world.name to select an instance)"},
        {"toggle world.stage.ball.awake",
         "(write world.stage.ball.awake = not world.stage.ball.awake)"},
        {"watch world.stage.ball.mass", "(write pin world.stage.ball.mass)"},
        {"break world.stage.ball.mass > 3", "(write break_when world.stage.ball.mass > 3)"},
        {"ab world.stage.ball.mass = 3", "(write ab(\"world.stage.ball.mass\", 3))"},
        {"step 5", "(write time.step_once = true to make one step)"},
        {"stop", "(write time.paused = true)"},
        {"timescale 0.5", "(write time.scale = 0.5)"},
        {"cls", "(write clear)"},
        {"man undo", "(write help undo)"},
        {"? undo", "(write help undo)"},
        {"stat fps", "(write view.show.timings = true)"},
        {"$0", "(write it, the selected instance)"},
        {"say hello", "(write print(\"hello\"))"},
        {"/world/stage", "(write world.stage)"},
        {"world.stage.*", "(write query(\"world.stage.*\"))"},
        {"world.stage.ball*.mass = 3", "(write query(\"world.stage.ball*\"):set(\"mass\", 3))"},
        {"world.stage.ball.tint = #ff8000", "(write \"#ff8000\")"},
        {"world.stage.ball.tint = #008000", "(write a color in quotes, \"#ff8000\")"},
        {"world.stage.ball.tint = rgb(255, 0, 0)", "(write color(r, g, b) with numbers"},
        {"world.stage.ball:parent()", "(write .parent without brackets: it is a property)"},
        {"save", "(write save_game(\"name\"))"},
        {"play", "(write go_on())"},
        {"resume", "(write go_on())"},
    }));
    INFO(typed);
    const Evaluation answer = s.runtime->evaluate(typed);
    REQUIRE(answer.error);
    CHECK_THAT(answer.error->message, contains(hint));
    CHECK(s.runtime->evaluate("local x = 5\nlocal y = x\ny").incomplete);
}

TEST_CASE("a command that makes a variable named like a property says which property it may mean") {
    Stage s;
    s.run("world.stage = Object {} world.stage.ball = Body {} score = 1");
    const auto lines = [&](const std::string& command) {
        const Evaluation answer = s.runtime->evaluate(command);
        REQUIRE(answer.ok);
        return answer.lines;
    };
    CHECK(lines("gravity = 0") ==
          std::vector<std::string>{"gravity is a new variable (did you mean world.gravity?)"});
    CHECK(lines("gravity = 1").empty());  // the variable exists
    CHECK(lines("score = 2").empty());
    CHECK(lines("total = 2").empty());
    s.run("function set() mass = 3 end");
    CHECK(lines("set()").empty());
}

TEST_CASE("a method of other consoles that an instance lacks has a hint") {
    Stage s;
    s.run("game.console = Object {} world.stage = Object {}");
    CHECK_THAT(s.runtime->evaluate("console.log(world.stage)").error->message,
               contains("console.log: no such name (write world.stage)"));
    CHECK_THAT(s.runtime->evaluate("console.clear()").error->message, contains("(write clear)"));
}

TEST_CASE("a pattern of one name that is deeper in the tree has a hint") {
    Stage s;
    s.run("world.stage = Object {} world.stage.brick_1 = Body {}");
    const auto line = [&](const std::string& command) {
        return s.runtime->evaluate(command).lines.at(0);
    };
    CHECK(line("query('brick_*')") ==
          "no instances (write query(\"**.brick_*\") to search all of the tree)");
    CHECK(line("query brick_1") ==
          "no instances (write query(\"**.brick_1\") to search all of the tree)");
    CHECK(line("query('wall_*')") == "no instances");
}

TEST_CASE("a callback that the game does not define is explained") {
    Stage s;
    CHECK_THAT(s.runtime->evaluate("update").lines.at(0), contains("update(dt"));
    CHECK_THAT(s.runtime->evaluate("step").lines.at(0), contains("step(dt"));
    CHECK(s.runtime->evaluate("nil").lines == std::vector<std::string>{"nil"});
    s.run("function step() end");
    CHECK_THAT(s.runtime->evaluate("step").lines.at(0), contains("step(dt"));
}

TEST_CASE("the answer to an instance that is in no tree says how it gets into the world") {
    Stage s;
    CHECK(s.runtime->evaluate("Body {}").lines.back() ==
          "it is in no tree: world:add(_) puts it into the world");
    REQUIRE(s.runtime->evaluate("world:add(_)").ok);
    CHECK(s.runtime->evaluate("world.body_1").lines.back() !=
          "it is in no tree: world:add(_) puts it into the world");
    CHECK(s.runtime->evaluate("game").lines.back() !=
          "it is in no tree: world:add(_) puts it into the world");
}

TEST_CASE("undo and redo take a number of edits") {
    Stage s;
    s.run("world.ball = Body {}");
    for (const char* value : {"2", "3", "4"})
        s.runtime->evaluate(std::string("world.ball.mass = ") + value);
    CHECK(s.runtime->evaluate("undo(2)").lines.size() == 4);
    CHECK(s.runtime->evaluate("world.ball.mass").lines == std::vector<std::string>{"2 kg"});
    CHECK(s.runtime->evaluate("redo(100)").lines.size() == 4);
    CHECK(s.runtime->evaluate("world.ball.mass").lines == std::vector<std::string>{"4 kg"});
    CHECK(s.runtime->evaluate("redo(1)").lines == std::vector<std::string>{"nothing to redo"});
    CHECK_THAT(s.fails("undo(0)"), contains("needs a number of edits"));
    CHECK_THAT(s.fails("undo('all')"), contains("needs a number of edits"));
}

TEST_CASE("a color without quotes is shown with quotes") {
    Stage s;
    s.tree->define(
        {.name = "Lamp", .properties = {{.name = "light", .type = fettle::property::Type::color}}});
    s.run("world.lamp = Lamp {}");
    CHECK_THAT(s.fails("world.lamp.light = red"), contains("did you mean light = \"red\"?"));
    CHECK_THAT(s.fails("world.lamp.light = tomatto"), contains("light = \"tomato\"?"));
    CHECK(s.fails("world.lamp.name = red").find("quotes") == std::string::npos);
}

TEST_CASE("one letter without quotes is a text only beside a property that takes it") {
    Stage s;
    s.tree->define({.name = "Keyed",
                    .properties = {{.name = "key",
                                    .type = fettle::property::Type::text,
                                    .default_value = fettle::property::Value("i"),
                                    .enumerators = {"i", "up"}}}});
    const auto said = GENERATE("print(i)", "local x = 1 if x == i then end", "vec(i, 2)");
    INFO(said);
    CHECK(s.fails(said).find("quotes") == std::string::npos);
    CHECK_THAT(s.fails("local e = { key = 1 } if e.key == i then end"), contains("mean \"i\"?"));
    CHECK_THAT(s.fails("local e = { key = 1 } if e.key ~= i then end"), contains("mean \"i\"?"));
    CHECK_THAT(s.fails("print(up)"), contains("did you mean \"up\"?"));
}

TEST_CASE("names of classes of other engines lead to the classes here") {
    Stage s;
    s.run("world.ball = Body {}");
    const auto [name, here] = GENERATE(table<std::string, std::string>({
        {"HingeJoint", "RevoluteJoint { ... }"},
        {"HingeJoint2D", "RevoluteJoint { ... }"},
        {"PinJoint2D", "RevoluteJoint { ... }"},
        {"PivotJoint", "RevoluteJoint { ... }"},
        {"SliderJoint", "PrismaticJoint { ... }"},
        {"SpringJoint2D", "DistanceJoint { ... }"},
        {"b2WeldJointDef", "WeldJoint { ... }"},
        {"Rigidbody", "Body { ... }"},
        {"RigidBody2D", "Body { ... }"},
        {"CharacterBody2D", "Mover { ... }"},
        {"CircleCollider", "Circle { ... }"},
        {"BoxCollider2D", "Box { ... }"},
        {"cpPolyShape", "Polygon { ... }"},
        {"Sprite2D", "Sprite { ... }"},
        {"Area2D", "Circle { sensor = true } in a body"},
        {"Timer", "after(seconds, action)"},
    }));
    INFO(name);
    const std::string hint = "(write " + here + ")";
    CHECK_THAT(s.fails("world.x = " + name + " {}"), contains(": no such name " + hint));
    CHECK_THAT(s.fails("class(\"A\", \"" + name + "\")"), contains(hint));
    CHECK_THAT(s.console("help(\"" + name + "\")"), contains(hint));
    CHECK_THAT(s.console("query " + name), contains(hint));
}

TEST_CASE("a search that finds nothing knows the classes of other engines") {
    Stage s;
    CHECK_THAT(s.console("find(\"PinJoint2D\")"),
               contains("nothing has \"PinJoint2D\" (write RevoluteJoint { ... })"));
}

TEST_CASE("a name that looks like that of a class here or of a variable keeps its hint") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.fails("x = Boddy {}"), contains("did you mean \"Body\"?"));
    CHECK(s.fails("x = spring").find("Joint") == std::string::npos);
}

TEST_CASE("a child with the name of a property is refused with the reason") {
    Stage s;
    s.run("world.ball = Body {}");
    const std::string said = s.fails("world.gravity = Body {}");
    CHECK_THAT(said, contains("world.gravity: expected a vec2"));
    CHECK_THAT(said, contains("; gravity is a property of World, so a child needs another name"));
    CHECK_THAT(s.fails("Body { mass = Body {} }"),
               contains("; mass is a property of Body, so a child needs another name"));
    for (const fettle::property::Class* of : s.tree->classes())
        for (const fettle::property::Property* property : of->properties()) {
            if (!of->creatable() || property->read_only || property->any_type ||
                property->type == fettle::property::Type::reference ||
                property->type == fettle::property::Type::list)
                continue;
            INFO(of->name() << "." << property->name);
            CHECK_THAT(
                s.fails("local o = " + of->name() + " {} o." + property->name + " = Body {}"),
                contains(" is a property of " + of->name() + ", so a child needs another"));
        }
}

TEST_CASE("a handler that treats the record of its event as the instance gets a hint") {
    Stage s;
    s.run(R"(world.ball = Body {}
        world.ball:on("contact_begin", function(e)
            local _, said = pcall(function() e.velocity = vec(0, 1) end)
            local _, read = pcall(function() return e.mass end)
            local _, gone = pcall(function() e:delete() end)
            e.mine = 3
            print(said, read, gone, e.mine)
        end))");
    const auto ball = s.tree->child(s.world, "ball");
    s.tree->emit(ball, *s.tree->class_of(ball).event("contact_begin"), {s.world, 2.0});
    s.step();
    REQUIRE(s.printed.size() == 1);
    for (const char* name : {"velocity", "mass", "delete"})
        CHECK_THAT(s.printed[0], contains(std::string(name) +
                                          ": no such field; this is the record "
                                          "of the event, and its `instance` has " +
                                          name));
    CHECK(s.printed[0].ends_with("\t3"));
}

TEST_CASE("a function that is assigned to an event is refused with the way to add a handler") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.fails("world.ball.contact_begin = function() end"),
               contains("world.ball.contact_begin: is an event; :on(\"contact_begin\", function)"));
}

TEST_CASE("the error for code that is nested too deeply has its place") {
    const auto nested = [](const std::string& open, const std::string& close) {
        std::string text;
        for (int i = 0; i < 300; ++i) text += open;
        text += open == "{" || open == "do " ? "" : "1";
        for (int i = 0; i < 300; ++i) text += close;
        return text;
    };
    const auto [begin, text, line] =
        GENERATE_REF(table<std::string, std::string, int>({{"x = 1\ny = ", nested("(", ")"), 2},
                                                           {"x = 1\ny = ", nested("{", "}"), 2},
                                                           {"x = 1\n", nested("do ", "end "), 2},
                                                           {"y = ", nested("1 ..", ""), 1},
                                                           {"y = ", nested("(\n", "\n)"), 197}}));
    Stage s;
    s.fails(begin + text);
    const fettle::script::ScriptError error = s.errors.front();
    INFO(error.message);
    CHECK(error.file == "main.lua");
    CHECK(std::abs(error.line - line) <= (line > 2 ? 10 : 0));
    CHECK_THAT(error.message, contains("C stack overflow: too many brackets, blocks"));
    CHECK(error.column > 100 * (line <= 2));
    const Evaluation typed = s.runtime->evaluate(begin + text);
    REQUIRE(typed.error);
    CHECK_THAT(typed.error->message, starts_with("console:") && contains("C stack overflow: too"));
    CHECK_THAT(s.prints("local _, why = load([[" + begin + text + "]], '=text') print(why)"),
               starts_with("text:") && contains("C stack overflow: too"));
    CHECK_THAT(fettle::script::syntax_error(begin + text, "a.lua"),
               starts_with("a.lua:") && contains("C stack overflow"));
}

TEST_CASE("a method of a set that is called with a dot is an error") {
    Stage s;
    s.run("world.a = Object {} all = world:children()");
    for (const char* method : {"delete", "each", "set", "add"})
        for (const char* self : {"world", "'a long text'", "1", "nil", "{ 1, 2 }", "vec(1, 2)",
                                 "print", "coroutine.create(print)"}) {
            const std::string call = std::string("all.") + method + "(" + self + ", 'x', 3)";
            INFO(call);
            CHECK_THAT(s.fails(call), contains(std::string(method) + ": needs a set"));
        }
    CHECK_THAT(s.fails("all.delete()"), contains("needs a set"));
}

}  // namespace mistakes_test
