-- Fettle's physics library in LuaJIT: `local fettle = require "fettle"`. Every function of fettle_physics.h is `fettle.lib.NAME`;
-- `fettle.check` makes an error of a code. `fettle.physics` has the calls of `love.physics`.

local ffi = require "ffi"
ffi.cdef(require "fettle.declarations")

local function open()
    local beside = love and love.filesystem.getSource() .. "/fettle/libfettle_physics_c.so"
    local file = os.getenv("FETTLE_LIBRARY") or beside
    if file and io.open(file) then return ffi.load(file) end
    return ffi.load("libfettle_physics_c.so.0.1")  -- where the system looks for libraries
end

local fettle = { lib = open(), ffi = ffi }
local lib = fettle.lib

--- Raises the message of the library unless the code is FETTLE_DONE.
function fettle.check(code, level)
    if code ~= lib.FETTLE_DONE then error(ffi.string(lib.fettle_last_error()), (level or 1) + 1) end
end

--- A definition of a library with its defaults.
function fettle.define_in(of, name, ...)
    local made = ffi.new(name)
    fettle.check(of[name .. "_init"](made, ffi.sizeof(name), ...))
    return made
end

--- The same of this library: fettle.define("fettle_body_def"), fettle.define("fettle_geometry", type).
function fettle.define(name, ...) return fettle.define_in(lib, name, ...) end

local outs = {}

--- Calls a function whose last parameter is a pointer to a result of a C type, and returns the result.
function fettle.get(ctype, f, ...)
    local out = outs[ctype]
    if not out then
        out = ffi.new(ctype .. "[1]")
        outs[ctype] = out
    end
    local n = select("#", ...)
    if n == 2 then
        local a, b = ...
        fettle.check(f(a, b, out), 2)
    else
        local arguments = { ... }
        arguments[n + 1] = out
        fettle.check(f(unpack(arguments, 1, n + 1)), 2)
    end
    return out[0]
end

--- All ids of a list: fettle.ids(lib.fettle_world_bodies, world).
function fettle.ids(f, ...)
    local arguments, n = { ... }, select("#", ...)
    local count, room = ffi.new("uint32_t[1]"), 16
    while true do
        local out = ffi.new("fettle_id[?]", room)
        arguments[n + 1], arguments[n + 2], arguments[n + 3] = out, room, count
        fettle.check(f(unpack(arguments, 1, n + 3)), 2)
        if count[0] <= room then
            local found = {}
            for i = 1, count[0] do found[i] = out[i - 1] end
            return found
        end
        room = count[0]
    end
end

return fettle
