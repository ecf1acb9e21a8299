-- The members of all joints of love.physics, and the functions that give their classes the properties of Fettle's joints.

local fettle = require "fettle"
local units = require "fettle.units"
local object = require "fettle.object"
local arguments = require "fettle.arguments"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local Joint = object.class "Joint"

function Joint:getType() return self.kind end
function Joint:isDestroyed() return not lib.fettle_joint_is_valid(self.world.pointer, self.id) end
function Joint:destroy() check(lib.fettle_joint_destroy(self.world.pointer, self.id), 2) end
function Joint:getBodies() return self.a, self.b end
function Joint:getUserData() return self.data end
function Joint:setUserData(data) self.data = data end
function Joint:getCollideConnected()
    return fettle.get("bool", lib.fettle_joint_collide, self.world.pointer, self.id)
end
function Joint:getAnchors()
    local m, world = units.meter, self.world.pointer
    local a = fettle.get("fettle_vec2", lib.fettle_joint_world_anchor_a, world, self.id)
    local ax, ay = a.x * m, a.y * m
    local b = fettle.get("fettle_vec2", lib.fettle_joint_world_anchor_b, world, self.id)
    return ax, ay, b.x * m, b.y * m
end

--- For World:translateOrigin: moves what the joint has in world coordinates. Most joints have nothing.
function Joint:translate() end

local joint = { Joint = Joint }

-- Scales of values: how many units of LÖVE one SI unit is, with `m` pixels a meter.
function joint.one() return 1 end
function joint.length(m) return m end
function joint.squared(m) return m * m end

--- LÖVE gives the impulse of the last step times `rate`, which usually is 1 / dt; without it, the force.
local function over_step(self, force, rate) return force * (rate or 1 / self.world.dt) * self.world.dt end

function Joint:getReactionForce(rate)
    local f, m = fettle.get("fettle_vec2", lib.fettle_joint_force, self.world.pointer, self.id), units.meter
    return over_step(self, f.x * m, rate), over_step(self, f.y * m, rate)
end
function Joint:getReactionTorque(rate)
    local torque = fettle.get("float", lib.fettle_joint_torque, self.world.pointer, self.id)
    return over_step(self, torque * units.meter ^ 2, rate)
end

--- A class of joints; `kind` is what getType gives.
function joint.class(kind)
    local class = object.class(kind:gsub("^%l", string.upper) .. "Joint", Joint)
    class.kind = kind
    return class
end

--- Converts a number of LÖVE to Fettle, and back: `scale(meter)` is the factor for a number in SI units.
local function scaled(scale)
    scale = scale or joint.one
    return function(value) return value / scale(units.meter) end, function(value) return value * scale(units.meter) end
end

local function getter(to, name, in_c, scale)
    local read, _, back = "fettle_" .. in_c, scaled(scale)
    to["get" .. name] = function(self) return back(fettle.get("float", lib[read], self.world.pointer, self.id)) end
end
joint.getter = getter

function joint.property(to, name, in_c, scale)
    local write, there = "fettle_" .. in_c:gsub("_joint_", "_joint_set_", 1), scaled(scale)
    getter(to, name, in_c, scale)
    to["set" .. name] = function(self, value) check(lib[write](self.world.pointer, self.id, there(value)), 2) end
end

--- The frequency of a rigid joint is 0 in LÖVE, and infinite in Fettle.
function joint.stiffness(to, name, in_c)
    local read, write = "fettle_" .. in_c, "fettle_" .. in_c:gsub("_joint_", "_joint_set_", 1)
    to["get" .. name] = function(self)
        local hertz = fettle.get("float", lib[read], self.world.pointer, self.id)
        return hertz == math.huge and 0 or hertz
    end
    to["set" .. name] = function(self, hertz)
        check(lib[write](self.world.pointer, self.id, hertz == 0 and math.huge or hertz), 2)
    end
end

--- "MotorEnabled" of LÖVE: without it the motor has no strength. What the motor does is read as `strength_name`.
function joint.motor(to, prefix, strength, strength_name, scale)
    local write = "fettle_" .. prefix .. "_set_max_" .. strength
    local function update(self)
        local most = self.motor_enabled and (self.strength or 0) or 0
        check(lib[write](self.world.pointer, self.id, most), 3)
    end
    to["setMax" .. strength_name] = function(self, value)
        self.strength = value / scale(units.meter)
        update(self)
    end
    to["getMax" .. strength_name] = function(self) return (self.strength or 0) * scale(units.meter) end
    to["get" .. strength_name] = function(self, rate)
        local now = fettle.get("float", lib["fettle_" .. prefix .. "_" .. strength], self.world.pointer, self.id)
        return over_step(self, now * scale(units.meter), rate)
    end
    function to:setMotorEnabled(enabled)
        self.motor_enabled = enabled
        update(self)
    end
    function to:isMotorEnabled() return self.motor_enabled or false end
end

--- "LimitsEnabled" of LÖVE: without it the limits are infinite.
function joint.limits(to, prefix, coordinate, scale)
    local function update(self)
        local m, on = scale(units.meter), self.limits_enabled
        local low, high = on and (self.low or 0) / m or -math.huge, on and (self.high or 0) / m or math.huge
        check(lib["fettle_" .. prefix .. "_set_lower_" .. coordinate](self.world.pointer, self.id, low), 3)
        check(lib["fettle_" .. prefix .. "_set_upper_" .. coordinate](self.world.pointer, self.id, high), 3)
    end
    function to:setLimits(low, high)
        if low > high then error(("limits from %g to %g: the lower one is above the upper one"):format(low, high), 2) end
        self.low, self.high = low, high
        update(self)
    end
    function to:getLimits() return self.low or 0, self.high or 0 end
    function to:setLowerLimit(low) self:setLimits(low, self.high or 0) end
    function to:setUpperLimit(high) self:setLimits(self.low or 0, high) end
    function to:getLowerLimit() return self.low or 0 end
    function to:getUpperLimit() return self.high or 0 end
    function to:setLimitsEnabled(enabled)
        self.limits_enabled = enabled
        update(self)
    end
    function to:areLimitsEnabled() return self.limits_enabled or false end
    to.hasLimitsEnabled = to.areLimitsEnabled
end

local function registered(world, id, made)
    made.world, made.id = world, id
    world.joints[lib.fettle_slot(id)] = made
    return made
end

--- Checks that the points of a new joint are numbers. `kind`: of the joint, as LÖVE names it; `level`: of the call in the game.
local function require_points(kind, level, ...)
    for i, name in ipairs { "x1", "y1", "x2", "y2" } do
        arguments.required((select(i, ...)), ("new%s: %s"):format(kind, name), "number", level + 1)
    end
end

--- Makes a joint of Fettle's type `kind` between points of the world.
function joint.make(class, kind, a, b, ax, ay, bx, by, collide)
    require_points(class.type_name, 3, ax, ay, bx, by)
    local def = fettle.define("fettle_" .. kind .. "_joint_def")
    def.body_a, def.body_b, def.collide = a.id, b.id, collide or false
    local x, y = a:getLocalPoint(ax, ay)
    def.anchor_a.x, def.anchor_a.y = x / units.meter, y / units.meter
    x, y = b:getLocalPoint(bx, by)
    def.anchor_b.x, def.anchor_b.y = x / units.meter, y / units.meter
    local id = ffi.new("fettle_id[1]")
    check(lib["fettle_world_create_" .. kind .. "_joint"](a.world.pointer, def, id), 3)
    return registered(a.world, id[0], setmetatable({ a = a, b = b }, class))
end

function joint.make_mouse(class, body, x, y)
    local def = fettle.define("fettle_mouse_joint_def")
    def.body, def.target.x, def.target.y = body.id, x / units.meter, y / units.meter
    def.max_force = 1000 * body:getMass()
    local id = ffi.new("fettle_id[1]")
    check(lib.fettle_world_create_mouse_joint(body.world.pointer, def, id), 3)
    return registered(body.world, id[0], setmetatable({ a = body }, class))
end

arguments.of_class(Joint, { getReactionForce = "rate number?", getReactionTorque = "rate number?", translate = "..." })

return joint
