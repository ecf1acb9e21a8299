// Hints for those who know another language, an older Lua or another engine.

#include "stage.h"

namespace other_languages_test {

using stage::Evaluation;
using stage::Stage;
using stage::starts_with;

TEST_CASE("words of other languages and of older versions of Lua have a hint") {
    const auto [code, hint] = GENERATE(table<std::string, std::string>({
        {"unpack({1})", "unpack: no such name (write table.unpack(list))"},
        {"local _ = null", "null: no such name (write nil)"},
        {"visits = visits or 0", "visits: no such name (write rawget(_G, \"visits\") for a name"},
        {"super.hit(world)", "super: no such name (write Base.name(self, ...)"},
        {"os.getenv('HOME')", "(field 'getenv') (a game reaches its own files only"},
        {"Object.new()", "Object.new: no such name (write Object { ... } to make one)"},
        {"color = 'red' color('blue')",
         "(global 'color') (an assignment has replaced what it was)"},
        {"local _ = 'at ' .. vec(1, 2)", "(write tostring(it) to join it to a text)"},
        {"local function hit(self, other) return other.mass end hit(1)", "whose event.other is"},
        {"sqrt(2)", "(did you mean \"math.sqrt\"?)"},
        {"math.pow(2, 3)", "(field 'pow') (write a ^ b)"},
        {"math.lerp(1, 2, 0.5)", "(field 'lerp') (write a + (b - a) * share)"},
        {"math.sign(2)", "(field 'sign') (write x > 0 and 1 or x < 0 and -1 or 0)"},
        {"table.contains({}, 2)", "(write for index, value in ipairs(list) do ... end)"},
        {"table.find({}, 2)", "(write for index, value in ipairs(list) do ... end)"},
        {"table.shuffle({})", "(write for i = #list, 2, -1 do local j = random(i)"},
        {"get_tree():quit()", "(write quit(), time.paused = true or go_to_scene(\"name\"))"},
        {"if btn(0) then end", "(write input.move, or input.keys.left)"},
        {"randomize()", "(write \"seed\": \"random\" in game.json)"},
        {"game.o = Object { position = vec(0, 0), center = 1 } local _ = game.o.Position",
         "(did you mean \"position\"?)"},
        {"('a,b'):split(',')", "a text has no split (write for part in text:gmatch("},
        {"('ab'):contains('b')", "a text has no contains (write text:find(part, 1, true))"},
        {"local _ = 'a' + 1", "(write .. to join texts)"},
        {"local _ = #world.children", "(write #it:children()"},
        {"world.children[1] = 1", "(field 'children') (write it:children() to call it)"},
        {"saves[1] = 1", "(global 'saves') (write saves() to call it)"},
        {"for b in world:all('Body') do end", "(write for _, each in ipairs(list) do"},
        {"after(1, print):cancel()", "a connection has no cancel (did you mean \"stop\"?)"},
        {"world:destroy()", "world.destroy: no such name (did you mean \"delete\"?)"},
        {"world:getScale()", "world.getScale: no such name (did you mean \"scale\"?)"},
        {"local _ = vec(3, 4).magnitude", "(did you mean \"length\"?)"},
        {"if 1 != 2 then end", "near '!' (write ~= for \"not equal\")"},
        {"x = 1 x += 1", "near '+' (write a = a + b)"},
        {"x = 1 x *= 2", "near '*' (write a = a * b)"},
        {"x = 1 x -= 2", "near '-' (write a = a - b)"},
        {"if x = 1 then end", "near '=' (write == to compare)"},
        {"if true { x = 1 }", "near '{' (write then ... end)"},
        {"while true: x = 1", "near ':' (write do ... end)"},
        {"var y = 1", "near 'y' (write local name = value)"},
        {"x = true && false", "near '&' (write and)"},
        {"x = 1 ≥ 2", "near '≥' (write >=)"},
        {"x = “text”", "near '“text”' (write \" around a text)"},
        {"x = world.球.mass", "near '球' (write [\"球\"]: a name after a dot"},
        {"x = world.naïve", "near 'naïve' (write [\"naïve\"]: a name after a dot"},
        {"// a comment", "(write -- before a comment)"},
        {"x = { 1 2 }", "near '2' (write , between the entries of a table)"},
        {"x = Body { angle = 1 mass = 2 }", "near 'mass' (write , between the entries of a table)"},
        {"print(x y)", "near 'y' (write , between the arguments of a function)"},
        {"pen.circle(vec(0, 0), 1)", "pen: no such name (write function draw(pen) ... end)"},
        {"local b = new Body()", "new: no such name (write Body { ... })"},
    }));
    CAPTURE(code);
    Stage s;
    CHECK_THAT(s.fails("\n" + code), starts_with("main.lua:2: ") && contains(hint));
    const Evaluation typed = s.runtime->evaluate(code);
    REQUIRE(typed.error);
    CHECK_THAT(typed.error->message, contains(hint));
}

TEST_CASE("the error for an unknown event names the classes that have it or its name here") {
    Stage s;
    CHECK_THAT(s.fails("world:on('contact_begin', print)"),
               contains("no event \"contact_begin\"; Body has it"));
    CHECK_THAT(s.fails("tween(world, 'scale', 2, 1):on('done', print)"),
               contains("no event \"done\" (did you mean \"finished\"?)"));
    CHECK_THAT(s.fails("world:on('click', print)"), contains("no event \"click\"; it has "));
    CHECK_THAT(s.fails("Body:on('collided', print)"),
               contains("no event \"collided\" (did you mean \"contact_begin\"?)"));
}

TEST_CASE("an unknown name that a child has names the child's class") {
    Stage s;
    s.run("world.b = Body {}");
    CHECK_THAT(s.fails("local _ = world.mass"),
               contains("world.mass: no such name; its Body has mass"));
}

TEST_CASE("a field of a game that happens to have such a name has no hint for it") {
    Stage s;
    CHECK_THAT(s.fails("local enemy = {} enemy.spawn()"), !contains("write"));
    CHECK_THAT(s.fails("error('attempt to call a nil value (field \\'pow\\')')"),
               !contains("write"));
}

TEST_CASE("is in a file is answered by the formula that a file may contain") {
    Stage s;
    CHECK_THAT(s.fails("world.ball.mass is 3 + 1"),
               contains("(write world.ball.mass = formula(function() return 3 + 1 end))"));
    CHECK_THAT(s.fails("this is not lua"), !contains("write"));
    CHECK_THAT(s.console("world.ball.mass is"), contains("(write path is expression)"));
}

}  // namespace other_languages_test
