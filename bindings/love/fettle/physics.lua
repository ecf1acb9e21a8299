-- The calls of love.physics on Fettle's bodies: in a game of LÖVE,
--
--     love.physics = require "fettle.physics"
--
-- Differences that a game can notice: beginContact, endContact and postSolve are called when the step is done, so they may
-- destroy bodies; only preSolve and the filter are called inside it, and must not. A chain is solid on both sides, as in LÖVE.

local fettle = require "fettle"
local units = require "fettle.units"
local object = require "fettle.object"
local arguments = require "fettle.arguments"
local shapes = require "fettle.shapes"
local fixture = require "fettle.fixture"
local joints = require "fettle.joints"
local Contact = require "fettle.contact"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local physics = { newBody = require "fettle.body", newFixture = fixture.newFixture, getDistance = fixture.getDistance }
for _, module in ipairs { shapes, joints } do
    for name, f in pairs(module) do
        if name:find "^new" then physics[name] = f end
    end
end

function physics.setMeter(pixels)
    if not (pixels >= 1) then error("expected at least 1 pixel, got " .. tostring(pixels), 2) end
    units.meter = pixels
end
function physics.getMeter() return units.meter end

local World = object.class "World"

local worlds = setmetatable({}, { __mode = "v" })  -- by their addresses in C
local function address_of(pointer) return tonumber(ffi.cast("intptr_t", pointer)) end

function physics.newWorld(x, y, sleep)
    local def = fettle.define("fettle_world_def")
    def.gravity.x, def.gravity.y = (x or 0) / units.meter, (y or 0) / units.meter
    def.sleeping = sleep ~= false
    local out = ffi.new("fettle_world*[1]")
    check(lib.fettle_world_create(def, out), 2)
    local pointer = ffi.gc(out[0], lib.fettle_world_destroy)
    -- Objects by slot: a number is a key, an id of 64 bits is not.
    local world = setmetatable({ pointer = pointer, bodies = {}, fixtures = {}, joints = {}, callbacks = {}, dt = 1 / 60 }, World)
    worlds[address_of(pointer)] = world
    return world
end

function World:isDestroyed() return self.destroyed or false end
function World:destroy()
    check(lib.fettle_world_destroy(ffi.gc(self.pointer, nil)), 2)
    self.pointer = ffi.cast("fettle_world*", nil)  -- a later world may get the memory
    self.destroyed = true
end

function World:getGravity()
    local g = fettle.get("fettle_vec2", function(world, _, out) return lib.fettle_world_gravity(world, out) end,
        self.pointer, nil)
    return g.x * units.meter, g.y * units.meter
end
function World:setGravity(x, y) check(lib.fettle_world_set_gravity(self.pointer, x / units.meter, y / units.meter), 2) end
function World:setSleepingAllowed(allowed) check(lib.fettle_world_set_sleeping(self.pointer, allowed), 2) end
function World:isSleepingAllowed()
    local out = ffi.new("bool[1]")
    check(lib.fettle_world_sleeping(self.pointer, out), 2)
    return out[0]
end
function World:isLocked() return self.calling or false end

function World:fixture_of(id)
    local known = self.fixtures[lib.fettle_slot(id)]
    return known and known.id == id and known.fixture or nil
end
function World:body_of(id)
    local known = self.bodies[lib.fettle_slot(id)]
    return known and known.id == id and known or nil
end

function World:joint_of(id)
    local known = self.joints[lib.fettle_slot(id)]
    return known and known.id == id and known or nil
end

local function all(world, f, of)
    local found = {}
    for _, id in ipairs(fettle.ids(f, world.pointer)) do found[#found + 1] = of(world, id) end
    return found
end
function World:getBodies() return all(self, lib.fettle_world_bodies, self.body_of) end
function World:getJoints() return all(self, lib.fettle_world_joints, self.joint_of) end
function World:getBodyCount() return #self:getBodies() end
function World:getJointCount() return #self:getJoints() end

--- The contacts that a function of C writes to an array: f(array, room, count).
function World:contacts_in(f)
    local count, room = ffi.new("uint32_t[1]"), 64
    local out
    repeat
        if count[0] > room then room = count[0] end
        out = ffi.new("fettle_contact[?]", room)
        check(f(out, room, count), 3)
    until count[0] <= room
    local found = {}
    for i = 0, count[0] - 1 do
        local c = out[i]
        local a, b = self:fixture_of(c.shape_a), self:fixture_of(c.shape_b)
        if a and b then found[#found + 1] = Contact.of(a, b, c) end
    end
    return found
end
function World:getContacts()
    return self:contacts_in(function(...) return lib.fettle_world_contacts(self.pointer, ...) end)
end
function World:getContactCount() return #self:getContacts() end
World.getBodyList, World.getJointList, World.getContactList = World.getBodies, World.getJoints, World.getContacts

--- Moves the origin of the world to a point: all is at other coordinates then.
function World:translateOrigin(x, y)
    for _, body in ipairs(self:getBodies()) do
        local awake, body_x, body_y = body:isAwake(), body:getPosition()
        body:setPosition(body_x - x, body_y - y)
        body:setAwake(awake)
    end
    for _, joint in ipairs(self:getJoints()) do joint:translate(x, y) end
end

-- A function that C calls must not raise: the error is kept and raised when the call is over.
local function guarded(world, f, ...)
    local ok, message = pcall(f, ...)
    if not ok and not world.failed then world.failed = { message } end
    return ok and message
end

-- LuaJIT must not compile calls of C that call back.
local function uncompiled(f)
    jit.off(f, true)
    return f
end

local function raise_kept_error(world)
    local failed = world.failed
    world.failed = nil
    if failed then error(failed[1], 0) end
end

-- One function of C for all worlds: LuaJIT has room for some hundred, and never frees what they refer to.
local pre_solve = ffi.cast("fettle_contact_callback", function(_, pointer, edit)
    local world = worlds[address_of(pointer)]
    local a, b = world:fixture_of(edit.shape_a), world:fixture_of(edit.shape_b)
    if not a or not b then return end
    local contact = Contact.new(a, b, edit, edit)
    guarded(world, world.callbacks.pre, a, b, contact)
    contact.edit = nil  -- it is valid inside this call
end)
local filter = ffi.cast("fettle_pair_filter", function(_, pointer, shape_a, shape_b)
    local world = worlds[address_of(pointer)]
    local a, b = world:fixture_of(shape_a), world:fixture_of(shape_b)
    if not a or not b or a.group ~= 0 and a.group == b.group then return true end
    return guarded(world, world.filter, a, b) and true or false
end)

function World:setCallbacks(begin, ended, pre, post)
    check(lib.fettle_world_set_before_solve(self.pointer, pre and pre_solve or nil, nil), 2)
    check(lib.fettle_world_set_persist_events(self.pointer, post ~= nil), 2)
    self.callbacks = { begin = begin, ended = ended, pre = pre, post = post }
end

--- `f(fixture, fixture)` says whether two fixtures may collide whose categories, masks and groups allow it.
World.setContactFilter = uncompiled(function(self, f)
    local before = self.filter
    self.filter = f  -- it is called at once for the pairs that there are
    local code = lib.fettle_world_set_filter(self.pointer, f and filter or nil, nil)
    if code ~= lib.FETTLE_DONE then self.filter = before end
    check(code, 2)
    raise_kept_error(self)
end)
function World:getContactFilter() return self.filter end
function World:getCallbacks()
    local c = self.callbacks
    return c.begin, c.ended, c.pre, c.post
end

-- Calls `f` for each event of an array in which both fixtures are known. `impulse_of(event)`: what postSolve gets, too.
local function call_for_each(world, array, count, f, contact_of, impulse_of)
    if not f then return end
    local calls, n = {}, 0  -- all first: a callback may change the world
    for i = 0, count - 1 do
        local e = array[i]
        local a, b = world:fixture_of(e.shape_a), world:fixture_of(e.shape_b)
        if a and b then
            calls[n + 1], calls[n + 2], calls[n + 3], calls[n + 4] = a, b, contact_of(a, b, e), impulse_of and impulse_of(e)
            n = n + 4
        end
    end
    for i = 1, n, 4 do
        if impulse_of then
            f(calls[i], calls[i + 1], calls[i + 2], calls[i + 3], 0)
        else
            f(calls[i], calls[i + 1], calls[i + 2])
        end
    end
end

local no_values = { normal = { x = 0, y = 0 }, point = { x = 0, y = 0 }, friction = 0, restitution = 0 }
local function with_values(a, b, e) return Contact.new(a, b, e) end
local function without_values(a, b) return Contact.new(a, b, no_values) end
local function impulse_of(e) return e.impulse * units.meter end

-- LÖVE reports what a sensor overlaps as contacts.
local function call_for_each_sensor(world, array, count, f)
    local pairs_of = {}
    for i = 0, count - 1 do pairs_of[i] = { shape_a = array[i].sensor, shape_b = array[i].visitor } end
    call_for_each(world, pairs_of, count, f, without_values)
end

local function report(world)
    local c = world.callbacks
    if not (c.begin or c.ended or c.post) then return end
    local events = ffi.new("fettle_events")
    check(lib.fettle_world_events(world.pointer, events), 3)
    call_for_each(world, events.contact_begin, events.contact_begin_count, c.begin, with_values)
    call_for_each_sensor(world, events.sensor_begin, events.sensor_begin_count, c.begin)
    call_for_each(world, events.contact_end, events.contact_end_count, c.ended, without_values)
    call_for_each_sensor(world, events.sensor_end, events.sensor_end_count, c.ended)
    call_for_each(world, events.contact_begin, events.contact_begin_count, c.post, with_values, impulse_of)
    call_for_each(world, events.contact_persist, events.contact_persist_count, c.post, with_values, impulse_of)
end

World.update = uncompiled(function(self, dt)
    self.calling = true
    self.dt = dt > 0 and dt or self.dt
    local code = lib.fettle_world_step(self.pointer, dt)
    self.calling = false
    raise_kept_error(self)
    check(code, 2)
    report(self)
end)

--- Calls f(fixture) for each fixture in a box, until it returns false.
World.queryBoundingBox = uncompiled(function(self, left, top, right, bottom, f)
    local m = units.meter
    local box = ffi.new("fettle_aabb[1]", { { { left / m, top / m }, { right / m, bottom / m } } })
    local function find(...) return lib.fettle_world_query_aabb(...) end
    local seen = {}
    for _, id in ipairs(fettle.ids(find, self.pointer, box, nil)) do
        local fixture = self:fixture_of(id)
        if fixture and not seen[fixture] then
            seen[fixture] = true
            if f(fixture) == false then return end
        end
    end
end)

--- Calls f(fixture, x, y, normal x, normal y, fraction) for each hit, nearest first. It returns the fraction at which the ray
--- ends: 0 ends it, 1 goes on; -1 ignores the hit.
World.rayCast = uncompiled(function(self, x1, y1, x2, y2, f)
    local m, count, room = units.meter, ffi.new("uint32_t[1]"), 64
    local hits
    repeat
        if count[0] > room then room = count[0] end
        hits = ffi.new("fettle_ray_hit[?]", room)
        check(lib.fettle_world_cast_ray_all(self.pointer, x1 / m, y1 / m, x2 / m, y2 / m, nil, hits, room, count), 2)
    until count[0] <= room
    local reach = 1
    for i = 0, count[0] - 1 do
        local hit = hits[i]
        local fixture = self:fixture_of(hit.shape)
        if hit.fraction > reach then return end
        if fixture then
            local answer = f(fixture, hit.point.x * m, hit.point.y * m, hit.normal.x, hit.normal.y, hit.fraction)
            if answer == 0 then return end
            if answer and answer > 0 then reach = math.min(reach, answer) end
        end
    end
end)

arguments.of_class(World, {
    setGravity = "x number, y number", setSleepingAllowed = "allowed boolean", translateOrigin = "x number, y number",
    setCallbacks = "begin_contact function?, end_contact function?, pre_solve function?, post_solve function?",
    setContactFilter = "filter function?",
    update = "dt number, ...",
    queryBoundingBox = "left number, top number, right number, bottom number, callback function",
    rayCast = "x1 number, y1 number, x2 number, y2 number, callback function",
})
physics.setMeter = arguments.checked("setMeter", "pixels number", physics.setMeter)
physics.newWorld = arguments.checked("newWorld", "x number?, y number?, sleep boolean?", physics.newWorld)

return physics
