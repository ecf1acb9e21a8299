// What a game does by mistake, with the classes of the whole program.

#include <catch.h>

#include "program.h"

namespace usual_mistakes_test {

using namespace program_test;

TEST_CASE("names that other frameworks use lead to the property of the class") {
    const Folder folder;
    const auto [code, hint] = GENERATE(table<std::string, std::string>({
        {"Segment { a = vec(0, 0), b = vec(1, 1) }",
         "Segment has no property \"a\" (did you mean from?)"},
        {"Segment { point_b = vec(0, 0) }", "did you mean to?"},
        {"DistanceJoint { a = world }", "did you mean body_a?"},
        {"Synth { seconds = 1 }", "did you mean decay?"},
        {"Synth { type = 'square' }", "did you mean wave?"},
        {"Chain { loop = true }", "did you mean closed?"},
        {"RevoluteJoint { pivot = vec(0, 0) }", "did you mean anchor_a?"},
        {"Emitter { max_particles = 5 }", "did you mean limit?"},
        {"Body { friction = 1 }", "; its shapes have it, as in Circle { friction = ... }"},
        {"Body { visible = false }", "; its shapes have it, as in Circle { visible = ... }"},
        {"Body { radius = 1 }", "; its shapes have it, as in "},
        {"Tilemap { position = vec(0, 0) }",
         "Tilemap has no property \"position\" (did you mean corner?)"},
        {"Layer { position = vec(0, 0) }",  // drawn_position is a method
         "Layer has no property \"position\"; a property of your own goes into props = "},
        {"Sprite { sheet = 'walk.json' }",
         "got text \"walk.json\"; did you mean image = \"walk.json\"?"},
        {"Sprite { lives = 3 }", "; a property of your own goes into props = { lives = ... }"},
    }));
    INFO(code);
    const Outcome run = run_script(folder, code, 1);
    INFO(run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err, hint));
}

TEST_CASE("a joint of bodies in two worlds is noted") {
    const Folder folder;
    const Outcome run =
        run_script(folder,
                   "world.a = Body { Circle {} } game.other = World {} "
                   "game.other.b = Body { Circle {} } "
                   "world.j = DistanceJoint { body_a = world.a, body_b = game.other.b }",
                   2);
    CHECK(run.status == 0);
    CHECK(contains(run.err, "world.j does nothing: other.b is in another World"));
}

TEST_CASE("load_game in the event that it causes ends with an error") {
    const Folder folder;
    const Outcome run = run_script(folder,
                                   "game:on('restored', function() load_game('x') end) "
                                   "after(0.1, function() save_game('x') end) "
                                   "after(0.3, function() load_game('x') end)",
                                   200);
    CHECK(run.status == 1);
    CHECK(contains(run.err, "load_game: a handler of the event restored calls it"));
}

TEST_CASE("a handler of restored may go back once more") {
    const Folder folder;
    const Outcome run = run_script(folder,
                                   "local n = 0 "
                                   "game:on('restored', function() n = n + 1 "
                                   "if n == 1 then load_game('x') end end) "
                                   "after(0.1, function() save_game('x') end) "
                                   "every(0.3, function() if n < 6 then load_game('x') end end) "
                                   "after(2, function() print(n) quit() end, { pauses = false })",
                                   2000);
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "6"));
}

TEST_CASE("an error about what takes the place of another names this place") {
    const Folder folder;
    folder.write("bad.tmj", "{ no map");
    const Outcome run = run_script(folder,
                                   "world.m = Tilemap {} "
                                   "world.m = Tilemap { map = 'bad.tmj' } print(world.m.name)",
                                   1);
    CHECK(contains(run.err, "world.m.map: "));
    CHECK_FALSE(contains(run.err, "replacing"));
    CHECK(contains(run.out, "m"));
}

TEST_CASE("a test that presses what is held down gets an error") {
    const Folder folder;
    folder.write("main.lua", "");
    folder.write("tests/all.lua", R"lua(
test("click", function(t) input.mouse.left = true; t:click(vec(0, 0)) end)
test("right", function(t) input.mouse.left = true; t:click(vec(0, 0), "right") end)
test("tap", function(t) t:press("space"); t:tap("space") end)
test("hold", function(t) t:press("space"); t:hold("space", 2) end)
)lua");
    const Outcome run = fettle(folder, {"test", (folder / "").string()});
    INFO(run.out);
    CHECK(
        contains(run.out, "tests/all.lua:2: t:click: left is held down already; release it first"));
    CHECK(contains(run.out, "tests/all.lua:4: t:tap: space is held down already"));
    CHECK(contains(run.out, "tests/all.lua:5: t:hold: space is held down already"));
    CHECK(contains(run.out, "4 tests, 3 failed"));
}

TEST_CASE("a body that gets a property of its shapes is noted") {
    const Folder folder;
    const Outcome run = run_script(folder,
                                   "world.b = Body {} world.b.friction = 2 world.b.width = 3 "
                                   "Wide = class('Wide', Body) {} world.w = Wide {} "
                                   "world.w.height = 3",
                                   1);
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.err, "its shapes have it, as in Circle { friction = ... }"));
    CHECK(contains(run.err, "its shapes have it, as in Box { width = ... }"));
    CHECK_FALSE(contains(run.err, "height"));
}

TEST_CASE("an error says what beginners probably meant") {
    const Folder folder;
    const std::string ball = "Ball = class('Ball', Body) { lives = 3 } ";
    const std::string made = " world.b = Ball { Circle {} }";
    const auto [code, hint] = GENERATE_COPY(table<std::string, std::string>({
        {ball + "function Ball:step() lives = lives - 1 end" + made,
         "lives: no such name (did you mean self.lives?)"},
        {ball + "function Ball:hurt() end function Ball:ready() hurt() end" + made,
         "hurt: no such name (did you mean self:hurt(...)?)"},
        {ball +
             "function Ball:boom() self.lives = 0 end "
             "function Ball:ready() after(0, self.boom) end" +
             made,
         "nothing is given as self here: write self:after(...)"},
        {ball + "function Ball.hurt(by) return by + 1 end" + made + " world.b:hurt(2)",
         "define it with a colon, too"},
        {"function step() helper() end\nlocal function helper() end",
         "helper: no such name; line 2 makes it: put that line before"},
        {"world.a = Foe { Circle {} }\nFoe = class('Foe', Body) {}", "; line 2 makes it"},
        {"after(1, print())", "needs a function, not nil (its name without brackets"},
        {"print(world:children()[0].name)", "the first one of a list has the number 1"},
        {"local l, i = { 1 }, 2 print(l[i] + 1)", "the first one of a list has the number 1"},
        {"print('alive: ' .. true)", "(write tostring(it)"},
        {"local x = '3' if x > 3 then end", "(write tonumber(text)"},
        {"local v = vec(3, 4) if v.length > 2 then end", "(write brackets after a function"},
        {"print(vec(1, 2) < vec(3, 4))", "(write a:length() < b:length()"},
        {"print(vec(1, 2) + 3)", "cannot use an integer (write vec(x, y))"},
        {"random({ 1, 2 })", "(write list[random(#list)])"},
        {"print(string.format('%d', 3.5))", "(write %.0f in place of %d"},
        {"world.b = Body (position = vec(1, 2))", "(write Body { key = value } with braces)"},
        {"local l = {} l.push(3)", "(write table.insert(list, value))"},
        {"world:explode(vec(0, 0))", "got 1 (point, radius, impulse, mask?, accept?)"},
        {"camera.x = 5", "(write view)"},
        {"Body { collision_layer = 2 }", "its shapes have it, as in Circle { category = ... }"},
        {"Body { mask = 2 }", "its shapes have it, as in Circle { mask = ... }"},
        {"MouseJoint { hertz = 2 }", "did you mean frequency?"},
        {"Circle { mass = 2 }", "did you mean density?"},
        {"Sprite { anchor = vec(0, 0) }", "did you mean origin?"},
        {"Slider { range = { 0, 1 } }", "did you mean max?"},
        {"world.b = Body {} print(world.b.speed)", "did you mean \"velocity\"?"},
        {"function step() return input.mouse.pressed end", "did you mean \"left\"?"},
        {"print(view:to_world(100, 100))", "takes 1 argument: to_world(pixels) (write vec(x, y))"},
        {"for _, c in ipairs(world.children) do end",
         "needs a list (write brackets after a function, as in world:children()), not a function"},
        {"local t = { a: 1 }", "(write key = value in a table)"},
        {"world.f = Body { type = 'static', Box {} } world.b = Body { Box {} } "
         "world.b:on('contact_begin', function(c) print(c.body) end)",
         "body: no such field (did you mean \"other\"?)"},
        {"class('Foe', Object) { name = 'bob' }", "has it already"},
    }));
    INFO(code);
    const Outcome run = run_script(folder, code, 3);
    INFO(run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err, hint));
}

TEST_CASE("code that does something else than it seems to do is noted once") {
    const Folder folder;
    const auto [code, hint] = GENERATE(table<std::string, std::string>({
        {"world.b = Body { angle = 90, Box {} }",
         "main.lua:1: Body.angle = 90 is in radians; for degrees write deg(90)"},
        {"world.b = Body { Box {} }\nworld.b.angle = -45", "main.lua:2: Body.angle = -45 is in"},
        {"world.b = Body { Box {} } tween(world.b, 'angle', 360, 1)", "Body.angle = 360 is in"},
        {"world.j = RevoluteJoint { lower_angle = -45 }", "RevoluteJoint.lower_angle = -45 is in"},
        {"Ball = class('Ball', Body) { lives = 3 } function Ball:ready() lives = 5 end "
         "world.b = Ball { Circle {} }",
         "lives is a new variable of the whole game and no property (did you mean self.lives?)"},
        {"local n = 0 game.t = Text { text = formula(function() return 'n ' .. n end) } "
         "function step() n = n + 1 end",
         "t.text: its formula reads no property, so it is not computed again: "},
        {"local score = 0 state('score', 10)", "a local variable of the same name hides it"},
    }));
    INFO(code);
    const Outcome run = run_script(folder, code, 3);
    INFO(run.err);
    CHECK(run.status == 0);
    const std::size_t at = run.err.find(hint);
    REQUIRE(at != std::string::npos);
    CHECK(run.err.find(hint, at + 1) == std::string::npos);
}

TEST_CASE("usual code is not noted") {
    const Folder folder;
    const std::string code = GENERATE(
        "world.b = Body { angle = deg(90), Box {} } world.b.angle = 20.5 world.b.angle = 2e4",
        "world.b = Body { Box {} } world.b.angular_velocity = 90 view.height = 90",
        "Ball = class('Ball', Body) { lives = 3 } function Ball:ready() local lives = 5 best = 5 "
        "end world.b = Ball { Circle {} }",
        "local g, t = game, time t.paused = false "
        "game.t = Text { text = formula(function() return 'at ' .. t.now end) }",
        "state('score', 10) local function f() local score = 1 end f()");
    INFO(code);
    const Outcome run = run_script(folder, code, 3);
    CHECK(run.status == 0);
    CHECK(run.err.empty());
}

}  // namespace usual_mistakes_test
