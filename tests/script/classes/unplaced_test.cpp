// Instances that are in no tree: those that nothing keeps are deleted from time to time.

#include "stage.h"

namespace unplaced_test {

using stage::Stage;
using stage::Value;

TEST_CASE("a detached instance with a timer lives until the timer has run") {
    Stage s;
    s.run(R"lua(
called = 0
for i = 1, 300 do
    local o = Object { number = i }
    o:after(0.5, function(self) called = called + 1 world:add(self) end)
    Object {}:after(0.5, function() called = called + 1 end, { pauses = true })
end
)lua");
    s.step(60);
    CHECK(s.errors.empty());
    CHECK(s.prints("print(called, #world:children())") == "600\t300");
}

TEST_CASE("instances that nothing keeps are deleted, and those that the tree refers to are not") {
    Stage s;
    s.run(R"lua(
world.o = Object { target = Object { name_of_it = "kept" } }
function step() for i = 1, 20 do Object {} end end
)lua");
    s.step(300);
    CHECK(s.errors.empty());
    const std::size_t count = s.tree->size();
    CHECK(count < 500);
    CHECK(s.prints("print(world.o.target.name_of_it)") == "kept");
}

TEST_CASE("a formula in error does not disturb the search for instances that nothing keeps") {
    Stage s;
    s.run(R"lua(
world.o = Object { other = Object {} }
world.o.w = formula(function() error("bad") end)
function step() for i = 1, 20 do Object {} end end
)lua");
    CHECK_NOTHROW(s.step(100));
    CHECK(s.prints("print(world.o.other:alive())") == "true");
}

TEST_CASE("what the framework reads in each step may have a formula in error") {
    Stage s;
    s.run(R"lua(
world.o = Object { size = 0.0, other = 0.0 }
local function broken() error("bad") end
local one = tween(world.o, "size", 1, 0.5)
local group = tween.sequence { tween(world.o, "other", 2, 0.5), 0.5, loops = 0 }
set = 0
for _, each in ipairs { one, group } do
    for _, name in ipairs { "paused", "pauses", "loops", "turn", "reversed", "progress", "alternate" } do
        if pcall(function() each[name] = formula(broken) end) then set = set + 1 end
    end
end
pcall(function() one.target = formula(broken) end)
world.p = Object { height = 0.0 }
healthy = tween(world.p, "height", 1, 0.5)
Door = class("Door", Object) { current_state = "open", states = { open = { step = function() end } } }
world.door = Door {}
world.door.current_state = formula(broken)
)lua");
    CHECK(s.get("world.o.size") == Value(0.0));
    CHECK_NOTHROW(s.step(100));
    CHECK(s.prints("print(set > 5, world.p.height)") == "true\t1.0");
    CHECK(s.errors.empty());
}

TEST_CASE("going back in time changes no estimate of memory") {
    Stage s;
    s.run("world.a = Object { v = 1 } for i = 1, 50 do world.a:every(0.1, function() end) end");
    s.step(3);
    const auto snapshot = s.tree->snapshot();
    const std::int64_t before = s.tree->weight();
    for (int i = 0; i < 5; ++i) {
        s.run("for i = 1, 50 do world.a:every(0.1, function() end) end");
        s.step(3);
        s.tree->restore(snapshot);
        s.step(0);
        s.tree->barrier();
        CHECK(s.tree->weight() == before);
    }
}

}  // namespace unplaced_test
