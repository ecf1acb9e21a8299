-- A whole game of Fettle inside a game of LÖVE: `local game = require("fettle.host").new()`. Every function of fettle_host.h is
-- `host.lib.NAME`; `fettle.console` shows the console of a game.

local fettle = require "fettle"
local object = require "fettle.object"
local arguments = require "fettle.arguments"
local ffi = fettle.ffi
ffi.cdef(require "fettle.host_declarations")

local function open()
    local beside = love and love.filesystem.getSource() .. "/fettle/libfettle_host.so"
    local file = os.getenv("FETTLE_HOST_LIBRARY") or beside
    if file and io.open(file) then return ffi.load(file) end
    return ffi.load("libfettle_host.so.0.1")  -- where the system looks for libraries
end

local host = { lib = open() }
local lib, check = host.lib, fettle.check
local Game, Property = object.class "Game", object.class "Property"

-- Many of these calls call functions of Lua, which compiled code must not do.
local function interpreted(class)
    for _, f in pairs(class) do if type(f) == "function" then jit.off(f) end end
end

-- --- Values ---------------------------------------------------------------------------------------

local converters = {
    [lib.FETTLE_VALUE_BOOLEAN] = function(v) return v.as.boolean ~= 0 end,
    [lib.FETTLE_VALUE_INTEGER] = function(v) return tonumber(v.as.integer) end,
    [lib.FETTLE_VALUE_NUMBER] = function(v) return v.as.number end,
    [lib.FETTLE_VALUE_TEXT] = function(v) return ffi.string(v.as.text, v.count) end,
    [lib.FETTLE_VALUE_VEC2] = function(v) return { x = v.as.vec2[0], y = v.as.vec2[1] } end,
    [lib.FETTLE_VALUE_COLOR] = function(v)
        return { r = v.as.color[0], g = v.as.color[1], b = v.as.color[2], a = v.as.color[3] }
    end,
    [lib.FETTLE_VALUE_INSTANCE] = function(v) return v.as.instance + 0 end,
}

--- Nil, boolean, number, string, { x, y }, { r, g, b, a }, an instance (a number of 64 bits) or a list of these.
local function from_c(v)
    if v.type == lib.FETTLE_VALUE_LIST then
        local all = {}
        for i = 1, v.count do all[i] = from_c(v.as.list[i - 1]) end
        return all
    end
    local convert = converters[v.type]
    if convert then return convert(v) end
end

--- `kept` holds what the value points to.
local function to_c(value, v, kept)
    local kind = type(value)
    if kind == "nil" then
        v.type = lib.FETTLE_VALUE_NIL
    elseif kind == "boolean" then
        v.type, v.as.boolean = lib.FETTLE_VALUE_BOOLEAN, value and 1 or 0
    elseif kind == "number" then
        v.type, v.as.number = lib.FETTLE_VALUE_NUMBER, value
    elseif kind == "string" then
        kept[#kept + 1] = value
        v.type, v.as.text, v.count = lib.FETTLE_VALUE_TEXT, value, #value
    elseif kind == "cdata" then
        v.type, v.as.instance = lib.FETTLE_VALUE_INSTANCE, value
    elseif kind == "table" and value.x and value.y then
        v.type, v.as.vec2[0], v.as.vec2[1] = lib.FETTLE_VALUE_VEC2, value.x, value.y
    elseif kind == "table" and value.r then
        v.type = lib.FETTLE_VALUE_COLOR
        v.as.color[0], v.as.color[1], v.as.color[2], v.as.color[3] = value.r, value.g, value.b, value.a or 1
    elseif kind == "table" then
        local list = ffi.new("fettle_hosted_value[?]", math.max(#value, 1))
        kept[#kept + 1] = list
        for i, element in ipairs(value) do to_c(element, list[i - 1], kept) end
        v.type, v.as.list, v.count = lib.FETTLE_VALUE_LIST, list, #value
    else
        error("a value of the type " .. kind .. " cannot be given to a game of Fettle", 3)
    end
    return v
end

local function arguments_of(...)
    local kept, count = {}, select("#", ...)
    local all = ffi.new("fettle_hosted_value[?]", math.max(count, 1))
    for i = 1, count do to_c((select(i, ...)), all[i - 1], kept) end
    return all, count, kept
end

-- To be called after the call in C that uses what `kept` refers to: until then the garbage collector must not free it.
local function keep_until_here(_kept) return nil end

local function one(value)
    local kept = {}
    return to_c(value, ffi.new("fettle_hosted_value"), kept), kept
end

-- --- Functions of LÖVE --------------------------------------------------------------------------

-- One function of C for all: LuaJIT has room for some hundred, and never frees what they refer to.
local functions, last_function = {}, 0  -- those of all games, by number
local kept = {}  -- what the last result refers to: C reads it after the function has returned
local call_function = ffi.cast("fettle_function_callback", function(user, arguments, count, result)
    kept = {}
    local all = {}
    for i = 1, count do all[i] = from_c(arguments[i - 1]) end
    -- An error must not pass through C.
    local ok, value = pcall(functions[tonumber(ffi.cast("intptr_t", user))], unpack(all, 1, count))
    local converted = pcall(to_c, ok and value or nil, result, kept)
    if ok and converted then return lib.FETTLE_DONE end
    to_c(ok and "the function gives a value that a game cannot have" or tostring(value), result, kept)
    return lib.FETTLE_FAILED
end)

-- --- Games ----------------------------------------------------------------------------------------

--- A new game. `settings`: members of fettle_hosted_def, `{ seed = 3, console = false }`.
function host.new(settings)
    local def = fettle.define_in(lib, "fettle_hosted_def")
    for name, value in pairs(settings or {}) do def[name] = value end
    local out = ffi.new("fettle_hosted*[1]")
    check(lib.fettle_hosted_create(def, out), 2)
    local game = setmetatable({ pointer = out[0], functions = {} }, Game)
    game.collected = newproxy(true)
    getmetatable(game.collected).__gc = function() pcall(game.close, game) end
    return game
end

--- Ends the game. That happens anyway when nothing refers to the game any more, and at the end of the program.
function Game:close()
    check(lib.fettle_hosted_destroy(self.pointer), 2)
    for _, number in pairs(self.functions) do functions[number] = nil end
    self.functions = {}
end

--- Runs Lua 5.4 of Fettle; `name` is in its errors.
function Game:run(lua, name) check(lib.fettle_hosted_run(self.pointer, lua, name), 2) end
function Game:load(path) check(lib.fettle_hosted_load(self.pointer, path), 2) end
function Game:reload() check(lib.fettle_hosted_reload(self.pointer), 2) end

--- Calls a global function of the game.
function Game:call(name, ...)
    local all, count, kept = arguments_of(...)
    check(lib.fettle_hosted_call(self.pointer, name, all, count), 2)
    return keep_until_here(kept)
end

--- A command as in the console. Returns its value and what it prints.
function Game:evaluate(command)
    local result, output = ffi.new("fettle_hosted_value"), ffi.new("const char*[1]")
    check(lib.fettle_hosted_evaluate(self.pointer, command, result, output), 2)
    return from_c(result), ffi.string(output[0])
end

--- Gives the scripts of the game a function of LÖVE.
function Game:add_function(name, f)
    local number = last_function + 1
    functions[number], last_function = f, number
    local code = lib.fettle_hosted_add_function(self.pointer, name, call_function, ffi.cast("void*", number))
    local unused = number
    if code == lib.FETTLE_DONE then  -- the game calls the last one of a name
        unused, self.functions[name] = self.functions[name], number
    end
    if unused then functions[unused] = nil end
    check(code, 2)
end

--- One frame, `dt` seconds after the last one. Returns the number of fixed steps that were made.
function Game:frame(dt)
    local steps = ffi.new("uint32_t[1]")
    check(lib.fettle_hosted_frame(self.pointer, dt, steps), 2)
    return steps[0]
end

function Game:get(path)
    local value = ffi.new("fettle_hosted_value")
    check(lib.fettle_hosted_get(self.pointer, path, value), 2)
    return from_c(value)
end

function Game:set(path, value)
    local c_value, kept = one(value)
    check(lib.fettle_hosted_set(self.pointer, path, c_value), 2)
    return keep_until_here(kept)
end

--- Paths of the children of an instance, in order.
function Game:children(path)
    local instance = fettle.get("fettle_instance", lib.fettle_hosted_find, self.pointer, path)
    local count = ffi.new("uint32_t[1]")
    check(lib.fettle_hosted_children(self.pointer, instance, nil, 0, count), 2)
    local out, text = ffi.new("fettle_instance[?]", math.max(count[0], 1)), ffi.new("const char*[1]")
    check(lib.fettle_hosted_children(self.pointer, instance, out, count[0], count), 2)
    local all = {}
    for i = 1, count[0] do
        check(lib.fettle_hosted_path(self.pointer, out[i - 1], text), 2)
        all[i] = ffi.string(text[0])
    end
    return all
end

--- A handle of a property, for fast reads.
function Game:property(path)
    local out = ffi.new("fettle_property_id[1]")
    check(lib.fettle_property_at(self.pointer, path, out), 2)
    return setmetatable({ game = self.pointer, id = out[0] }, Property)
end

local x, y = ffi.new("double[1]"), ffi.new("double[1]")

function Property:number()
    check(lib.fettle_property_get_number(self.game, self.id, x), 2)
    return x[0]
end
function Property:vec2()
    check(lib.fettle_property_get_vec2(self.game, self.id, x, y), 2)
    return x[0], y[0]
end
function Property:get()
    local value = ffi.new("fettle_hosted_value")
    check(lib.fettle_property_get(self.game, self.id, value), 2)
    return from_c(value)
end
function Property:set(value)
    local c_value, kept = one(value)
    check(lib.fettle_property_set(self.game, self.id, c_value), 2)
    return keep_until_here(kept)
end
--- False when the instance was deleted.
function Property:exists()
    return lib.fettle_property_get(self.game, self.id, ffi.new("fettle_hosted_value")) ~= lib.FETTLE_STALE
end

interpreted(Game)
arguments.of_class(Game, {
    run = "lua string, name string?", load = "path string", call = "name string, ...", evaluate = "command string",
    add_function = "name string, f function", frame = "dt number", get = "path string", set = "path string, ...",
    children = "path string", property = "path string",
})
arguments.of_class(Property, {})
interpreted(Game)
jit.off(Property.get)
jit.off(Property.set)
host.Game = Game
return host
