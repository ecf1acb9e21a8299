// Calls every function and method of the reference in a formula. A formula computes a value and
// changes nothing.

#include <algorithm>
#include <fstream>
#include <set>

#include "catch.h"
#include "patterns.h"
#include "program.h"

namespace formula_effects_test {

using namespace program_test;

namespace {

struct Names {
    std::vector<std::string> functions;  // "after", "string.rep"
    std::vector<std::string> methods;    // "Body:apply_impulse", "Pen.circle"
};

Names names_of_the_reference() {
    Names names;
    std::ifstream file("docs/reference/fettle.lua");
    const std::string line = R"(^function ([A-Za-z_0-9]+)(?:([.:])([a-z_0-9]+))?\()";
    std::set<std::string> callbacks = {"start",
                                       "update",
                                       "step",
                                       "draw",
                                       "draw_behind",
                                       "key_pressed",
                                       "key_released",
                                       "text_input",
                                       "mouse_pressed",
                                       "mouse_released",
                                       "mouse_moved",
                                       "wheel",
                                       "gamepad_pressed",
                                       "gamepad_released",
                                       "gamepad_axis",
                                       "action_pressed",
                                       "action_released",
                                       "resized",
                                       "focus",
                                       "closing",
                                       "enter",
                                       "leave",
                                       "reloaded"};
    for (std::string text; std::getline(file, text);) {
        const patterns::Match found = patterns::first(text, line);
        if (found.empty()) continue;
        const std::string owner = found[1], mark = found[2], member = found[3];
        if (member.empty()) {
            if (!callbacks.contains(owner)) names.functions.push_back(owner);
        } else if (owner.starts_with("fettle_") || mark == ":") {
            names.methods.push_back((owner.starts_with("fettle_") ? owner.substr(7) : owner) +
                                    mark + member);
        } else {
            names.functions.push_back(owner + "." + member);
        }
    }
    return names;
}

std::string lua_list(const std::vector<std::string>& names) {
    std::string text = "{";
    for (const std::string& name : names) text += "\"" + name + "\",";
    return text + "}";
}

// Functions that compute a value and change nothing; all others must be refused.
const char* const pure = R"lua(
local pure = {}
for name in ([[assert collectgarbage color deg error formula getmetatable ipairs load next pairs
    pcall print query rawequal rawget rawlen rawset require saves select setmetatable tonumber
    tostring type vec xpcall
    vec:angle vec:cross vec:distance vec:dot vec:floor vec:length vec:lerp vec:limited
    vec:normalized vec:rotated vec:round color:lerp
    Set:each Connection:active
    Object:alive Object:all Object:children Object:describe Object:each Object:find Object:formula
    Object:has Object:is_a Object:problem]]):gmatch("%S+") do pure[name] = true end
for _, library in ipairs { "coroutine", "math", "os", "string", "table", "utf8" } do
    for name in pairs(_G[library]) do pure[library .. "." .. name] = true end
end
pure["math.random"], pure["math.randomseed"] = nil, nil
)lua";

const char* const the_test = R"lua(
world.ball = Body { Circle {} }
world.probe = Object { value = 0 }
world.other = Object { value = 0 }
world.joint = DistanceJoint { body_a = world.ball, body_b = world:add(Body { Circle {} }) }
local ball = world.ball
local connection = after(1e6, print)
local values = { vec = vec(1, 2), color = color("red"), Set = world:find("Body"),
                 Connection = connection, Snapshot = snapshot(), Class = Body, Game = game, Store = store,
                 SoundSource = Synth {}, Widget = Button {} }

-- An instance of a class, or a value of a kind.
local function one_of(kind)
    if values[kind] ~= nil then return values[kind] end
    if kind == "Object" then return world.other end
    for _, each in ipairs(game:find("Object")) do if each:is_a(kind) then return each end end
    return _G[kind] {}
end

local function call(callable, label, ...)
    local arguments = table.pack(...)
    local reported
    world.probe.value = formula(function()
        local ok, message = pcall(callable, table.unpack(arguments, 1, arguments.n))
        if not ok then reported = message end
        return world.ball.mass
    end)
    local value = world.probe.value
    if value ~= world.ball.mass then print("WRONG VALUE", label, value) end
    return tostring(reported)
end

local refusal = "the formula of world.probe.value computes a value: it cannot call "
local function check(callable, label, name, self)
    local nothing = function() end
    local tries = { { self }, { self, "world.*.mass", nothing }, { self, 1, nothing },
                    { self, "Zed", Object }, { self, vec(0, 1), vec(1, 1) }, { self, world.other } }
    if self == nil then
        tries = { {}, { "world.*.mass", nothing }, { 1, nothing }, { "Zed", Object },
                  { "world.other.value" }, { values.Snapshot }, { 0 } }
    end
    for _, arguments in ipairs(tries) do
        local reported = call(callable, label, table.unpack(arguments))
        local refused = reported:find(refusal .. name, 1, true) ~= nil
        if pure[label] and refused then print("REFUSED", label) end
        if not pure[label] and not refused then print("NOT REFUSED", label, reported) end
    end
end

local changing = {}
function draw(pen) values.Pen = pen end

function start()
    for _, name in ipairs(functions) do
        local library, field = name:match("^(%w+)%.(.*)$")
        local callable = library and _G[library][field] or _G[name]
        if callable == nil then print("MISSING", name)
        else check(callable, name, name) end
    end
    for _, name in ipairs(methods) do
        local kind, mark, field = name:match("^(%w+)([.:])(.*)$")
        if kind ~= "Pen" then
            local self = one_of(kind)
            local label = name
            -- A class says itself what its methods change.
            local declared, method = pcall(function() return classes[kind].methods[field] end)
            if declared then
                pure[name] = method.pure
                if not method.pure then changing[#changing + 1] = name end
            end
            check(self[field], label, field, self)
        end
    end
    table.sort(changing)
    print(table.concat(changing, " "))
    print("done", #functions, #methods)
    quit()
end
)lua";

}  // namespace

TEST_CASE("a formula can call functions that compute a value and none that changes anything") {
    const Names names = names_of_the_reference();
    REQUIRE(names.functions.size() > 100);
    REQUIRE(names.methods.size() > 50);
    const Folder folder;
    const std::string game = folder.write("main.lua", "functions = " + lua_list(names.functions) +
                                                          "\nmethods = " + lua_list(names.methods) +
                                                          "\n" + pure + the_test);
    const Outcome outcome = fettle(folder, {"run", game, "--headless", "--steps", "2"});
    CHECK(without_notes(outcome.err) == "");
    CHECK(outcome.status == 0);
    for (const char* wrong : {"REFUSED", "MISSING", "WRONG VALUE"}) {
        const std::size_t at = outcome.out.find(wrong);
        INFO(outcome.out.substr(std::min(at, outcome.out.size()), 1000));
        CHECK(at == std::string::npos);
    }
    INFO(outcome.out);
    // A new method that changes something must be added here.
    CHECK(contains(outcome.out,
                   "\nAudio:stop Body:apply_angular_impulse Body:apply_force Body:apply_impulse "
                   "Body:apply_torque Camera:shake Emitter:clear Emitter:emit Interface:prefer "
                   "Mover:drop Mover:jump "
                   "Polygon:add_vertex "
                   "SoundSource:play "
                   "SoundSource:stop Synth:mutate Synth:preset Tilemap:reload Tilemap:set_tile "
                   "Tilemap:set_tiles "
                   "Time:forget_branch Time:go_to Time:name_branch Time:switch_to "
                   "Tween:stop TweenGroup:stop View:shake Voice:stop Widget:focus World:explode "
                   "World:explode_surfaces\ndone\t"));
}

TEST_CASE("a formula that pushes a body moves nothing and reports the reason") {
    const Folder folder;
    const std::string game = folder.write("main.lua", R"lua(
world.gravity = vec(0, 0)
world.b = Body { Circle {} }
world.b.gravity_scale = formula(function() world.b:apply_impulse(vec(0, 10)) return time.step end)
function step() if time.step == 20 then print(world.b.velocity, world.b:problem("gravity_scale")) end end
)lua");
    const Outcome outcome = fettle(folder, {"run", game, "--headless", "--steps", "20"});
    CHECK(outcome.status == 0);
    CHECK(outcome.out ==
          "vec(0, 0)\tmain.lua:4: the formula of world.b.gravity_scale computes a value: it cannot "
          "call apply_impulse\n");
}

TEST_CASE("a cycle of formulas over values of the simulation is not reported in each step") {
    const Folder folder;
    folder.write("main.lua",
                 "world.box = Body { position = vec(4, 3), Box {} }\n"
                 "world.foe = Body { position = vec(0, 3), Box {}, angular_velocity = 1 }\n"
                 "world.box.position = formula(function() return world.foe.position end)\n"
                 "world.foe.position = formula(function() return world.box.position end)\n");
    const Outcome run =
        fettle(folder, {"run", (folder / "main.lua").string(), "--headless", "--steps", "60"});
    std::size_t lines = 0;
    for (const std::string& text : {run.out, run.err})
        for (std::size_t at = text.find("depends on itself"); at != std::string::npos;
             at = text.find("depends on itself", at + 1))
            ++lines;
    INFO(run.out << run.err);
    CHECK(lines >= 1);
    CHECK(lines <= 2);
}

TEST_CASE("an error of a formula that moves to another line or name is reported again") {
    const Folder folder;
    folder.write("main.lua",
                 "world.n = 0\n"
                 "world.a = formula(function()\n"
                 "    if world.n == 1 then return world.q1.x end\n"
                 "    if world.n == 2 then return world.q2.x end\n"
                 "    error('value ' .. world.n * -1.5e10)\n"
                 "end)\n"
                 "function step() world.n = time.step // 10 end\n");
    const Outcome run =
        fettle(folder, {"run", (folder / "main.lua").string(), "--headless", "--steps", "80"});
    INFO(run.out << run.err);
    const std::string all = run.out + run.err;
    const auto count = [&](const std::string& what) {
        std::size_t n = 0;
        for (std::size_t at = all.find(what); at != std::string::npos; at = all.find(what, at + 1))
            ++n;
        return n;
    };
    CHECK(count("main.lua:3:") >= 1);
    CHECK(count("main.lua:4:") >= 1);
    CHECK(count("main.lua:5: value") <= 3);
}

}  // namespace formula_effects_test
