// Actions of a game's functions when the physics calls them in the middle of a step or of a search:
// every question is combined with every action; one test is one game, and each combination is one
// of its steps.

#include <catch.h>

#include "program.h"

namespace asked_test {

using namespace program_test;

namespace {

/// Builds the objects that the questions are about, and defines all actions that could change them.
const std::string stage = R"lua(
function build()
    if world:has("stage") then world.stage = nil end
    if not game:has("second") then game.second = World {} end
    world.stage = Object {}
    world.stage:add(Body { type = "static", position = vec(0, -2), Box { width = 60, height = 2 } }, "floor")
    for i = -1, 1 do
        world.stage:add(Body { position = vec(i, -0.6), Circle { radius = 0.4 } }, "ball_" .. i + 2)
    end
    world.stage:add(Body { position = vec(0, 0.6), Polygon {} }, "hull")
    game.second.other = Body { Circle {} }
    connection = world.stage.floor:watch("mass", function() end)
end

Foe = class("Foe", Body) { lives = 3 }
held = nil

function body_of(shape) return shape.parent end

changes = {
    delete_shape = function(s) s:delete() end,
    delete_body = function(s) body_of(s):delete() end,
    delete_floor = function() world.stage.floor:delete() end,
    delete_by_nil = function() world.stage.hull = nil end,
    delete_branch = function() world.stage:delete() end,
    delete_world = function() world:delete() end,
    delete_other_world = function() game.second:delete() end,
    delete_in_other_world = function() game.second.other:delete() end,
    detach_shape = function(s) s:move(nil) end,
    detach_body = function(s) body_of(s):move(nil) end,
    move_shape = function(s) s:move(world.stage.hull) end,
    move_body = function(s) body_of(s):move(game.second) end,
    set_parent = function(s) body_of(s).parent = game.second end,
    rename = function(s) body_of(s).name = "renamed" end,
    create = function() return Body { Circle {} } end,
    create_in_world = function() world.stage.more = Body { Circle {} } end,
    create_shape = function(s) body_of(s):add(Circle {}) end,
    create_world = function() game.third = World {} end,
    clone = function(s) body_of(s):clone() end,
    clone_world = function() world:clone() end,
    write_number = function(s) s.density = 3 end,
    write_plain_number = function(s) body_of(s).linear_damping = 3 end,
    write_vec = function(s) body_of(s).position = vec(9, 9) end,
    write_component = function(s) body_of(s).position.x = 9 end,
    write_velocity = function(s) body_of(s).velocity = vec(9, 9) end,
    write_text = function(s) body_of(s).type = "static" end,
    write_boolean = function(s) s.sensor = true end,
    write_color = function(s) s.color = "red" end,
    write_integer = function(s) s.mask = 0 end,
    write_list = function() world.bounds = { vec(-1, -1), vec(1, 1) } end,
    write_nothing_new = function(s) s.density = s.density end,
    reset = function(s) body_of(s).mass = nil end,
    wake = function(s) body_of(s).awake = false end,
    write_ad_hoc = function(s) body_of(s).lives = 3 end,
    write_elsewhere = function() game.second.other.mass = 3 end,
    write_service = function() time.paused = true end,
    write_gravity = function() world.gravity = vec(0, 0) end,
    write_many = function() world.stage:all("Circle"):set("density", 3) end,
    define_formula = function(s) s.density = formula(function() return 2 end) end,
    add_vertex = function() world.stage.hull[1]:add_vertex(vec(2, 2)) end,
    impulse = function(s) body_of(s):apply_impulse(vec(1, 0)) end,
    force = function(s) body_of(s):apply_force(vec(1, 0)) end,
    torque = function(s) body_of(s):apply_torque(1) end,
    explode = function() world:explode(vec(0, 0), 5, 1) end,
    edit = function(s) edit("density", function() s.density = 3 end) end,
    undo = function() undo() end,
    redo = function() redo() end,
    take_snapshot = function() snapshot() end,
    restore_snapshot = function() restore(held) end,
    go_back = function() rewind(0.1) end,
    go_to = function() time:go_to(1) end,
    save = function() save_game("asked") end,
    load = function() load_game("asked") end,
    load_scene = function() scene.load("some.json", world) end,
    timer = function() after(0, function() end) end,
    timers = function() every(0, function() end) end,
    watch_pattern = function() watch("world.**", function() end) end,
    watch_property = function(s) body_of(s):watch("mass", function() end) end,
    handle_event = function(s) body_of(s):on("woke", function() end) end,
    stop = function() connection:stop() end,
    define_class = function() class("Another", Body) {} end,
    give_function = function() Foe.contact_begin = function() end end,
    quit = function() quit(3) end,
}
names = {}
for name in pairs(changes) do names[#names + 1] = name end
table.sort(names)

-- All that a change could leave a trace in.
function state()
    local list = {}
    for _, top in ipairs({ world, game.second }) do
        list[#list + 1] = tostring(top.gravity) .. tostring(top.bounds)
        top:each(function(each)
            list[#list + 1] = tostring(each) .. each.class
            for _, property in ipairs(each:describe()) do
                if not tostring(each):find("step", 1, true) then
                    list[#list + 1] = property.name .. "=" .. tostring(each[property.name])
                end
            end
        end)
    end
    return table.concat(list, "\n") .. tostring(time.paused) .. tostring(time.step)
end
)lua";

const std::string scene_file = R"({"fettle_scene": 1, "class": "Body"})";

Outcome run(const Folder& folder, const std::string& script, int steps) {
    folder.write("some.json", scene_file);
    folder.write("main.lua", stage + script);
    return fettle(folder,
                  {"run", (folder / "").string(), "--headless", "--steps", std::to_string(steps)});
}

}  // namespace

TEST_CASE("a function called in a search is refused every change of the game") {
    const Folder folder;
    const Outcome done = run(folder, R"lua(
local queries = {
    raycast = function(accept) return world:raycast(vec(-9, -0.5), vec(9, -0.5), nil, nil, accept) end,
    raycast_all = function(accept) return world:raycast_all(vec(-9, -0.5), vec(9, -0.5), nil, nil, accept) end,
    closest = function(accept) return world:closest(vec(0, 0), 50, nil, nil, accept) end,
    at = function(accept) return world:at(vec(0, -0.5), nil, nil, accept) end,
    overlap = function(accept) return world:overlap(world.stage.hull, nil, nil, accept) end,
    overlap_shape = function(accept) return world:overlap(probe, nil, nil, accept) end,
    overlap_box = function(accept) return world:overlap_box(vec(-9, -9), vec(9, 9), nil, nil, accept) end,
    shapecast = function(accept) return world:shapecast(world.stage.hull, vec(0, -5), nil, nil, accept) end,
    explode = function(accept) return world:explode(vec(0, 0), 9, 0.01, nil, accept) end,
}
probe = Circle { radius = 9 }
local combinations, tried, bad = {}, 0, 0
for _, query in ipairs({ "raycast", "raycast_all", "closest", "at", "overlap", "overlap_shape",
                         "overlap_box", "shapecast", "explode" }) do
    for _, change in ipairs(names) do combinations[#combinations + 1] = { query, change } end
end
local function complain(...) bad = bad + 1 print(...) end
held = snapshot()
local number = 0
function step()
    number = number + 1
    if number > #combinations then
        if number == #combinations + 1 then print(tried >= 540 and tried == #combinations, bad) end
        return
    end
    local query, change = combinations[number][1], combinations[number][2]
    build()
    if query == "overlap" then world.stage.hull.position = vec(0, -0.7) end
    tried = tried + 1
    -- An error of the function is one of the search, and ends it.
    local before = state()
    local asked = 0
    local ok, problem = pcall(queries[query], function(shape) asked = asked + 1 changes[change](shape) return true end)
    if ok or not tostring(problem):find("calls `accept` in the middle of a search", 1, true) then
        complain(query, change, ok, problem)
    end
    if query ~= "explode" and state() ~= before then complain(query, change, "left a trace") end
    if asked ~= 1 then complain(query, change, "was asked again after its error", asked) end
    -- Caught by the function itself, the search goes on.
    asked = 0
    local again, result = pcall(queries[query], function(shape)
        asked = asked + 1
        local done, why = pcall(changes[change], shape)
        if done then complain(query, change, "was done") end
        return true
    end)
    if not again or asked == 0 then complain(query, change, "caught", result, asked) end
    if query ~= "explode" and state() ~= before then complain(query, change, "left a trace when caught") end
end
)lua",
                             640);
    CHECK(done.err.empty());
    CHECK(done.status == 0);
    CHECK(done.out == "true\t0\n");
}

TEST_CASE("a handler called in a step is refused every change of the game") {
    const Folder folder;
    const Outcome done = run(folder, R"lua(
local events = { "before_solve", "before_solve_shape", "mix_surfaces", "filter_pair" }
local combinations, bad, refused = {}, 0, 0
for _, event in ipairs(events) do
    for _, change in ipairs(names) do combinations[#combinations + 1] = { event, change } end
end
held = snapshot()
local number, before, answering = 0, nil, nil
function step()
    if answering then answering:stop() end
    if number > 0 and number <= #combinations and refused < number then
        bad = bad + 1
        print(combinations[number][1], combinations[number][2], "was not asked")
        refused = number
    end
    number = number + 1
    if number > #combinations then
        if number == #combinations + 1 then print(refused >= 240 and refused == #combinations, bad) end
        return
    end
    local event, change = combinations[number][1], combinations[number][2]
    build()
    local of = event == "before_solve" and world.stage.ball_2 or event == "before_solve_shape" and world.stage.ball_2[1] or world
    answering = of:on(event:gsub("_shape", ""), function(contact)
        if refused == number then return end
        refused = number
        local shape = contact.shape or contact.other_shape
        local ok, problem = pcall(changes[change], shape)
        if ok or not tostring(problem):find("is asked inside a step", 1, true) then
            bad = bad + 1
            print(event, change, ok, problem)
        end
    end)
end
)lua",
                             300);
    CHECK(done.err.empty());
    CHECK(done.status == 0);
    CHECK(done.out == "true\t0\n");
}

TEST_CASE("a function called in a search may read and search") {
    const Folder folder;
    const Outcome done = run(folder, R"lua(
build()
world.bounds = { vec(-20, -20), vec(20, 20) }
world.stage.hull.angle = formula(function() return world.stage.floor.position.x end)
world.stage.floor.position.x = 0.25
local log, notes = {}, {}
local function everything(shape)
    if shape == nil then notes.bounds = true return true end
    for _, each in ipairs({ shape, shape.parent, world }) do
        for _, property in ipairs(each:describe()) do log[#log + 1] = tostring(each[property.name]) end
    end
    log[#log + 1] = #shape.parent:touches() + #world:contacts() + math.random()
    notes.angle = world.stage.hull.angle
    notes.who = tostring(shape) ~= ""
    notes.nearest = world:closest(vec(0, 9), nil, nil, nil, function(s) return s.parent ~= world.stage.hull end).body.name
    collectgarbage()
    return false
end
print(world:raycast(vec(0, 9), vec(0, -90), nil, nil, everything).body == world)
print(notes.bounds, notes.angle, notes.who, notes.nearest, #log > 100)
-- Its own errors are those of the search, and it cannot wait.
print(select(2, pcall(function() world:at(vec(0, -2), nil, nil, function(s) return s.nonsense end) end)):match("nonsense: no such name"))
local waiting = coroutine.wrap(function() world:at(vec(0, -2), nil, nil, function() wait(1) end) end)
print(pcall(waiting))
local yielding = coroutine.wrap(function() world:at(vec(0, -2), nil, nil, function() coroutine.yield(1) end) end)
print(pcall(yielding))
-- A coroutine that begins in there goes on afterwards, and may do what it likes then.
local later
world.stage.hull.angle = 0  -- its formula reads what is deleted
world:at(vec(0, -2), nil, nil, function(s)
    later = coroutine.create(function() coroutine.yield() s.parent:delete() end)
    coroutine.resume(later)
end)
print(coroutine.resume(later), world.stage:has("floor"))
-- A search whose `accept` searches again is stopped by its depth.
local function deeper() return world:at(vec(0, 0.6), nil, nil, deeper) end
print(select(2, pcall(deeper)):match("stack overflow"))
print(world:at(vec(0, 0.6)).name)
)lua",
                             1);
    CHECK(done.err.empty());
    CHECK(contains(done.out, "true\ntrue\t0.25\ttrue\tball_2\ttrue\nnonsense: no such name\n"));
    CHECK(contains(done.out, "\nstack overflow\nhull\n"));
    CHECK(contains(done.out, "true\tfalse\n"));
}

TEST_CASE("an explosion that spares some bodies spares them again in a replay after rewinding") {
    const Folder folder;
    const Outcome done = run(folder, R"lua(
world.a = Body { position = vec(1, 5), Circle {} }
world.b = Body { position = vec(-1, 5), Circle {} }
local known, finished
function step()
    if time.step == 10 then
        world:explode(vec(0, 5), 9, 5, nil, function(shape) return shape.parent == world.a end)
    elseif time.step == 21 and not finished then
        known = { world.a.position, world.b.position }
    elseif time.step == 40 and known then
        time:go_to(20)
    end
end
game:on("restored", function()
    print(world.a.position == known[1], world.b.position == known[2], known[2].x == -1, known[1].x > 1.1)
    known, finished = nil, true
end)
)lua",
                             60);
    CHECK(done.err.empty());
    CHECK(done.out == "true\ttrue\ttrue\ttrue\n");
}

TEST_CASE("a function given as the wrong argument is reported with the right argument") {
    const Folder folder;
    const std::string game = folder.write(
        "main.lua", "world:raycast(vec(0, 0), vec(1, 0), function() return true end)\n");
    const Outcome outcome = fettle(folder, {"run", game, "--headless", "--steps", "1"});
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err,
               contains("world:raycast: argument 3 is a function; the function is argument 5, "
                        "accept: raycast(from, to [, mask] [, group] [, accept])"));
}

TEST_CASE("after a rewind the last writer is that of the moment before") {
    const Folder folder;
    const std::string game = folder.write("main.lua", "world.ball = Body { mass = 2 }\n");
    const Outcome outcome = fettle(
        folder, {"run", game, "--headless", "--steps", "60", "--console", "49:world.ball.mass = 5",
                 "--console", "50:who('world.ball.mass')", "--console", "50:rewind(0.5)",
                 "--console", "54:snapshot()", "--console", "55:why('world.ball.mass')"});
    CHECK_THAT(outcome.out, contains("world.ball.mass: console:1, step 4"));
    CHECK_THAT(outcome.out, contains("world.ball.mass: script, step 0"));
    CHECK_THAT(outcome.out, contains("› snapshot()\n  snapshot\n"));
}
}  // namespace asked_test
