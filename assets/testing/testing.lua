-- The functions of tests: test, expect, and the object t. `fettle test` runs this file after the game, and then a
-- file of tests. A test is a coroutine: while it waits, the game makes a step. `fettle_test` is a function of the host.

local tests, names = {}, {}
local running, thread

function test(name, body)
    if type(name) ~= "string" or name == "" then
        error("test: the first argument is the name of the test", 2)
    end
    if type(body) ~= "function" then
        error("test: the second argument is the function of the test, which gets t", 2)
    end
    if running then error("test: a test cannot make another one; write it beside this one", 2) end
    if tests[name] then error("test: there are two tests with the name \"" .. name .. "\"", 2) end
    tests[name] = body
    names[#names + 1] = name
    fettle_test("test", name)
end

function fettle_test_begin(name)
    local body = tests[name]
    if not body then error("there is no test \"" .. name .. "\" in this file") end
    running = coroutine.wrap(function()
        thread = coroutine.running()
        body(fettle_test_object)
        fettle_test("done")
    end)
end

-- A test waits for steps, which the driver counts; a coroutine that waits for time cannot be gone on with.
local wait_for_time = wait
function wait(...)
    if thread and coroutine.running() == thread then
        error("wait: a test waits with t:wait(seconds) or t:steps(number)", 2)
    end
    return wait_for_time(...)
end

-- Goes on with the test before a step. `answer`: why a picture differs, or nil.
function fettle_test_turn(answer)
    if running then running(answer) end
end

-- Values in messages --------------------------------------------------------------------------------------------

local function shown(value, exact, depth)
    depth = depth or 0
    if type(value) == "string" then return "\"" .. value .. "\"" end
    if value ~= value and type(value) == "number" then return "nan" end
    if type(value) == "function" then return "a function" end
    if exact and math.type(value) == "float" then return string.format("%.17g", value) end
    if type(value) ~= "table" or depth > 4 then return tostring(value) end
    local parts, length = {}, 0
    for key, each in pairs(value) do
        local text = shown(each, exact, depth + 1)
        if key == length + 1 then
            length = key
        else
            text = "[" .. shown(key) .. "] = " .. text
        end
        parts[#parts + 1] = text
    end
    return "{" .. table.concat(parts, ", ") .. "}"
end

local function both(wanted, got, words)
    local a, b = shown(wanted), shown(got)
    if a == b then a, b = shown(wanted, true), shown(got, true) end
    return "expected " .. (words or "") .. a .. ", got " .. b
end

-- A list of a property or a table of the store as a table; anything else as it is.
local function plain(value)
    local kind = type(value) == "userdata" and getmetatable(value)
    if kind ~= "list" and kind ~= "store" then return value end
    local copy = {}
    for key, each in pairs(value) do copy[key] = each end
    return copy
end

local function equal(a, b, depth)
    if a == b then return true end
    a, b = plain(a), plain(b)
    if type(a) ~= "table" or type(b) ~= "table" or depth > 20 then return false end
    for key, value in pairs(a) do
        if not equal(value, b[key], depth + 1) then return false end
    end
    for key in pairs(b) do
        if a[key] == nil then return false end
    end
    return true
end

-- How far two numbers or two vecs are from each other; nil for other values.
local function distance(a, b)
    if type(a) == "number" and type(b) == "number" then return math.abs(a - b) end
    local ok, length = pcall(function() return (a - b):length() end)
    return ok and length or nil
end

-- The function of that name; an unknown name is an error, two calls above, that lists the known ones.
local function member(members, name, noun)
    local found = members[name]
    if found then return found end
    local known = {}
    for each in pairs(members) do known[#known + 1] = each end
    error(noun .. " has no " .. tostring(name) .. "; it has " .. table.concat(known, ", "), 3)
end

-- expect --------------------------------------------------------------------------------------------------------

local expectations = {}

-- expect(1).is(2) gives the wanted value in the place of the object.
local function check_colon(object, name)
    if type(object) ~= "table" or rawget(object, "is_expectation") == nil then
        error(name .. ": call it with a colon, as in expect(x):" .. name .. "(...)", 3)
    end
end

function expectations:is(wanted)
    check_colon(self, "is")
    if not equal(self.value, wanted, 0) then error(both(wanted, self.value), 2) end
end

function expectations:is_not(other)
    check_colon(self, "is_not")
    if equal(self.value, other, 0) then error("expected anything but " .. shown(other), 2) end
end

function expectations:near(wanted, tolerance)
    check_colon(self, "near")
    tolerance = tolerance or 0.001
    if type(tolerance) ~= "number" then error("near needs a tolerance that is a number, not " .. shown(tolerance), 2) end
    local apart = distance(self.value, wanted)
    if not apart then
        error("near compares two numbers or two vecs, not " .. shown(self.value) .. " with " .. shown(wanted), 2)
    end
    if not (apart <= tolerance) then
        error(both(wanted, self.value) .. ", which is " .. shown(apart) .. " away; " .. tostring(tolerance) ..
            " is allowed", 2)
    end
end

function expectations:above(limit)
    check_colon(self, "above")
    if type(self.value) ~= "number" or not (self.value > limit) then
        error(both(limit, self.value, "more than "), 2)
    end
end

function expectations:below(limit)
    check_colon(self, "below")
    if type(self.value) ~= "number" or not (self.value < limit) then
        error(both(limit, self.value, "less than "), 2)
    end
end

function expectations:truthy()
    check_colon(self, "truthy")
    if not self.value then error("expected a value that is true, got " .. shown(self.value), 2) end
end

function expectations:falsy()
    check_colon(self, "falsy")
    if self.value then error("expected false or nil, got " .. shown(self.value), 2) end
end

function expectations:contains(part)
    check_colon(self, "contains")
    local found = false
    if type(self.value) == "string" then
        if type(part) ~= "string" then error("contains needs a part that is a text, not " .. shown(part), 2) end
        found = string.find(self.value, part, 1, true)
    else
        local ok = pcall(function()
            for _, each in pairs(self.value) do found = found or equal(each, part, 0) end
        end)
        if not ok then error("contains needs a text or a table, not " .. shown(self.value), 2) end
    end
    if not found then error("expected " .. shown(part) .. " in " .. shown(self.value), 2) end
end

function expectations:fails(part)
    check_colon(self, "fails")
    if type(self.value) ~= "function" then error("fails needs a function: expect(function() ... end):fails()", 2) end
    if part ~= nil and type(part) ~= "string" then
        error("fails needs a part of the message, not " .. shown(part), 2)
    end
    local ok, why = pcall(self.value)
    if ok then error("expected an error, and there was none", 2) end
    if part and not string.find(tostring(why), part, 1, true) then
        error("expected an error with " .. shown(part) .. ", got " .. shown(tostring(why)), 2)
    end
end

local expectation = {
    __index = function(_, name)
        if name == "value" then return nil end
        local found = member(expectations, name, "expect")  -- no tail call, which would lose the line of the test
        return found
    end
}

function expect(...)
    if select("#", ...) == 0 then error("expect: needs the value that is tested", 2) end
    return setmetatable({ value = (...), is_expectation = true }, expectation)
end

-- t -------------------------------------------------------------------------------------------------------------

local t = {}

local function check_number(value, what, level)
    if type(value) ~= "number" or value ~= value or value < 0 or value == math.huge then
        error(what .. ", not " .. shown(value), level + 1)
    end
end

-- Sets a property of the input. An error is one of the line of the test.
local function set_input(device, name, value)
    local ok, why = pcall(function() device[name] = value end)
    if not ok then error((string.gsub(tostring(why), "^[%w_/.-]+%.lua:%d+: ", "")), 3) end
end

-- A press of a key or button that is down already would be none.
local function check_up(device, name, what)
    local ok, down = pcall(function() return device[name] end)
    if ok and down == true then
        error(what .. ": " .. tostring(name) .. " is held down already; release it first", 3)
    end
end

local function check_count(value, what, level)
    check_number(value, what, level + 1)
    if value ~= math.floor(value) then error(what .. ", a whole one, not " .. shown(value), level + 1) end
end

local function wait_steps(count)
    for _ = 1, count do coroutine.yield() end
end

function t:steps(count)
    check_count(count, "t:steps needs a number of steps", 2)
    wait_steps(count)
end

function t:wait(seconds)
    check_number(seconds, "t:wait needs a time in seconds", 2)
    wait_steps(math.ceil(seconds / game.time.dt - 1e-9))
end

function t:wait_until(condition, seconds)
    seconds = seconds or 10
    check_number(seconds, "t:wait_until needs a time in seconds", 2)
    if type(condition) ~= "function" then
        error("t:wait_until needs a function that returns whether it has come true, not " .. shown(condition), 2)
    end
    for _ = 1, math.ceil(seconds / game.time.dt - 1e-9) do
        if condition() then return end
        coroutine.yield()
    end
    if not condition() then
        error("what the test waits for did not come true within " .. tostring(seconds) .. " s", 2)
    end
end

-- The game must call quit(), at once or in the step that the action waits for. The test ends there.
function t:quits(action)
    if type(action) ~= "function" then
        error("t:quits needs a function after which the game calls quit(), not " .. shown(action), 2)
    end
    fettle_test("quits")
    action()
    coroutine.yield()
    error("the game did not call quit()", 2)
end

function t:press(key) set_input(game.input.keys, key, true) end
function t:release(key) set_input(game.input.keys, key, false) end

function t:hold(key, steps)
    check_count(steps, "t:hold needs a key and a number of steps", 2)
    check_up(game.input.keys, key, "t:hold")
    set_input(game.input.keys, key, true)
    wait_steps(steps)
    set_input(game.input.keys, key, false)
end

function t:tap(key)
    check_up(game.input.keys, key, "t:tap")
    set_input(game.input.keys, key, true)
    coroutine.yield()
    set_input(game.input.keys, key, false)
    coroutine.yield()
end

local function is_widget(target)
    local ok, known = pcall(function() return target:is_a("Widget") end)
    return ok and known
end

-- Why a player cannot point at the middle of a widget; nil if one can.
local function out_of_reach(widget, middle)
    if not widget.shown then
        local each = widget
        while is_widget(each) do
            if not each.visible then return tostring(each) .. ".visible is false" end
            each = each.parent
        end
        return "it is not below game, or not in a widget that shows it"
    end
    local size = game.view.screen
    if middle.x < 0 or middle.y < 0 or middle.x >= size.x or middle.y >= size.y then
        return "its middle, " .. tostring(middle) .. ", is outside of the screen, which has " .. tostring(size)
    end
end

-- A point of the world, or the middle of a widget.
local function point_at(target, what, level)
    local ok, middle = is_widget(target), nil
    if not ok and getmetatable(target) ~= "vec" then
        error(what .. ": needs a point of the world or a widget, not " .. shown(target), level + 1)
    end
    if ok then
        middle = target.screen_position + 0.5 * target.screen_size
        local why = out_of_reach(target, middle)
        if why then error(what .. ": " .. tostring(target) .. " cannot be seen: " .. why, level + 1) end
    end
    local ok_set, why = pcall(function()
        if ok then
            game.input.mouse.screen = middle
        else
            game.input.mouse.world = target
        end
    end)
    if not ok_set then error((string.gsub(tostring(why), "^[%w_/.-]+%.lua:%d+: ", "")), level + 1) end
end

function t:move_mouse(position) point_at(position, "t:move_mouse", 2) end

-- Labels, pictures and bars let the mouse through.
local function takes_clicks(target)
    for _, class in ipairs { "Button", "Toggle", "Slider", "TextField", "List" } do
        if target:is_a(class) then return true end
    end
end

function t:click(position, button)
    check_up(game.input.mouse, button or "left", "t:click")
    point_at(position, "t:click", 2)
    set_input(game.input.mouse, button or "left", true)
    coroutine.yield()
    local covered = is_widget(position) and position:alive() and takes_clicks(position) and
        not (position.held or position.hovered)
    set_input(game.input.mouse, button or "left", false)
    coroutine.yield()
    if covered then
        error("t:click: the click did not reach " .. tostring(position) ..
            ": another widget or a modal menu is over it, or it is scrolled out of a list", 2)
    end
end

function t:type(text)
    if type(text) ~= "string" then error("t:type needs a text, not " .. shown(text), 2) end
    fettle_test("type", text)
    coroutine.yield()
end

-- The step in which the game goes back is a paused one, so that the test sees the state of the past.
function t:rewind(seconds)
    check_number(seconds, "t:rewind needs a time in seconds", 2)
    local paused = game.time.paused
    game.time.paused = true
    rewind(seconds)
    coroutine.yield()
    game.time.paused = paused
end

function t:screenshot(name, tolerance)
    if type(name) ~= "string" or not string.find(name, "^[%w_-]+$") then
        error("t:screenshot needs a name of letters, digits, - and _, not " .. shown(name), 2)
    end
    tolerance = tolerance or 0.001
    check_number(tolerance, "t:screenshot needs the share of pixels that may differ", 2)
    fettle_test("picture", name, tolerance)
    local why = coroutine.yield()
    if why then error(why, 2) end
end

fettle_test_object = setmetatable({}, {
    __index = function(_, name)
        local found = member(t, name, "t")
        return found
    end
})
