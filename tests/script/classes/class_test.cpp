// Classes of scripts, events, watchers, timers, coroutines.

#include <fettle/property/storage/scene.h>

#include "stage.h"
#include "temporary_folder.h"

namespace class_test {

using stage::Stage;

TEST_CASE("a class of a script has properties and defaults and functions") {
    Stage s;
    s.run(R"lua(
Ball = class("Ball", Body) { lives = 3, speed = 2.5, title = "ball", friction = 0.25, home = vec(1, 2),
                             doc = { "A ball.", lives = "How often it may fall." } }
function Ball:hurt(n) self.lives = self.lives - n; return self.lives end
world.ball = Ball { Circle {}, lives = 5 }
assert(world.ball.lives == 5 and world.ball.title == "ball" and world.ball.home == vec(1, 2))
assert(math.abs(world.ball.friction - 0.25) < 1e-7)
assert(world.ball:hurt(2) == 3 and world.ball.lives == 3)
assert(world.ball:is_a("Body") and world.ball:is_a(Ball) and not world.ball:is_a("Circle"))
world.ball.lives = nil
assert(world.ball.lives == 3)
assert(Body {}.friction > 0.5)
)lua");
    const auto& of = s.tree->class_named("Ball");
    CHECK(of.doc() == "A ball.");
    CHECK(of.property("lives")->doc == "How often it may fall.");
    CHECK(of.property("lives")->type == fettle::property::Type::integer);
    CHECK_THAT(s.fails("world.ball.lives = 2.5"), contains("declare 3.0"));
    CHECK_THAT(s.fails("world.ball:hrt(1)"), contains("hurt"));
    CHECK_THAT(s.fails("world.ball.hurt = 3"), contains("is a function of Ball"));
    CHECK_THAT(s.fails("class('B2', Body) { frction = 1 }"), contains("friction"));
    // A plural with a value of another kind is a property of the game's own.
    CHECK_THAT(s.fails("class('B5', Body) { positions = vec(1, 2) }"), contains("\"position\"?"));
    s.run(
        "Enemy5 = class('Enemy5', Body) { positions = { vec(1, 2) }, names = {} } "
        "world.enemy = Enemy5 { names = { 'a' } } world.enemy.velocities = { vec(0, 0) } "
        "assert(world.enemy.names[1] == 'a' and world.enemy.positions[1].y == 2)");
    CHECK_THAT(s.fails("world.ball.velocitys = vec(0, 0)"), contains("\"velocity\"?"));
    CHECK_THAT(s.fails("class('B3', Body) { mass = -1 }"), contains("mass"));
    CHECK_THAT(s.fails("class('Body') {}"), contains("class of the framework"));
    CHECK_THAT(s.fails("class('no way', Body) {}"), contains("is not a name for a class"));
    for (const char* too_long :
         {"class(('x'):rep(1e6), Body) {}", "class('Ok', Body) { [('p'):rep(1e6)] = 1 }",
          "edit(('x'):rep(1e7), function() world.gravity = vec(0, 1) end)"})
        CHECK_THAT(s.fails(too_long), contains("and a name has at most 1000"));
    CHECK_THAT(s.fails("class('B4', World) {}"), contains("no class can derive from World"));
    CHECK_THAT(s.fails("Ball.lives = 3"), contains("a class takes functions"));
    CHECK_THAT(s.fails("function Ball:mass() end"), contains("is a property already"));
    CHECK_THAT(s.fails("function Ball:contact_begn() end"), contains("contact_begin"));
    CHECK_THAT(s.fails("world.b = Body { contact_begn = function() end }"),
               contains("did you mean \"contact_begin\""));
    CHECK_THAT(s.fails("function Body:step() end"), contains("derive one"));
}

TEST_CASE("an instance that a timer or step makes is ready before its first step") {
    Stage s;
    s.run(R"lua(
        Foe = class("Foe", Object) {}
        function Foe:ready() self.bar = Object {} print("ready", self.name) end
        function Foe:step() print("step", self.name, self.bar.name) end
        after(0, function() world.timed = Foe {} end)
        function step() if not world:has("stepped") then world.stepped = Foe {} end step = nil end
    )lua");
    s.step();
    CHECK(s.errors.empty());
    for (const char* name : {"timed", "stepped"})
        CHECK_THAT(stage::joined(s.printed), contains(std::string("ready\t") + name));
    const std::string all = stage::joined(s.printed);
    CHECK(all.find("ready\ttimed") < all.find("step\ttimed\tbar"));
    CHECK(all.find("ready\tstepped") < all.find("step\tstepped\tbar"));
    CHECK(all.find("step\tstepped\tbar") != std::string::npos);
}

TEST_CASE("the functions ready and step and event handlers of a class of a script are called") {
    Stage s;
    s.run(R"lua(
Ball = class("Ball", Body) { n = 0 }
function Ball:ready() print("ready", self) end
function Ball:step(dt) self.n = self.n + 1 end
function Ball:contact_begin(contact) print(self.name, contact.other.name, contact.speed) end
Big = class("Big", Ball) { n = 100 }
function Big:contact_begin(contact) print("big", contact.speed) end
world.box = Object { Ball {} }
world.big = Big {}
detached = Ball {}
)lua");
    CHECK(stage::joined(s.printed) == "ready\tworld.box.ball|ready\tworld.big");
    s.step(2);
    CHECK(s.get("world.box.ball.n") == stage::Value(2));
    CHECK(s.get("world.big.n") == stage::Value(102));
    s.run("assert(detached.n == 0)");
    s.printed.clear();
    for (const char* path : {"box", "big"}) {
        auto handle = s.tree->child(s.world, path);
        if (std::string(path) == "box") handle = s.tree->first_child(handle);
        s.tree->emit(handle, *s.tree->class_of(handle).event("contact_begin"), {s.world, 2.0});
    }
    s.tree->barrier();
    CHECK(stage::joined(s.printed) == "ball\tworld\t2.0|big\t2.0");
    s.printed.clear();
    s.run("world.late = detached");
    CHECK(stage::joined(s.printed) == "ready\tworld.late");
    s.run("world.late:delete()");
    s.step();
    CHECK(s.errors.empty());
}

TEST_CASE("thousands of instances of a class of a script are created and deleted") {
    Stage s;
    s.run(R"lua(
Spark = class("Spark", Object) { age = 0 }
function Spark:step(dt) self.age = self.age + 1; if self.age >= 3 then self:delete() end end
every(0, function() for i = 1, 100 do world:add(Spark {}) end end)
)lua");
    s.step(100);
    CHECK(s.tree->child_count(s.world) <= 300);
    CHECK(s.tree->child_count(s.world) >= 200);
    CHECK(s.errors.empty());
}

TEST_CASE("functions are called for instances of a class of a script that a module creates") {
    Stage s;
    s.run(R"lua(
Ball = class("Ball", Body) { n = 0 }
function Ball:ready() print("ready", self) end
function Ball:step(dt) self.n = self.n + 1 end
)lua");
    s.tree->create(s.tree->class_named("Ball"), s.world, "native");
    s.tree->barrier();
    s.step(2);
    CHECK(s.get("world.native.n") == stage::Value(2));
    CHECK(stage::joined(s.printed) == "ready\tworld.native");
}

TEST_CASE("undo and redo bring an instance back without calling ready again") {
    Stage s;
    s.run(R"lua(
Ball = class("Ball", Body) {}
function Ball:ready() self:add(Body {}) end
)lua");
    const auto parts = [&] {
        s.step();
        return s.tree->child_count(s.get("world.b").reference());
    };
    s.console("world.b = Ball {}");
    CHECK(parts() == 1);
    for (const char* command : {"undo", "redo", "world.b:delete()", "undo", "undo", "redo"}) {
        INFO(command);
        CHECK_THAT(s.console(command), !contains("error"));
        s.step();
        if (s.tree->child(s.world, "b")) CHECK(parts() == 1);
    }
    CHECK(s.tree->child(s.world, "b"));
    CHECK(s.errors.empty());
}

TEST_CASE("the store and what the framework makes cannot be replaced") {
    Stage s;
    CHECK_THAT(s.fails("store = {}"), contains("store: contains what outlives the run"));
    s.tree->define({.name = "Clock", .creatable = false});
    s.tree->create(s.tree->class_named("Clock"), s.tree->root(), "clock");
    CHECK_THAT(s.fails("clock = 0"), contains("clock: is the Clock of the framework"));
    CHECK_THAT(s.fails("game.clock = 0"), contains("game.clock: is the Clock of the framework"));
}

TEST_CASE("watchers are called at the barrier with old and new value") {
    Stage s;
    s.run(R"lua(
world.b = Body {}
c = world.b:watch("mass", function(new, old, change)
    print(new, old, change.instance, change.path, change.property)
end)
world.b.mass = 2
world.b.mass = 3
)lua");
    CHECK(s.printed.empty());
    s.tree->barrier();
    CHECK(stage::joined(s.printed) == "3.0\t1.0\tworld.b\tworld.b.mass\tmass");
    s.printed.clear();
    s.run("assert(c:active()); c:stop(); assert(not c:active()); world.b.mass = 4");
    s.tree->barrier();
    CHECK(s.printed.empty());
    s.run(R"lua(
watch("world.*.velocity", function(new, old, change) print(change.path, new) end)
world.b:watch(function(new, old, change) print("any", change.property) end)
Body:watch("title", function(new) print("title", new) end)
world.b.velocity = vec(1, 2)
world.b.title = "t"
)lua");
    s.tree->barrier();
    CHECK(stage::joined(s.printed) ==
          "world.b.velocity\tvec(1, 2)|any\tvelocity|any\ttitle|title\tt|any\tenergy");
    CHECK_THAT(s.fails("watch('world.b.mas', print)"), contains("mass"));
    CHECK_THAT(s.fails("world.b:watch('mass')"), contains("needs a function"));
    CHECK_THAT(s.fails("c.stp()"), contains("did you mean \"stop\""));
}

TEST_CASE("an error in a handler is reported with its own traceback and the others are called") {
    Stage s;
    s.run(R"lua(
world.b = Body {}
local function deep(x) local inner = x; error("boom " .. inner) end
world.b:watch("mass", function(new) deep(new) end)
world.b:watch("mass", function(new) print("second", new) end)
world.b.mass = 2
)lua");
    s.tree->barrier();
    CHECK(stage::joined(s.printed) == "second\t2.0");
    REQUIRE(s.errors.size() == 1);
    const auto& error = s.errors.front();
    CHECK(error.message == "main.lua:3: boom 2.0");
    CHECK(error.file == "main.lua");
    CHECK(error.line == 3);
    CHECK_THAT(error.source_line, contains("local function deep"));
    CHECK(error.context == "watcher of world.b.mass");
    CHECK_THAT(error.locals, contains("inner = 2"));
    CHECK_THAT(error.traceback, contains("main.lua:4"));
}

TEST_CASE("handlers get the events of creation and deletion") {
    Stage s;
    s.run(R"lua(
Body:on("created", function(e) print("created", e.path) end)
world.b = Body { mass = 7 }
world.b:on("deleted", function(e) print("gone", e.path, e.last.mass) end)
)lua");
    s.tree->barrier();
    s.run("world.b = nil");
    s.tree->barrier();
    CHECK(stage::joined(s.printed) == "created\tworld.b|gone\tworld.b\t7.0");
}

TEST_CASE("repeated timers do not catch up without end after a jump of the time") {
    Stage s;
    s.run(
        "n = 0 m = 0 short = 0 every(0.1, function() n = n + 1 end)"
        "every(0, function() m = m + 1 end) every(0.0001, function() short = short + 1 end)");
    s.step(1);
    CHECK(s.prints("print(m, short)") == "1\t166");
    s.run("m = 0 short = 0");
    s.runtime->step(1e6, 1 / 60.0);
    CHECK(s.prints("print(n >= 19999 and n <= 20001, m, short >= 19999 and short <= 20001)") ==
          "true\t1\ttrue");
    s.run("n = 0 m = 0 short = 0");
    s.runtime->step(1e6 + 1, 1 / 60.0);
    CHECK(s.prints("print(n, m, short >= 9999 and short <= 10001)") == "10\t1\ttrue");
    // Here the time has steps of 0.125 s, in which the shortest interval has no effect.
    s.run("n = 0 m = 0 short = 0");
    for (int i = 0; i < 3; ++i) s.runtime->step(9e14 + i, 1 / 60.0);
    CHECK(s.prints("print(n <= 60000, m, short <= 60000)") == "true\t3\ttrue");
}

TEST_CASE("timers run in simulation time and in order") {
    Stage s;
    s.run(R"lua(
after(0.05, function() print("b") end)
after(0.02, function() print("a") end)
n = 0
ticker = every(1 / 60, function() n = n + 1 end)
always = every(0, function() steps = (steps or 0) + 1 end)
steps = 0
stopped = after(0.02, function() print("never") end)
stopped:stop()
)lua");
    s.step(1);
    CHECK(s.printed.empty());
    s.step(1);
    CHECK(stage::joined(s.printed) == "a");
    s.step(58);
    CHECK(stage::joined(s.printed) == "a|b");
    CHECK(s.prints("print(n, steps)") == "60\t60");
    s.run("ticker:stop()");
    s.step(5);
    CHECK(s.prints("print(n, steps)") == "60\t65");
    CHECK_THAT(s.fails("after(-1, print)"), contains("not negative"));
    CHECK_THAT(s.fails("after(0/0, print)"), contains("finite"));
    CHECK_THAT(s.fails("every(1e-9, print)"), contains("shorter"));
    CHECK_THAT(s.fails("after(1)"), contains("needs a function"));
    s.run("after(0, function() local x = nil + 1 end)");
    s.step();
    REQUIRE(s.errors.size() == 1);
    CHECK(s.errors[0].context == "timer");
    CHECK_THAT(s.errors[0].message, contains("main.lua:1: attempt to perform arithmetic"));
}

TEST_CASE("coroutines wait in simulation time") {
    Stage s;
    s.run(R"lua(
co = coroutine.create(function() print("start"); wait(0.1); print("middle"); wait(0.1); print("end") end)
assert(coroutine.resume(co))
after(0, function() wait(0.05); print("timer") end)
)lua");
    CHECK(stage::joined(s.printed) == "start");
    CHECK(s.prints("print(coroutine.resume(co))") == "false\tcannot resume a coroutine that waits");
    s.printed.clear();
    s.step(30);
    CHECK(stage::joined(s.printed) == "timer|middle|end");
    CHECK(s.prints("print(coroutine.status(co))") == "dead");
    CHECK_THAT(s.fails("wait(1)"), contains("works inside a coroutine"));
    s.run("coroutine.wrap(function() wait(0.01); local here = 7; error('late') end)()");
    s.step(2);
    REQUIRE(s.errors.size() == 1);
    CHECK(s.errors[0].message == "main.lua:1: late");
    CHECK(s.errors[0].context == "coroutine");
    CHECK_THAT(s.errors[0].locals, contains("here = 7"));
}

TEST_CASE("an error in a coroutine keeps the place where it occurred") {
    Stage s;
    s.fails(R"lua(
local co = coroutine.wrap(function()
    local treasure = 42
    error("inside")
end)
co()
)lua");
    CHECK(s.errors[0].message == "main.lua:4: inside");
    CHECK(s.errors[0].line == 4);
    CHECK_THAT(s.errors[0].locals, contains("treasure = 42"));
    CHECK_THAT(s.errors[0].traceback, contains("coroutine started from"));
    s.run(R"lua(
local ok, message = coroutine.resume(coroutine.create(function() error({ code = 3 }) end))
assert(not ok and message.code == 3)
local gen = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
assert(gen() == 1 and gen() == 2)
local c = coroutine.create(function() coroutine.yield() end)
coroutine.resume(c)
assert(coroutine.close(c) and coroutine.status(c) == "dead")
)lua");
}

TEST_CASE("the game is loaded from a folder and its modules from the same folder") {
    Stage s;
    const TemporaryFolder temporary;
    const std::filesystem::path& folder = temporary.path;
    std::filesystem::create_directories(folder / "enemies");
    const auto write = [&](const char* file, const char* text) {
        std::FILE* f = std::fopen((folder / file).c_str(), "wb");
        std::fputs(text, f);
        std::fclose(f);
    };
    write("main.lua",
          "local boss = require 'enemies.boss'\nfunction start() print('started', boss.name) end\n"
          "function closing() print(nothing_of_the_kind) end\nassert(require 'enemies.boss' == "
          "boss)");
    write("enemies/boss.lua", "return { name = 'Bob' }");
    write("broken.lua", "local x = = 3");
    std::error_code code;
    std::filesystem::create_symlink("/etc", folder / "outside", code);
    REQUIRE(s.runtime->load(folder));
    CHECK(stage::joined(s.printed) == "started\tBob");
    CHECK_FALSE(s.runtime->call("closing", {}));
    CHECK(s.errors[0].message == "main.lua:3: nothing_of_the_kind: no such name");
    CHECK(s.errors[0].context == "closing");
    CHECK_THAT(s.fails("require 'enemies.bos'"), contains("did you mean \"enemies.boss\""));
    CHECK_THAT(s.fails("require '../main'"), contains("is not a name of a module"));
    CHECK_THAT(s.fails("require '/etc/passwd'"), contains("is not a name of a module"));
    CHECK_THAT(s.fails("require 'outside.passwd'"), contains("no module"));
    CHECK_THAT(s.fails("require 'broken'"), contains("broken.lua:1:"));
    CHECK(s.errors[0].source_line == "local x = = 3");
    // Loading again starts the game anew with the same tree.
    s.run("leftover = 1; every(0, function() print('old timer') end)");
    s.printed.clear();
    REQUIRE(s.runtime->load(folder));
    s.step();
    CHECK(stage::joined(s.printed) == "started\tBob");
    CHECK_THAT(s.fails("print(leftover)"), contains("no such name"));
    CHECK_THROWS_AS(s.runtime->load(folder / "none.lua"), fettle::property::FileError);
}

TEST_CASE("a class can be loaded again with new functions but not with other properties") {
    Stage s;
    const TemporaryFolder temporary;
    const std::filesystem::path& folder = temporary.path;
    const auto load = [&](const char* text) {
        std::FILE* f = std::fopen((folder / "main.lua").c_str(), "wb");
        std::fputs(text, f);
        std::fclose(f);
        return s.runtime->load(folder);
    };
    REQUIRE(
        load("Ball = class('Ball', Body) { lives = 3 } function Ball:step() print('one') end "
             "world.b = Ball {}"));
    REQUIRE(
        load("Ball = class('Ball', Body) { lives = 4 } function Ball:step() print('two') end "
             "world.c = Ball {}"));
    s.step();
    CHECK(stage::joined(s.printed) == "two|two");
    CHECK(s.get("world.b.lives") == stage::Value(3));
    CHECK(s.get("world.c.lives") == stage::Value(4));
    CHECK_FALSE(load("Ball = class('Ball', Body) { lives = 'many' }"));
    CHECK_THAT(s.errors.back().message, contains("other properties"));
}

TEST_CASE("two different definitions of a class are distinguished") {
    Stage s;
    s.run("class('Crate', Object) { worth = 1, label = 'new' }");
    const auto twice = [&](const char* second) { return s.fails(second); };
    CHECK_THAT(twice("class('Crate', Object) { worth = 1, label = '', weight = 2 }"),
               contains("Crate: exists already with other properties: the first has no "
                        "\"weight\""));
    CHECK_THAT(twice("class('Crate', Object) { worth = 1 }"),
               contains("other properties: the second has no \"label\""));
    CHECK_THAT(twice("class('Crate', Object) { worth = true, label = '' }"),
               contains("\"worth\" is an integer in the first and a boolean in the second"));
    s.run("class('Box2', 'Crate') {}");
    CHECK_THAT(twice("class('Box2', Object) {}"),
               contains("Box2: exists already with another base, Crate"));
}

TEST_CASE("random numbers depend only on the seed") {
    const auto sequence = [](std::uint64_t seed) {
        fettle::script::Options options;
        options.seed = seed;
        Stage s(options);
        return s.prints(
            "print(random(), random(6), random(1, 3), math.random(100), random(0.5, 1.5))");
    };
    CHECK(sequence(1) == sequence(1));
    CHECK(sequence(1) != sequence(2));
    Stage s;
    s.run(R"lua(
for i = 1, 1000 do
    local a, b, c = random(), random(6), random(-2.5, 2.5)
    assert(a >= 0 and a < 1 and b >= 1 and b <= 6 and math.type(b) == "integer" and c >= -2.5 and c <= 2.5)
    assert(math.type(math.random(3.0)) == "integer")
end
assert(random(math.mininteger, math.maxinteger))
)lua");
    CHECK_THAT(s.fails("random(2, 1)"), contains("nothing lies between"));
    CHECK_THAT(s.fails("random('x')"), contains("needs a number"));
}

TEST_CASE("callbacks get their arguments and quit ends the game") {
    Stage s;
    s.run("function mouse_pressed(button, position) print(button, position.x) end");
    CHECK(s.runtime->defines("mouse_pressed"));
    CHECK_FALSE(s.runtime->defines("mouse_released"));
    CHECK(s.runtime->call("mouse_pressed", {"left", stage::Vec2(3, 4)}));
    CHECK(s.runtime->call("mouse_released", {"left", stage::Vec2(3, 4)}));
    CHECK(stage::joined(s.printed) == "left\t3.0");
    CHECK_FALSE(s.runtime->quit_status());
    s.run("quit(3)");
    CHECK(s.runtime->quit_status() == 3);
    Stage other;
    other.run(
        "game.thing = Object { size = 1 } tween(game.thing, 'size', 2, 0.1):on('finished', quit)");
    other.step(10);
    CHECK(other.runtime->quit_status() == 0);
    CHECK_THAT(s.fails("function keypressed(key) end"), contains("did you mean \"key_pressed\""));
    s.run("game.thing = Object {}");
    CHECK_THAT(s.fails("thing = 3"), contains("assign game.thing"));
    CHECK_THAT(s.fails("print(undefined_thing)"), contains("undefined_thing: no such name"));
    s.run(
        "maybe = nil; assert(maybe == nil); sometimes = 3; sometimes = nil; assert(not sometimes)");
    CHECK_THAT(s.fails("tween()"), contains("tween: needs an instance"));
}

TEST_CASE("a class in C++ with a member that would hide a method of every instance is refused") {
    fettle::property::Tree tree;
    fettle::property::ClassDescriptor odd;
    odd.name = "Odd";
    odd.properties = {{.name = "children", .type = fettle::property::Type::integer}};
    (void)tree.define(odd);
    CHECK_THROWS_WITH(fettle::script::Runtime(tree, {}),
                      contains("Odd.children: is a method of every instance"));
}

}  // namespace class_test
