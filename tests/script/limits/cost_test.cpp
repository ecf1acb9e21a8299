// Operations whose cost must not depend on the number of objects. The large cases take less than a
// second each; with quadratic cost they would take hours.

#include "stage.h"
#include "thorough.h"

namespace cost_test {

using stage::Stage;

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool slowly = true;  // the large cases would take minutes
#else
constexpr bool slowly = false;
#endif

}  // namespace

TEST_CASE("access to a child by index does not depend on the number of children") {
    Stage s;
    CHECK(s.prints(R"lua(
local n = 100000
local box = Object {}
world.box = box
while #box < n do box:add(Object {}) end
local sum = 0
for i = 1, n do if box[i].parent == box then sum = sum + 1 end end
for i = n, 1, -1 do if box[i].parent == box then sum = sum + 1 end end
for i, child in ipairs(box) do sum = sum + 1 end
print(sum, box[n + 1], box[0], box[-1])
while #box > n / 2 do box[#box]:delete() end
while #box > 0 do box[1]:delete() end
print(#box, box[1])
)lua") == "300000\tnil\tnil\tnil|0\tnil");
}

TEST_CASE("the index of a child follows creations and deletions") {
    Stage s;
    s.run(R"lua(
local box = Object {}
world.box = box
for i = 1, 60 do box["c" .. i] = Object {} end
local function check()
    local names = {}
    for _, child in ipairs(box:children()) do names[#names + 1] = child.name end
    assert(#box == #names)
    for i = 1, #names do assert(box[i].name == names[i], i) end
    for i = #names, 1, -1 do assert(box[i].name == names[i], i) end
    assert(box[#names + 1] == nil and box[#names * 3] == nil)
end
check()
for i = 1, 400 do
    local k = random(1, #box)
    local _ = box[k]
    if i % 4 == 0 then box[random(1, #box)]:delete()
    elseif i % 4 == 1 then box:add(Object {}) box:add(Object {})
    elseif i % 4 == 2 then box[k]:move(nil)
    else box[k].name = "r" .. i end
    check()
end
)lua");
}

TEST_CASE("the cost of stopping watchers and timers does not depend on their number") {
    Stage s;
    const std::string many = std::to_string(slowly || !thorough() ? 30000 : 100000);
    s.run("local n = " + many + R"lua(
world.ball = Body {}
local kept = {}
for i = 1, n do kept[i] = world:watch("scale", print) end
for i = 1, n do kept[i]:stop() end
for i = 1, n do kept[i] = world.ball:watch("position", print) end
for i = 1, n do kept[i]:stop() end
for i = 1, n do kept[i] = after(1, print) end
for i = 1, n do kept[i]:stop() end
for i = 1, n do world.ball:on("deleted", function() reported = (reported or 0) + 1 end) end
reported = 0
world.ball = nil
)lua");
    s.tree->barrier();
    CHECK(s.prints("print(reported)") == many);
    CHECK(s.tree->watcher_count() == 0);
}

TEST_CASE("the cost of a pattern does not depend on the number of other watched instances") {
    Stage s;
    s.run(R"lua(
local kept = {}
for i = 1, 20000 do kept[i] = watch("world.*.p" .. i, print) end
for i = 1, 20000 do kept[i]:stop() end
)lua");
    CHECK(s.tree->watcher_count() == 0);
}

TEST_CASE("any number of formulas may read one source and end in any order") {
    Stage s;
    s.run("local n = " + std::to_string(thorough() ? 40000 : 15000) + R"lua(
world.v = 1
box = Object {}
world.box = box
for i = 1, n do
    local o = box:add(Object {})
    o.f = formula(function() return world.v + i end)
    assert(o.f == 1 + i)
end
for i = 1, n do world.v = i end
for _, o in ipairs(box:children()) do o.f = nil end
)lua");
    CHECK(s.tree->formula_count() == 0);
    s.run(
        "for _, o in ipairs(box:children()) do o.f = formula(function() return time end) end "
        "box:delete()");
    CHECK(s.tree->formula_count() == 0);
}

TEST_CASE("a source that is written repeatedly marks its formulas once") {
    Stage s;
    CHECK(s.prints(R"lua(
world.v = 0
for i = 1, 20000 do
    local o = Object {}
    world["o" .. i] = o
    o.f = formula(function() return world.v end)
    local _ = o.f
end
for i = 1, 100000 do world.v = i end
print(world.o1.f, world.o20000.f)
world.v = 5
print(world.o1.f)
world.v = 6
print(world.o1.f, world.o2.f)
)lua") == "100000\t100000|5|6\t6");
}

TEST_CASE("a formula does not keep the names of created and deleted instances") {
    Stage s;
    s.run("world.n = formula(function() return 1 end) local _ = world.n");
    s.run("for i = 1, 200 do local o = world:add(Object {}, 'unheard_of_' .. i) o:delete() end");
    CHECK_FALSE(fettle::property::Symbol::find("unheard_of_17"));
}

}  // namespace cost_test
