// Messages for new users: file, line, the problem, and the nearest name.

#include <fettle/property/spelling.h>

#include "stage.h"

namespace messages_test {

using stage::Stage;
using stage::starts_with;

TEST_CASE("errors of library functions name the line and the argument") {
    const auto [call, reported] = GENERATE(table<std::string, std::string>({
        {"ipairs(nil)", "ipairs: needs a list, not nil"},
        {"ipairs(3)", "ipairs: needs a list, not an integer"},
        {"ipairs('abc')", "ipairs: needs a list, not a text"},
        {"ipairs()", "bad argument #1 to 'ipairs'"},
        {"for i, v in ipairs(items) do end", "ipairs: needs a list, not nil"},
        {"pairs(nil)", "pairs: needs a table, not nil"},
        {"setmetatable(nil, {})", "setmetatable: needs a table, not nil"},
        {"setmetatable({}, 3)", "setmetatable: the second argument is a table or nil"},
        {"string.rep()", "bad argument #1 to 'rep'"},
        {"('x'):rep()", "bad argument #1 to 'rep'"},
        {"('x'):rep({})", "bad argument #1 to 'rep'"},
        {"string.format(nil)", "bad argument #1 to 'format'"},
        {"string.format('%d', 'x')", "bad argument #2 to 'format'"},
        {"string.format('%d')", "bad argument #2 to 'format'"},
        {"string.sub()", "bad argument #1 to 'sub'"},
        {"string.upper(nil)", "bad argument #1 to 'upper'"},
        {"table.concat(nil)", "bad argument #1 to 'concat' (table expected, got nil)"},
        {"table.concat({{}})", "for 'concat'"},
        {"table.concat({1}, {})", "bad argument #2 to 'concat'"},
        {"table.insert(nil, 1)", "bad argument #1 to 'insert' (table expected, got nil)"},
        {"table.insert({}, 5, 1)", "bad argument #2 to 'insert'"},
        {"table.insert({})", "wrong number of arguments to 'insert'"},
        {"table.remove(nil)", "bad argument #1 to 'remove' (table expected, got nil)"},
        {"table.remove({}, 7)", "to 'remove' (position out of bounds)"},
        {"table.unpack(nil)", "bad argument #1 to 'unpack' (table expected, got nil)"},
        {"table.sort(nil)", "bad argument #1 to 'sort' (table expected, got nil)"},
        {"table.sort({ 1, 'x' })", "attempt to compare"},
        {"table.sort({ 3, 1, 2 }, 5)", "bad argument #2 to 'sort'"},
        {"table.move({}, 1, 2)", "bad argument #4 to 'move'"},
        {"math.floor(nil)", "bad argument #1 to 'floor'"},
        {"math.max()", "bad argument #1 to 'max'"},
        {"math.random(2, 1)", "nothing lies between 2 and 1"},
        {"tonumber({}, 10)", "bad argument #1 to 'tonumber'"},
        {"select(0)", "bad argument #1 to 'select'"},
        {"next({}, 'none')", "invalid key to 'next'"},
        {"rawset(nil, 1, 2)", "bad argument #1 to 'rawset'"},
        {"rawset({}, nil, 2)", "index is nil"},
        {"utf8.char(-1)", "bad argument #1 to 'char'"},
        {"os.date('%')", "bad argument #1 to 'date'"},
        {"coroutine.create(3)", "coroutine.create: needs a function, not an integer"},
        {"coroutine.wrap(nil)", "coroutine.create: needs a function, not nil"},
        {"return #nil", "attempt to get length of a nil value"},
        {"local t = {} return t.x + 1", "attempt to perform arithmetic on a nil value (field 'x')"},
        {"local t = {} t.foo()", "attempt to call a nil value (field 'foo')"},
        {"local t t.x = 1", "attempt to index a nil value (local 't')"},
        {"return {} < 1", "attempt to compare"},
        {"return 'a' .. {}", "attempt to concatenate a table value"},
        {"world:watch('mass', 5)", "watch: needs a function, not an integer"},
        {"world:watch('scale')", "watch: needs a function, not a text"},
        {"world:watch(5, print)", "watch: needs the name of a property, not an integer"},
        {"world:on('deleted', 5)", "on: needs a function, not an integer"},
        {"world:on(5, print)", "on: needs the name of an event, not an integer"},
        {"watch(5, print)", "watch: needs a pattern"},
        {"after('x')", "after: needs a time in seconds, not a text"},
        {"after(print, 1)", "after: needs a time in seconds before the rest, not a function"},
        {"after(1)", "after: needs a function, not nil"},
        {"after(1, 'print')", "after: needs a function, not a text"},
        {"every(1, {})", "every: needs a function, not a table"},
        {"formula(5)", "formula: needs a function that returns the value, not an integer"},
        {"edit('x', 5)", "edit: needs a name and a function"},
        {"world:each(5)", "each: needs a function, not an integer"},
        {"world:each('Body', 5)", "each: needs a function, not an integer"},
        {"world:find('Body', 5)", "find: needs a function, not an integer"},
        {"world:children():each(5)", "each: needs a function, not an integer"},
        {"xpcall(print)", "xpcall: the second argument is a function, not nil"},
        {"load(5)", "load: needs a text or a function, not an integer"},
        {"query(5)", "query: needs a pattern"},
        {"require(5)", "require: needs the name of a module, not an integer"},
    }));
    CAPTURE(call);
    Stage s;
    CHECK_THAT(s.fails("items = nil\n\n" + call),
               starts_with("main.lua:3: ") && contains(reported));
    // A caught error has the same text.
    const std::string caught =
        s.prints("local ok, message = pcall(function()\n" + call + "\nend) print(message)");
    CHECK_THAT(caught, starts_with("main.lua:2: ") && contains(reported));
}

TEST_CASE("an error that a script raises without a position has none") {
    Stage s;
    CHECK(
        s.prints("print(pcall(error, 'plain', 0)) print(select(2, pcall(assert, false, 'reason'))) "
                 "print(select(2, pcall(coroutine.wrap(function() error('inside', 0) end))))") ==
        "false\tplain|reason|inside");
}

TEST_CASE("a message about a table with named keys names the same key in every run") {
    Stage s;
    CHECK_THAT(s.fails("world.scale = {zork = 1, yy = 2, b = 3, c = 4, other = 5}"),
               contains("a table with named keys (b)"));
}

TEST_CASE("a message describes a value of a wrong type in words") {
    Stage s;
    CHECK_THAT(s.fails("local o = Object {} world.o = o o:delete() world.scale = o"),
               contains("got an instance that was deleted"));
    CHECK_THAT(s.fails("world.scale = color('#ff0000')"), contains("got color(\"#ff0000\")"));
}

TEST_CASE("a message that quotes a text of a megabyte leaves out its middle") {
    Stage s;
    const std::string call = GENERATE("game:all(s)", "world[s] = Object {}", "world.scale[s] = 1",
                                      "world[s]()", "local _ = vec(1, 2)[s]", "require(s)",
                                      "_G[s].x = 1", "world.gravity = s", "local _ = world:get(s)");
    INFO(call);
    const std::string message = s.fails("local s = string.rep('\\u{e9}', 500000) " + call);
    CHECK(message.size() < 5000);
    CHECK_THAT(message, starts_with("main.lua:1: "));
}

TEST_CASE("an error is reported completely with any bytes in it") {
    Stage s;
    s.fails("local function inner() error('a\\0b') end inner()");
    const auto& error = s.errors.front();
    CHECK(error.message == "main.lua:1: a\\0b");
    CHECK_THAT(error.traceback, contains("in function inner"));
    CHECK_THAT(s.fails("error('\\27[31mred\\7')"), contains("\\27[31mred\\7"));
    CHECK_THAT(s.fails("error('two\\nlines')"), contains("two\nlines"));
    CHECK_THAT(s.fails("world['a\\0b'] = Object {}"),
               contains("world: the name \"a\\0b\" holds a zero byte"));
    CHECK_THAT(s.fails("world['a\\0b'] = 3"), contains("zero byte"));
    CHECK_THAT(s.fails("world.scale = 'a\\0b'"), contains("got text \"a\\000b\""));
    CHECK_THAT(s.fails("local _ = world['a\\0b']"), contains("a\\000b\"]: no such name"));
    CHECK_THAT(s.fails("world:on('deleted\\0x', print)"), contains("no event \"deleted\\0x\""));
    CHECK_THAT(s.fails("class('A\\0B', Object) {}"), contains("A\\0B"));
    CHECK_THAT(s.fails("class('Z', Object) { ['a\\0b'] = 1 }"), contains("a\\0b"));
    CHECK_THAT(s.fails("color('red\\0')"), contains("red\\0"));
    CHECK(s.prints("print('a\\0b', #tostring('a\\0b'), string.format('%s', 'a\\0b') == 'a\\0b')") ==
          std::string("a\0b\t3\ttrue", 10));
}

TEST_CASE("error objects are reported with their own text") {
    Stage s;
    CHECK_THAT(s.fails("error(setmetatable({}, { __tostring = function() return 'out of fuel' end "
                       "}))"),
               contains("main.lua:1: out of fuel"));
    CHECK_THAT(s.fails("error(setmetatable({ code = 3 }, { __tostring = function() error('no') end "
                       "}))"),
               contains("a table: {code = 3}"));
    CHECK_THAT(
        s.fails("error(setmetatable({ code = 3 }, { __tostring = function() return 5 end }))"),
        contains("a table: {code = 3}"));
    CHECK_THAT(s.fails("error(setmetatable({}, { __tostring = function() return ('x'):rep(1e8) end "
                       "}))"),
               contains("main.lua:1: "));
    CHECK_THAT(s.fails("error(42)"), contains("42"));
    CHECK_THAT(s.fails("error()"), contains("main.lua:1: error() was called with nil"));
    CHECK_THAT(s.fails("coroutine.wrap(function() error({ deep = true }) end)()"),
               contains("{deep = true}"));
}

TEST_CASE("names that differ in a number are different names") {
    using fettle::property::near_miss;
    for (const auto& [a, b] :
         std::vector<std::pair<std::string, std::string>>{{"wheel1", "wheel2"},
                                                          {"leg1", "leg2"},
                                                          {"leg1", "leg10"},
                                                          {"color", "color2"},
                                                          {"item_a", "item_b"},
                                                          {"radius_x", "radius_y"},
                                                          {"pointA", "pointB"},
                                                          {"row1x", "row2x"},
                                                          {"level12", "level21"}}) {
        CAPTURE(a, b);
        CHECK_FALSE(near_miss(a, b));
        CHECK_FALSE(near_miss(b, a));
    }
    for (const auto& [a, b] :
         std::vector<std::pair<std::string, std::string>>{{"frictoin", "friction"},
                                                          {"Friction", "friction"},
                                                          {"frictio", "friction"},
                                                          {"frictions", "friction"},
                                                          {"masa", "mass"},
                                                          {"mas5", "mass"},
                                                          {"gravity_scal", "gravity_scale"}}) {
        CAPTURE(a, b);
        CHECK(near_miss(a, b));
    }
}

TEST_CASE("a game may use similar names for its own properties") {
    Stage s;
    s.run(R"lua(
Car = class("Car", Body) { wheel1 = 1, wheel2 = 2, item_a = 1, item_b = 2, live = 1 }
Bus = class("Bus", Car) { wheel3 = 3, wheel12 = 4, item_c = 5, lives = 3 }
local bus = Bus { wheel2 = 7 }
bus.wheel4 = 1
bus.item_d = 1
bus.color2 = color("red")
local o = Object { leg1 = 1 }
o.leg2 = 2
function key_pressed2() end
function Car:contact_begin2() end
assert(bus.wheel3 == 3 and bus.wheel2 == 7 and o.leg2 == 2)
)lua");
    // Slips in the names of declared properties are still refused, in reads and writes.
    CHECK_THAT(s.fails("class('Tram', Body) { frictoin = 1 }"),
               contains("did you mean \"friction\""));
    CHECK_THAT(s.fails("class('Tram', Car) { frictoin = 1 }"),
               contains("did you mean \"friction\""));
    CHECK_THAT(s.fails("Car { frictoin = 1 }"), contains("did you mean \"friction\""));
    CHECK_THAT(s.fails("Car { wheels1 = 1 }"), contains("did you mean \"wheel1\""));
}

TEST_CASE("the error for a class that cannot be defined gives the real reason") {
    Stage s;
    fettle::property::ClassDescriptor shape;
    shape.name = "Shape";
    shape.creatable = false;
    s.tree->define(shape);
    for (const char* name : {"Square", "Disc"}) {
        fettle::property::ClassDescriptor kind;
        kind.name = name;
        kind.base = "Shape";
        s.tree->define(kind);
    }
    fettle::property::ClassDescriptor gauge;
    gauge.name = "Gauge";
    gauge.creatable = false;
    const auto& gauges = s.tree->define(gauge);
    CHECK_THAT(s.fails("Shape {}"),
               contains("Shape: cannot be made; it is what these have in common: Square, Disc"));
    CHECK_THAT(s.fails("World {}"),
               contains("World: cannot be made; the framework makes the one there is, world"));
    CHECK_THAT(s.fails("Gauge {}"),
               contains("Gauge: cannot be made; only the framework makes them"));
    s.tree->create(gauges, s.world);
    s.tree->create(gauges, s.world);
    CHECK_THAT(s.fails("Gauge {}"), contains("only the framework makes them"));
    CHECK_THAT(s.fails("class('Star', Shape)"),
               contains("no class can derive from Shape; it is what these have in common"));
    CHECK_THAT(s.fails("world:clone()"),
               contains("world: cannot be cloned; the framework makes the one"));
}

TEST_CASE("a class without braces is reported with the missing part") {
    Stage s;
    CHECK_THAT(
        s.fails("local A = class('A', Body)\nreturn A.name"),
        contains("main.lua:2: A: is not a class yet; braces with its properties are missing"));
    CHECK_THAT(s.fails("local A = class('A', Body)\nfunction A:step() end"),
               contains("main.lua:2: A: is not a class yet"));
    s.run("A = class('A', Body) {} assert(A.name == 'A')");
}

TEST_CASE("the receiver of notes may replace itself") {
    Stage s;
    auto held = std::make_shared<int>();
    const std::weak_ptr<int> life = held;
    bool lived = false;
    s.runtime->on_note([held = std::move(held), &s, &life, &lived](std::string_view) {
        const std::weak_ptr<int>& watched = life;
        bool& result = lived;
        s.runtime->on_note({});
        result = !watched.expired();
    });
    s.run("local c = Circle {} c.r = 3");
    CHECK(lived);
}

TEST_CASE("a function in a constructor is the handler of an event") {
    Stage s;
    CHECK_THAT(s.fails("Body { contact_begn = function() end }"),
               contains("Body has no event \"contact_begn\" (did you mean \"contact_begin\"?)"));
    CHECK_THAT(s.fails("Body { pressed = function() end }"),
               contains("Body has no event \"pressed\"; it has ready, deleted, contact_begin"));
    CHECK_THAT(s.fails("Body { contact_begin = 5 }"),
               contains("Body.contact_begin: expected a function, which is called at this event, "
                        "got an integer"));
}

TEST_CASE("names from other engines are errors in a constructor of a native class") {
    Stage s;
    CHECK_THAT(s.fails("Body { pos = vec(1, 2) }"),
               contains("Body has no property \"pos\" (did you mean position?)"));
    CHECK_THAT(s.fails("Circle { size = 2 }"), contains("(did you mean radius?)"));
    CHECK_THAT(s.fails("Circle { r = 2 }"), contains("(did you mean radius?)"));
    CHECK_THAT(s.fails("Body { x = 2 }"), contains("(did you mean position = vec(x, y)?)"));
    CHECK_THAT(s.fails("Body { linearVelocity = vec(1, 0) }"),
               contains("(did you mean velocity?)"));
    CHECK_THAT(s.fails("Body { hp = 3 }"), contains("goes into props = { hp = ... }"));
    CHECK_THAT(s.fails("Body { hp = formula(function() return 1 end) }"), contains("props"));
    CHECK_THAT(s.fails("Body { props = 3 }"), contains("Body.props: expected a table"));
    CHECK_THAT(s.fails("Body { props = { 3 } }"), contains("Body.props: a value has no name"));
    CHECK(
        s.prints("local b = Body { props = { hp = 3, twice = formula(function() return 2 end) } } "
                 "print(b.hp, b.twice, b.mass)") == "3\t2\t1.0");
    s.run(
        "Cat = class('Cat', Body) {} local c = Cat { hp = 9, props = { lives = 7 } } "
        "assert(c.hp == 9 and c.lives == 7) local o = Object { size = 3 } assert(o.size == 3) "
        "local b = Body { circle = Circle {} } b.hp = 3 assert(b.hp == 3)");
}

TEST_CASE("an unknown name of a text is an error and not nil") {
    Stage s;
    CHECK_THAT(s.fails("return world.class.name"), contains("a text has no name"));
    CHECK_THAT(s.fails("return ('Ann'):uper()"), contains("(did you mean \"upper\"?)"));
    CHECK_THAT(s.fails("return string.formt"), contains("(did you mean \"format\"?)"));
    CHECK_THAT(s.fails("return ('Ann')[1]"), contains("text:sub(1, 1) is its first letter"));
    CHECK_THAT(s.fails("setmetatable(string, nil)"), contains("protected metatable"));
    s.run(
        "assert(rawget(string, 'trim') == nil and getmetatable(string) == 'string') "
        "function string.trim(text) return text:match('^%s*(.-)%s*$') end "
        "assert((' Ann '):trim() == 'Ann' and ('Ann'):len() == 3)");
}

TEST_CASE("names from other engines are explained once and change nothing") {
    Stage s;
    std::vector<std::string> notes;
    s.runtime->on_note([&](std::string_view note) { notes.emplace_back(note); });
    s.run(R"lua(
for i = 1, 3 do
    local c = Circle { props = { r = 3 } }
    assert(c.r == 3 and c.radius == 0.5)
end
local b = Body { Circle {} }
b.linearVelocity = vec(1, 0)
b.radius = 2
b.rotation = 1 b.texture = "brick.png" b.hp = 5 b.x = 3
local o = Object { x = 3, size = 2, r = 1 }
)lua");
    REQUIRE(notes.size() == 4);
    CHECK(notes[0] ==
          "main.lua:3: Circle has no property \"r\", so it was added to this one and "
          "changes nothing (did you mean radius?)");
    CHECK_THAT(notes[1], contains("\"linearVelocity\"") && contains("(did you mean velocity?)"));
    CHECK_THAT(notes[2], contains("\"radius\"") && contains("; its Circle has radius"));
    CHECK_THAT(notes[3], contains("\"x\"") && contains("(did you mean position = vec(x, y)?)"));
    notes.clear();
    s.run("Ball = class('Ball', Body) { speed = 3 } local b = Ball { pos = vec(1, 2) } b.pos = 3");
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], contains("Body has no property \"pos\""));
    CHECK_THAT(s.console("world.late = Body { Circle {} } world.late.isKinematic = true"),
               contains("(did you mean type = \"kinematic\"?)"));
    CHECK_THAT(s.fails("local _ = (Body {}).rotation"), contains("no such name"));
}

TEST_CASE("help for a path without target names the missing part") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK_THAT(s.prints("help('world.ball.mas')"),
               contains("world.ball has no property \"mas\" (did you mean \"mass\"?)"));
    CHECK_THAT(s.prints("help('some. text')"), contains("a text"));
    CHECK_THAT(s.prints("help('Bdy')"), contains("Bdy: no such name (did you mean \"Body\"?)"));
    s.run("Enemy = class('Enemy', Body) {} function Enemy:hurt(n) end world.en = Enemy {}");
    CHECK_THAT(s.prints("help('world.en.hurt')"), contains(":hurt(...)"));
}

TEST_CASE("members that a class cannot have are reported and not ignored") {
    Stage s;
    CHECK_THAT(s.fails("class('A', Body) { Circle {} }"), contains("A: [1] has no name"));
    CHECK_THAT(
        s.fails("class('B', Body) { lives = 3, doc = { livse = 'x' } }"),
        contains("B.doc: the class declares no property \"livse\" (did you mean \"lives\"?)"));
    CHECK_THAT(s.fails("class('C', Body) { doc = 5 }"), contains("doc: expected a text"));
    s.run("D = class('D', Body) {}");
    for (const char* name : {"delete", "move", "alive", "clone"}) {
        CAPTURE(name);
        CHECK_THAT(s.fails(std::string("function D:") + name + "() end"),
                   contains("is a method of every instance"));
    }
}

TEST_CASE("an error about a name in scene says where the current scene is") {
    Stage s;
    CHECK_THAT(s.fails("print(scene.enemy)"),
               contains("scene.enemy: scene has load and save") && contains("is game.scene"));
    // A path is printed without "game", and can be typed so.
    s.run("game.scene = Body { mass = 3, Body { name = 'hero' } }");
    CHECK(s.console("scene.hero.mass = 4") == "scene.hero.mass: 1 → 4 kg");
    CHECK(s.console("scene.hero.mass") == "4 kg");
    CHECK(s.console("scene.mass = 5") == "scene.mass: 3 → 5 kg");
    CHECK(s.get("scene.mass") == stage::Value(5.0));
    CHECK_THAT(s.console("scene.hero.mass is scene.mass + 1"), contains("= 6"));
    CHECK(s.runtime->complete("scene.hero.mas", 14).at(0).text == "mass");
    CHECK_THAT(s.fails("print(scene.enemy)"), contains("scene.enemy: scene has load and save"));
    CHECK(s.prints("print(type(scene.load))") == "function");
    s.run("scene.mine = 7");
    CHECK(s.prints("print(scene.mine)") == "7");
}

TEST_CASE("a formula cannot hide a method of every instance") {
    Stage s;
    CHECK_THAT(s.fails("Body { props = { on = formula(function() return 1 end) } }"),
               contains("Body.on: is a method and cannot be assigned"));
    CHECK_THAT(s.fails("Object { on = formula(function() return 1 end) }"),
               contains("Object.on: is a method and cannot be assigned"));
    CHECK_THAT(s.fails("class('Lamp', Object) { on = false }"),
               contains("Lamp.on: is a method of every instance; a property needs another name"));
}

TEST_CASE("a formula in error affects only its own line of a listing") {
    Stage s;
    s.run(
        "world.b = Body {} world.c = Body {} world.b.mass = formula(function() "
        "error('boo') end)");
    const std::string listing = s.console("world.b");
    CHECK_THAT(listing, contains("mass") && contains("in error"));
    CHECK_THAT(listing, contains("velocity"));
    CHECK(s.prints("local n = 0 for path in pairs(query('world.*.mass')) do n = n + 1 end "
                   "print(n)") == "1");
}

TEST_CASE("a random number between very large bounds is finite") {
    Stage s;
    CHECK(s.prints("print(random(-1e308, 1e308) < math.huge)") == "true");
}

TEST_CASE("a formula cannot be a default of a class") {
    Stage s;
    const std::string reason = "a formula is not a default";
    CHECK_THAT(s.fails("class('F1', Body) { n = formula(function() return 1 end) }"),
               contains("F1.n: " + reason) && contains("function F1:ready()"));
    CHECK_THAT(s.fails("class('F2', Body) { mass = formula(function() return 1 end) }"),
               contains("F2.mass: " + reason));
}

TEST_CASE("a path contains no control characters") {
    Stage s;
    const std::string name = "\\27[31mred\\n1\\127\\194\\133\\226\\128\\174";
    s.run("world:add(Body {}, \"" + name + "\")");
    const std::string path = s.prints("print(world:children()[1])");
    CHECK(path == "world[\"\\027[31mred\\0101\\127\\194\\133\\226\\128\\174\"]");
    // The escaped path is read back as the same instance.
    CHECK(s.prints("print(#query([=[" + path + "]=]))") == "1");
    CHECK(s.get(path + ".mass").as_double() == 1);
    CHECK(s.prints("print(" + path + ".name == \"" + name + "\")") == "true");
}

TEST_CASE("messages have the right article before a noun") {
    Stage s;
    s.run("Actor = class('Actor', Body) {} world.ball = Body {}");
    CHECK_THAT(s.fails("formula(Actor {})"), contains("not an Actor"));
    CHECK_THAT(s.fails("world.ball = 3"), contains("is a child of class Body"));
    using fettle::property::with_article;
    CHECK(with_article("Action") == "an Action");
    CHECK(with_article("Body") == "a Body");
    CHECK(with_article("integer") == "an integer");
    CHECK(with_article("Unit") == "a Unit");
    CHECK(with_article("Umbrella") == "an Umbrella");
    CHECK(with_article("") == "a ");
}

TEST_CASE("a value that no property can have is described by its type") {
    Stage s;
    CHECK_THAT(s.fails("game.x = { formula(function() return 1 end) }"),
               contains("game.x: a formula is not a value of a property"));
    CHECK_THAT(s.fails("game.x = snapshot()"), contains("a snapshot is not a value"));
    CHECK_THAT(s.fails("game.x = watch('game.z', print)"), contains("a connection is not a value"));
}

TEST_CASE("an error in a library is reported at the line of the script that called it") {
    Stage s;
    s.runtime->add_library("tools", "function half(b)\n    b.mass = b.wight / 2\nend\n");
    const std::string message = s.fails("\nworld.ball = Body {}\nhalf(world.ball)");
    CHECK_THAT(message, starts_with("main.lua:3: world.ball.wight"));
    CHECK_THAT(message, !contains("tools"));
}

TEST_CASE("writing a property of a set names the function that writes it") {
    Stage s;
    s.run("world.ball = Body {} world.box = Body {}");
    CHECK_THAT(s.fails("world:find(Body).mass = 7"),
               contains("a set of instances has no mass (write :set(\"mass\", value) for all"));
    s.run("world:find(Body):set('mass', 7)");
    CHECK(s.get("world.box.mass").number() == 7);
    // It is a list still.
    CHECK(s.prints("local all = world:find(Body) all[#all + 1] = world.box all[1] = nil "
                   "print(all[3] == world.box)") == "true");
}

TEST_CASE("the path of a part that a value does not have has no writer") {
    Stage s;
    s.run("world.ball = Body { mass = 2 }");
    CHECK_THAT(s.console("who('world.ball.mass.x')"), starts_with("error: "));
    CHECK_THAT(s.console("who('world.ball.velocity.x')"), contains("world.ball.velocity: "));
}

}  // namespace messages_test
