// The tree in scripts: names, creation, deletion, values.

#include "stage.h"

#include <fettle/property/snapshot.h>

#include <fstream>

#include "temporary_folder.h"

namespace tree_test {

using stage::Stage;

TEST_CASE("a few lines of Lua make a ball bounce") {
    Stage s;
    s.run(R"lua(
world.floor = Body { type = "static", position = vec(0, -1), Circle { radius = 40 } }
world.ball  = Body { position = vec(0, 8), Circle { radius = 0.5 } }
world.ball:on("contact_begin", function(contact) print(contact.other.name, contact.speed) end)
world.ball:watch("awake", function(new) print(new and "woke" or "asleep") end)
function key_pressed(key) if key == "space" then world.ball.velocity = vec(0, 10) end end
)lua");
    REQUIRE(s.runtime->call("key_pressed", {"space"}));
    CHECK(s.get("world.ball.velocity") == stage::Value(stage::Vec2(0, 10)));
    CHECK(s.get("world.ball.circle.radius") == stage::Value(0.5));
    s.tree->barrier();
    const auto ball = s.tree->child(s.world, "ball");
    const auto floor = s.tree->child(s.world, "floor");
    s.tree->emit(ball, *s.tree->class_of(ball).event("contact_begin"), {floor, 3.5});
    s.run("world.ball.awake = false");
    s.tree->barrier();
    CHECK(stage::joined(s.printed) == "floor\t3.5|asleep");
    CHECK(s.errors.empty());
}

TEST_CASE("every kind of property is read and written") {
    Stage s;
    s.run(R"lua(
b = Body {}
world.b = b
b.mass = 2.5  assert(b.mass == 2.5)
b.friction = 0.1  assert(math.abs(b.friction - 0.1) < 1e-8)
b.position = vec(1, 2)  assert(b.position == vec(1, 2))
b.velocity = vec(0.5, -1)  assert(b.velocity == vec(0.5, -1))
b.type = "static"  assert(b.type == "static")
b.awake = false  assert(b.awake == false)
b.serial = 7  assert(b.serial == 7 and math.type(b.serial) == "integer")
b.serial = 8.0  assert(b.serial == 8 and math.type(b.serial) == "integer")
b.color = color("tomato")  assert(b.color == color("tomato"))
b.title = "x"  assert(b.title == "x")
b.target = b  assert(b.target == b)
b.target = nil  assert(b.target == nil)
b.mass = 3  assert(math.type(b.mass) == "float")
)lua");
}

TEST_CASE("hostile values are stored exactly or refused by every kind of write") {
    Stage s;
    s.run(R"lua(
world.b = Body {}
b = world.b
b.number = -2            assert(b.number == -2 and math.type(b.number) == "float")
b.number = -0.0          assert(1 / b.number == -math.huge)
b.number = math.huge     assert(b.number == math.huge)
b.number = -math.huge    assert(b.number == -math.huge)
b.number = 5e-324        assert(b.number == 5e-324)
assert(not pcall(function() b.number = 0/0 end))
assert(b.number == 5e-324)
assert(not pcall(function() b.number = (1 << 53) + 1 end))
b.counter = math.mininteger  assert(b.counter == math.mininteger)
b.counter = math.maxinteger  assert(b.counter == math.maxinteger)
b.counter = (1 << 53) + 1    assert(b.counter == (1 << 53) + 1)
b.counter = -2               assert(b.counter == -2)
assert(not pcall(function() b.counter = 0/0 end))
assert(not pcall(function() b.counter = math.huge end))
assert(not pcall(function() b.counter = 1e300 end))
b.title = ""                 assert(b.title == "")
b.title = ("long"):rep(100000)  assert(#b.title == 400000)
b.title = "a\0b"             assert(#b.title == 3)
assert(not pcall(function() b.mass = -math.huge end))
b.mass = math.huge           assert(b.mass == math.huge)
b.extra = math.mininteger    assert(b.extra == math.mininteger)
b.extra = (1 << 53) + 1      assert(b.extra == (1 << 53) + 1)
b.extra = -0.0               assert(1 / b.extra == -math.huge)
assert(not pcall(function() b.extra = 0/0 end))
assert(not pcall(function() b.position = vec(0/0, 0) end))
assert(not pcall(function() b.position = vec(math.huge, 0) end))
assert(b.position == vec(0, 0))
)lua");
    for (const char* value : {"-2", "9223372036854775807", "math.mininteger", "-0.0",
                              "(1 << 53) + 1", "\"\"", "math.huge", "5e-324"}) {
        CAPTURE(value);
        CHECK(s.console(std::string("world.b.extra = ") + value).find("error") ==
              std::string::npos);
        CHECK(s.console(std::string("world.b.extra == ") + value) == "true");
    }
    CHECK_THAT(s.console("world.b.extra = 0/0"), contains("error: console:1: world.b.extra"));
    CHECK_THAT(s.console("world.b.number = 0/0"), contains("world.b.number"));
    CHECK(s.console("1 / world.b.number") != "nan");
}

TEST_CASE("an unknown name is an error with the nearest name") {
    Stage s;
    s.run("world.ball = Body {}");
    CHECK(s.fails("print(world.ball.mas)") ==
          "main.lua:1: world.ball.mas: no such name (did you mean \"mass\"?)");
    CHECK_THAT(s.fails("print(world.bal)"), contains("did you mean \"ball\""));
    CHECK_THAT(s.fails("wrold.x = 1"), contains("wrold: no such name (did you mean \"world\"?)"));
    CHECK_THAT(s.fails("Boddy {}"), contains("did you mean \"Body\""));
    CHECK_THAT(s.fails("world.ball:nudg(vec(0,0))"), contains("did you mean \"nudge\""));
    CHECK_THAT(s.fails("world.ball:on('contact_begn', print)"), contains("contact_begin"));
    CHECK_THAT(s.fails("world.ball:watch('frction', print)"), contains("friction"));
    CHECK_THAT(s.fails("return vec(1,2).lenght"), contains("length"));
    CHECK(s.prints("print(world.ball:has('lives'), world.ball:has('mass'), world:has('ball'))") ==
          "false\ttrue\ttrue");
}

TEST_CASE("a new name becomes an ad-hoc property unless it is similar to a declared one") {
    Stage s;
    s.run("world.ball = Body {}; world.ball.lives = 3; world.ball.home = vec(1, 2)");
    CHECK(s.get("world.ball.lives") == stage::Value(3));
    CHECK_THAT(s.fails("world.ball.frictoin = 1"), contains("did you mean \"friction\""));
    CHECK_THAT(s.fails("world.ball.Mass = 1"), contains("did you mean \"mass\""));
    CHECK_THAT(s.fails("world.ball.delete = 1"), contains("is a method"));
    s.run("world.ball.lives = nil; assert(not world.ball:has('lives'))");
    CHECK_THAT(s.fails("print(world.ball.lives)"), contains("no such name"));
    CHECK_THAT(s.fails("world.ball.f = print"), contains("a function is not a value"));
    CHECK_THAT(s.fails("world.ball.f = {x = 1}"), contains("named keys (x)"));
}

TEST_CASE("every name keeps its meaning with any number of names") {
    Stage s;
    s.run(R"(
        class "Crate" { stock = 0, home = vec(0, 0) }
        world.ball, world.box, world.crate = Body { friction = 0.25 }, Body {}, Crate {}
        for round = 1, 3 do
            for i = 1, 700 do
                world.ball["own" .. i] = i * round
                world.box["own" .. i] = -i * round
            end
            for i = 1, 700 do
                assert(world.ball["own" .. i] == i * round)
                assert(world.box["own" .. i] == -i * round)
            end
        end
        for i = 1, 30 do
            world.ball.velocity, world.crate.home = vec(i, -i), vec(-i, i)
            world.ball.friction, world.crate.stock = i / 64, i
            assert(world.ball.velocity == vec(i, -i) and world.crate.home == vec(-i, i))
            assert(world.ball.friction == i / 64 and world.crate.stock == i)
            assert(world.box.velocity == vec(0, 0) and world.ball.type == "dynamic")
            assert(world.ball:has("own700") and world.ball.name == "ball")
        end
    )");
    CHECK(s.console("world.ball.own7 + world.box.own8") == "-3");
    CHECK(s.console("world.ball.friction") == "0.46875");
    CHECK(s.console("world.crate.stock") == "30");
    s.run("world.ball.friction = 0.5 assert(world.ball.friction == 0.5)");
    CHECK_THAT(s.fails("world.ball.friction = '0.5'"), contains("world.ball.friction"));
    CHECK_THAT(s.fails("world.ball[1] = 2"), contains("a name is a text"));
    CHECK_THAT(s.fails("world.ball.nudge = 2"), contains("is a method"));
}

TEST_CASE("assigning nil restores the default") {
    Stage s;
    s.run("world.ball = Body { friction = 0.1 }; world.ball.friction = nil");
    CHECK(s.get("world.ball.friction").as_double() == Approx(0.6));
    s.run("world.bounds = {1, 2}; world.bounds = nil; assert(world.bounds == nil)");
}

TEST_CASE("constructors set the named values and refuse wrong ones") {
    Stage s;
    s.run(R"lua(
world.b = Body { Circle {}, Circle { radius = 2 }, wheel = Circle { radius = 3 }, props = { lives = 3 } }
assert(world.b.circle.radius == 0.5 and world.b.circle_2.radius == 2)
assert(world.b.wheel.radius == 3 and world.b.lives == 3)
Mass = class("Mass", Object) {}
world.heavy = Body { Mass {}, Mass {} }  -- not that of a property
assert(world.heavy.mass == 1 and world.heavy.mass_2 and world.heavy.mass_3)
local added = world:add(Body {})
assert(added.name == "body_1" and world:add(Body {}).name == "body_2")
assert(added.parent == world and added.class == "Body")
)lua");
    CHECK_THAT(s.fails("Body { mass = -2 }"), contains("Body.mass"));
    CHECK_THAT(s.fails("Body { mass = 'heavy' }"), contains("Body.mass"));
    CHECK_THAT(s.fails("Body { frction = 1 }"), contains("friction"));
    CHECK_THAT(s.fails("Body { 3 }"), contains("Body: element 1 is an integer"));
    s.run("class('Sign', Object) { text = '' }");
    CHECK_THAT(s.fails("Sign { 'hello' }"),
               contains("must be an instance (write text = \"hello\")"));
    CHECK_THAT(s.fails("Body { world.b }"), contains("has its place already"));
    CHECK_THAT(s.fails("World {}"), contains("World: cannot be made"));
    CHECK_THAT(s.fails("Body 'x'"), contains("needs a table"));
    const std::size_t before = s.tree->size();
    CHECK_THAT(s.fails("Body { mass = -1 }"), contains("Body.mass"));
    CHECK(s.tree->size() == before);
    // A child in the arguments is as before: detached, and owned by the script.
    CHECK_THAT(s.fails("given = Circle {} Body { given, mass = -1 }"), contains("Body.mass"));
    CHECK(s.tree->size() == before + 1);
    s.run("assert(given.parent == nil) given:delete()");
    CHECK(s.tree->size() == before);
}

TEST_CASE("assigning an instance places it and replaces the instance of that name") {
    Stage s;
    s.run(R"lua(
world.a = Body { mass = 1 }
local old = world.a
world.a = Body { mass = 2 }
assert(world.a.mass == 2 and not old:alive())
world.a.friend = world          -- has its place: a reference
assert(world.a.friend == world)
local c = Circle {}
world.a.wheel = c
assert(c.parent == world.a and tostring(c) == "world.a.wheel")
world.a.wheel = c               -- itself: nothing happens
assert(c:alive())
local seen = {} ; seen[world.a] = true
assert(seen[world.a])
)lua");
    CHECK_THAT(s.fails("world.a = 3"), contains("is a child of class Body"));
    CHECK_THAT(s.fails("world.a = world"), contains("has its place elsewhere"));
    CHECK_THAT(s.fails("local o = Object {}; o.x = o"), contains("below itself"));
    CHECK(s.prints("print(world.a, Body {}, game)") == "world.a\t(detached body)\tgame");
}

TEST_CASE("the error for a deleted instance says who deleted it and when") {
    Stage s;
    s.step(3);
    s.run("world.ball = Body {}; ball = world.ball; world.ball = nil");
    CHECK_THAT(s.fails("print(ball.mass)"), contains("world.ball was deleted at step 3"));
    CHECK_THAT(s.fails("ball.mass = 1"), contains("world.ball was deleted at step 3"));
    CHECK_THAT(s.fails("ball:nudge(vec(1, 1))"), contains("world.ball was deleted"));
    CHECK_THAT(s.fails("ball:delete()"), contains("world.ball was deleted"));
    CHECK_THAT(s.prints("print(tostring(ball), ball:alive())"), contains("was deleted"));
    s.run("world.c = Body {}; world.c:delete(); assert(not world:has('c'))");
    CHECK_THAT(s.fails("game:delete()"), contains("cannot be deleted"));
    CHECK_THAT(s.fails("world.nothing_here.x = 1"), contains("no such name"));
}

TEST_CASE(
    "a variable of a script is not affected by an instance of another saved game with the same "
    "handle") {
    const std::string crate = "Crate = class('Crate') { level = 1.5, home = vec(0, 0) }\n";
    std::vector<std::byte> saved;
    {
        Stage other;
        other.run(crate + "world.x = Body {} world.y = Crate {}");
        saved = other.tree->snapshot().to_bytes();
    }
    Stage s;
    s.run(crate + R"(
        world.x = Crate {}
        world.y = Body {}
        x, y, home, velocity = world.x, world.y, world.x.home, world.y.velocity
        x.level, y.friction = 2, 0.25
    )");
    s.tree->restore(fettle::property::Snapshot::from_bytes(saved));
    CHECK_THAT(s.fails("print(x.level)"), contains("world.x.level: no such name"));
    s.run(R"(
        y.friction = 0.75  -- a crate may have one of its own
        assert(x.friction ~= 0.75 and y.friction == 0.75)
        assert(x == world.x and y == world.y)
        assert(x.type == "dynamic" and y.level == 1.5)
        x.friction, y.level, y.home = 0.5, 3, vec(1, 2)
        assert(world.x.friction == 0.5 and world.y.level == 3 and y.home.y == 2)
        x:nudge(vec(1, 0))
    )");
    CHECK_THAT(s.fails("home.x = 3"), contains("world.x.home: no such name any more"));
    CHECK_THAT(s.fails("velocity.x = 3"), contains("world.y.velocity: no such name any more"));
    CHECK_THAT(s.fails("y:nudge(vec(1, 0))"), contains("nudge"));
}

TEST_CASE(
    "a variable keeps an instance of a class of a script through its deletion and restoration") {
    Stage s;
    s.run(R"(
        Crate = class("Crate") { level = 1.5 }
        function Crate:deleted() saved = self end
        function Crate:raise() self.level = self.level + 1 end
        world.crate = Crate {}
    )");
    s.step();
    s.console("world.crate:delete()");
    s.run("_ = nil collectgarbage() collectgarbage()");
    s.step();
    s.console("undo()");
    s.run(R"(
        assert(saved == world.crate)
        saved:raise()
        saved.level = saved.level * 2
        assert(world.crate.level == 5)
    )");
}

TEST_CASE("a write to a component of a vec writes it back to the property") {
    Stage s;
    s.run(R"lua(
world.b = Body { position = vec(1, 2) }
world.b.position.x = 5
assert(world.b.position == vec(5, 2))
local p = world.b.position
world.b.position = vec(7, 8)
p.y = 9
assert(world.b.position == vec(7, 9) and p == vec(7, 9))
local free = vec(1, 2); free.x = 3; assert(free == vec(3, 2))
local copy = vec(p); copy.x = 100; assert(world.b.position.x == 7)
world.b.color.g = 0.5; assert(world.b.color.g == 0.5)
world.b.home = vec(1, 1); world.b.home.y = 4; assert(world.b.home == vec(1, 4))
)lua");
    CHECK_THAT(s.fails("world.b.position.x = 0/0"), contains("world.b.position"));
    CHECK_THAT(s.fails("world.b.position.z = 1"), contains("x and y"));
    CHECK_THAT(s.fails("local p = world.b.home; world.b.home = nil; p.x = 1"),
               contains("no such name any more"));
}

TEST_CASE("vectors and colors have arithmetic operators") {
    Stage s;
    s.run(R"lua(
assert(vec(1, 2) + vec(3, 4) == vec(4, 6) and vec(1, 2) - vec(3, 4) == vec(-2, -2))
assert(2 * vec(1, 2) == vec(2, 4) and vec(1, 2) * 2 == vec(2, 4) and vec(2, 4) / 2 == vec(1, 2))
assert(-vec(1, -2) == vec(-1, 2) and vec(3, 4):length() == 5)
assert(vec(3, 4):normalized():length() == 1 and vec(0, 0):normalized() == vec(0, 0))
assert(vec(1, 2):dot(vec(3, 4)) == 11 and vec(1, 0):cross(vec(0, 1)) == 1)
assert((vec(1, 0):rotated(deg(90)) - vec(0, 1)):length() < 1e-15)
assert(vec(0, 0):lerp(vec(2, 4), 0.5) == vec(1, 2))
assert(color("#ff8800").r == 1 and color(1, 0, 0) == color("red") and color(0, 0, 0, 0.5).a == 0.5)
assert(vec(1, 2) ~= vec(1, 3) and vec(1, 2) ~= 3)
assert(vec(1, 2):distance(vec(4, 6)) == 5 and vec(-1.5, 2.5):floor() == vec(-2, 2))
assert(vec(-1.6, 2.5):round() == vec(-2, 3) and vec(0.4, -0.4):round() == vec(0, 0))
assert(vec(6, 8):limited(5) == vec(3, 4) and vec(3, 4):limited(7) == vec(3, 4))
assert(vec(0, 0):limited(0) == vec(0, 0) and vec(3, 4):limited(0) == vec(0, 0))
)lua");
    CHECK_THAT(s.fails("return vec(1, 2) + 1"), contains("cannot use an integer"));
    CHECK_THAT(s.fails("return vec(1, 2) * vec(1, 2)"), contains("a:dot(b)"));
    CHECK_THAT(s.fails("return vec(1, 2):limited(-1)"), contains("-1 is not a length"));
    CHECK_THAT(s.fails("return vec(1, 2):distance_to(vec(0, 0))"),
               contains("did you mean \"distance\"?"));
    CHECK_THAT(s.fails("return vec(1, 2):clamped(3)"), contains("did you mean \"limited\"?"));
    CHECK_THAT(s.fails("return color('tomatoe')"), contains("tomato"));
    CHECK(s.prints("print(vec(1, 0.1), color('red'))").find("vec(1, 0.1)") == 0);
}

TEST_CASE("a write to an element of a list writes the whole list") {
    Stage s;
    s.run("world.hull = Polygon {}");
    const auto& polygon = s.module.polygons.front();
    int changes = 0;
    s.tree->watch(s.tree->child(s.world, "hull"), "vertices",
                  [&](const fettle::property::Change&) { ++changes; });
    s.run("world.hull.vertices[2] = vec(2, 0)");
    CHECK(polygon.rebuilds == 1);
    CHECK(polygon.vertices[1] == stage::Vec2(2, 0));
    s.run(R"lua(
local v = world.hull.vertices
v[#v + 1] = vec(1, 1)
assert(#v == 4 and v[4] == vec(1, 1) and v[5] == nil)
v[1].x = -1
assert(world.hull.vertices[1] == vec(-1, 0))
table.insert(v, 2, vec(0, -5))
assert(#v == 5 and v[2] == vec(0, -5))
assert(table.remove(v, 2) == vec(0, -5) and #v == 4)
local n = 0
for i, each in ipairs(v) do n = n + i; assert(each == v[i]) end
for i, each in pairs(v) do n = n + i end
assert(n == 20)
world.hull.vertices = { vec(0, 0), vec(3, 0), vec(0, 3) }
assert(#world.hull.vertices == 3 and world.hull.vertices == v)
)lua");
    CHECK(polygon.rebuilds == 6);
    CHECK_THAT(s.fails("world.hull.vertices[9] = vec(1, 1)"),
               contains("world.hull.vertices[9]: the list has elements 1 to 3; 4 appends"));
    CHECK_THAT(s.fails("world.hull.vertices[2] = 3"), contains("world.hull.vertices"));
    CHECK_THAT(s.fails("world.hull.vertices = {}"), contains("needs three vertices"));
    CHECK_THAT(s.fails("world.hull.vertices.x = 1"),
               contains("is a list with elements 1, 2, 3 ..., and has no element x;"));
    s.tree->barrier();
    CHECK(changes == 1);
}

TEST_CASE("methods convert their arguments and return records") {
    Stage s;
    s.run(R"lua(
world.b = Body {}
world.b:nudge(vec(1, 1), 2)
assert(world.b.position == vec(2, 2))
local hit = world:raycast(vec(0, 0), vec(2, 0))
assert(hit.body == world.b and hit.point == vec(1, 0) and hit.fraction == 0.5 and hit.note == nil)
assert(#world:raycast_all(vec(0, 0), vec(1, 1)) == 1)
)lua");
    CHECK_THAT(s.fails("world.b:nudge()"), contains("nudge"));
    CHECK_THAT(s.fails("world.b:nudge(1)"), contains("nudge"));
    CHECK_THAT(s.fails("world.b:nudge(vec(1, 1), 1, 1)"), contains("nudge(by [, times])"));
    CHECK_THAT(s.fails("world.b.nudge(vec(1, 1))"), contains("colon"));
    CHECK_THAT(s.fails("world:raycast(vec(0, 0), vec(0, 0))"), contains("the ray has no length"));
    CHECK_THAT(s.fails("world.b.nudge(world, vec(1, 1))"), contains("World has no nudge"));
    CHECK_THAT(s.fails("return world:raycast(vec(0, 0), vec(2, 0)).bdy"), contains("body"));
}

TEST_CASE("no child gets the name of a method of every instance") {
    Stage s;
    for (const char* way :
         {"world:add(Object {}, 'children')", "local o = Object {} world:add(o) o.name = 'delete'",
          "local o = Object {} o:move(world, 'find')"})
        CHECK_THAT(s.fails(way), contains("which is a method of every instance"));
    s.run("class('Each', Object) {} world.holder = Object { Each {} }");
    CHECK(s.prints("print(world.holder.each_2)") == "world.holder.each_2");
    for (const char* way :
         {"world:add(Object { name = 'on' })", "Object { Object { name = 'on' } }"})
        CHECK_THAT(s.fails(way), contains("which is a method of every instance"));
    CHECK_THAT(s.fails("Body { Circle { name = 'mass' } }"),
               contains("a child cannot be called \"mass\", which is a property of Body"));
    // A number makes up for the name of another child.
    s.run(
        "local o = Object { Object { name = 'a' }, Object { name = 'a' } } assert(o.a_2.name == "
        "'a_2')");
}

TEST_CASE("the error for a former child of game says whether it was renamed or deleted") {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua")
        << "yard.name = 'arena' print(select(2, pcall(function() return yard end)))\n"
           "arena:delete() print(select(2, pcall(function() return yard end)))";
    Stage s;
    s.run("game.yard = Object {}");
    REQUIRE(s.runtime->load(folder.path));
    REQUIRE(s.printed.size() == 2);
    CHECK_THAT(s.printed[0], contains("yard: no such name any more: its path is \"arena\" now"));
    CHECK_THAT(s.printed[1], contains("yard: no such name any more: it was deleted; game.yard = "
                                      "Object {} makes another one"));
}

TEST_CASE("tables and sets are printed with what is in them") {
    Stage s;
    CHECK(s.prints("print({ 1, 'two', vec(1, 2), { a = true } }, {})") ==
          "{1, \"two\", vec(1, 2), {a = true}}\t{}");
    s.run("world.a = Object {} world.b = Object {}");
    CHECK(s.prints("print(world:children('Object'), tostring(world:find('Object', function() "
                   "return false end)))") == "{world.a, world.b}\t{}");
    CHECK(s.prints("local t = {} t.t = t print(t)") == "{t = {t = {t = {…}}}}");
    CHECK(s.prints("print(setmetatable({}, { __tostring = function() return 'mine' end }))") ==
          "mine");
}

TEST_CASE("sets of instances are filtered and changed together") {
    Stage s;
    s.run(R"lua(
for i = 1, 5 do world:add(Body { mass = i, Circle {} }) end
assert(#world:find("Body", function(b) return b.mass > 3 end) == 2)
assert(#world:all("Circle") == 5 and #world:all() == 10 and #world:children() == 5)
world:all("Body"):set("color", color("red")):add("velocity", vec(0, 1)):add("mass", 1)
assert(world.body_3.color == color("red") and world.body_3.velocity == vec(0, 1))
assert(world.body_3.mass == 4)
local sum = 0
world:each("Body", function(b) sum = sum + b.mass end)
assert(sum == 20)
local masses = query("world.*.mass")
assert(masses["world.body_1.mass"] == 2)
assert(#query("world.body_*") == 5)
local copy = world.body_1:clone()
assert(copy.mass == 2 and copy.parent == nil and copy.circle.radius == 0.5)
)lua");
    CHECK_THAT(s.fails("world:all('Body'):set('mas', 1)"), contains("mass"));
    CHECK_THAT(s.fails("world:all('Bdy')"), contains("Body"));
    CHECK_THAT(s.fails("world:all('Body'):add('title', 1)"), contains("cannot be added"));
}

TEST_CASE("pairs visits numbers and then names in order") {
    Stage s;
    CHECK(s.prints(R"lua(
local t = { z = 1, a = 2, [10] = 3, [2] = 4, m = 5, 6 }
local keys = {}
for k in pairs(t) do keys[#keys + 1] = tostring(k) end
print(table.concat(keys, " "))
for k, v in pairs(t) do t[k] = nil end
print(next(t))
)lua") == "1 2 10 a m z|nil");
    CHECK(s.prints("print(tostring({}), tostring(print), tostring(coroutine.create(print)))") ==
          "{}\tfunction\tthread");
    CHECK(s.prints("world.b = Body { friction = 0.1 } print(world.b.friction, 2.0, 1/3, 3)") ==
          "0.1\t2.0\t0.3333333333333333\t3");
}

TEST_CASE("instances without references are collected") {
    Stage s;
    s.run(
        "kept = Body {}; holder = Object {}; holder.inner = Circle {}; inner = holder.inner; "
        "holder = nil");
    s.run("world.owner = Object {}; world.owner.list = { Body { title = 'listed' } }");
    const std::size_t before = s.tree->size();
    s.run("for i = 1, 500 do Body { Circle {} } end");
    CHECK(s.tree->size() == before + 1000);
    s.step();
    CHECK(s.tree->size() == before);
    s.run("assert(kept:alive() and inner:alive() and inner.parent:alive())");
    s.run("assert(world.owner.list[1].title == 'listed')");
}

}  // namespace tree_test
