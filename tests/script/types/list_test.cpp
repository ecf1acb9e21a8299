// Lists of properties as tables of Lua.

#include <fettle/property/change.h>

#include "stage.h"

namespace list_test {

using stage::Stage;

TEST_CASE("writes to nested lists are written back too") {
    Stage s;
    s.run(R"lua(
world.grid = { {1, 2}, {3, 4} }
world.grid[2][1] = 30
assert(world.grid[2][1] == 30 and world.grid[1][2] == 2)
world.grid[3] = {5}
assert(#world.grid == 3 and world.grid[3][1] == 5)
)lua");
}

TEST_CASE("a list grows and shrinks one by one as quickly as a table") {
    Stage s;
    s.run(R"lua(
world.list, world.stack, world.twin = {}, {}, {}
local before = os.clock()
for i = 1, 20000 do
    world.list[#world.list + 1] = i
    table.insert(world.stack, vec(i, i))
end
for i = 1, 20000 do world.list[i] = -i end
for i = 1, 15000 do assert(table.remove(world.stack).x == 20001 - i) end
for i = 20000, 10001, -1 do world.list[i] = nil end
assert(#world.list == 10000 and world.list[7] == -7 and #world.stack == 5000)
assert(os.clock() - before < 5, os.clock() - before)      -- with a copy for each it takes more than ten seconds
local kept = world.list
world.twin = world.list
world.list[1] = "other"
assert(world.twin[1] == -1 and kept[1] == "other")
)lua");
}

TEST_CASE("lists within a list are exchanged and moved as tables are") {
    Stage s;
    s.run(R"lua(
world.grid = { { 1, "a" }, { 2, "b" }, { 3, "c" }, { 4, { "d", vec(1, 1) } } }
local grid = world.grid
local function shown()
    local all = {}
    for _, row in ipairs(world.grid) do all[#all + 1] = row[1] end
    return table.concat(all, " ")
end
grid[1], grid[2] = grid[2], grid[1]
assert(shown() == "2 1 3 4", shown())
local first, last = grid[1], grid[4]
grid[1] = { 9 }
assert(first[1] == 2 and first[2] == "b" and #first == 2)
table.insert(grid, 2, { 5 })
assert(last[2][1] == "d" and last[2][2].x == 1)
grid[3] = first
assert(shown() == "9 5 2 3 4", shown())
local gone = table.remove(grid, 1)
assert(gone[1] == 9 and grid[1][1] == 5)
-- An insertion sort holds one while it moves the others.
world.grid = { { 3 }, { 1 }, { 2 }, { 0 } }
for i = 2, #grid do
    local row, j = grid[i], i
    while j > 1 and grid[j - 1][1] > row[1] do
        grid[j] = grid[j - 1]
        j = j - 1
    end
    grid[j] = row
end
assert(shown() == "0 1 2 3", shown())
-- One that is there still is the one in the list.
local row = grid[2]
grid[1], row[1], grid[2][2] = { 7 }, 8, "x"
assert(grid[2][1] == 8 and row[2] == "x")
)lua");
    CHECK_THAT(s.fails("local row = world.grid[1] world.grid[1] = { 1 } row[1] = 2"),
               contains("world.grid[1]: this list was replaced or moved after it was read"));
    CHECK_THAT(s.fails("local row = world.grid[2] table.remove(world.grid, 1) "
                       "table.insert(row, 1)"),
               contains("read it again"));
}

TEST_CASE("lists of two properties are exchanged as tables are") {
    Stage s;
    s.run(R"lua(
world.a, world.b = { 1, 2 }, { 3, { 4 } }
world.a, world.b = world.b, world.a
assert(world.a[1] == 3 and world.a[2][1] == 4 and world.b[2] == 2)
-- A variable goes on with the list of the property.
local list = world.a
list[1] = 7
world.b = list
assert(world.b[1] == 7)
world.a = { 5 }
assert(list[1] == 5 and #list == 1)
)lua");
}

TEST_CASE("a list of a property is sorted in one change") {
    Stage s;
    s.run(R"lua(
world.numbers = { 3, 1, 2 }
world.places = { vec(2, 0), vec(1, 5) }
world.best = { { 5, "a" }, { 9, "b" }, { 7, "c" } }
)lua");
    int changes = 0;
    s.tree->watch(s.world, "best", [&](const fettle::property::Change&) { ++changes; });
    s.run(R"lua(
table.sort(world.numbers)
assert(table.concat(world.numbers, " ") == "1 2 3")
table.sort(world.places, function(a, b) return a.x < b.x end)
assert(world.places[1] == vec(1, 5))
local first = world.best[1]
table.sort(world.best, function(a, b) return a[1] > b[1] end)
assert(world.best[1][2] == "b" and world.best[3][2] == "a" and first[2] == "a")
)lua");
    s.tree->barrier();
    CHECK(changes == 1);
    CHECK_THAT(s.fails("table.sort(world.best)"), contains("attempt to compare"));
    CHECK_THAT(s.fails("table.sort(world.best, function() error('no') end)"), contains("no"));
    CHECK(s.prints("print(world.best)") == "{{9, \"b\"}, {7, \"c\"}, {5, \"a\"}}");
}

}  // namespace list_test
