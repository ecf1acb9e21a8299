-- Joints as love.physics has them. Anchors are points of the world in pixels.

local fettle = require "fettle"
local units = require "fettle.units"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local joints = {}

local function class(type) return setmetatable({ type = type }, { __index = joints.Joint }) end

local Joint = {}
joints.Joint = Joint
function Joint:getType() return self.type end
function Joint:isDestroyed() return not lib.fettle_joint_is_valid(self.world.pointer, self.id) end
function Joint:destroy() check(lib.fettle_joint_destroy(self.world.pointer, self.id), 2) end
function Joint:getBodies() return self.a, self.b end
function Joint:getUserData() return self.data end
function Joint:setUserData(data) self.data = data end
function Joint:getAnchors()
    local m, world = units.meter, self.world.pointer
    local a = fettle.get("fettle_vec2", lib.fettle_joint_world_anchor_a, world, self.id)
    local ax, ay = a.x * m, a.y * m
    local b = fettle.get("fettle_vec2", lib.fettle_joint_world_anchor_b, world, self.id)
    return ax, ay, b.x * m, b.y * m
end
function Joint:getReactionForce()
    local f = fettle.get("fettle_vec2", lib.fettle_joint_force, self.world.pointer, self.id)
    return f.x * units.meter, f.y * units.meter
end

--- Adds a property to a class. `scale(meter)` is what a value in SI is multiplied with for LÖVE.
local function property(to, name, in_c, scale, bool)
    local read, write = "fettle_" .. in_c, "fettle_" .. in_c:gsub("_joint_", "_joint_set_", 1)
    local ctype = bool and "bool" or "float"
    scale = scale or function() return 1 end
    to[(bool and "is" or "get") .. name] = function(self)
        local value = fettle.get(ctype, lib[read], self.world.pointer, self.id)
        return bool and value or value * scale(units.meter)
    end
    to["set" .. name] = function(self, value)
        if not bool then value = value / scale(units.meter) end
        check(lib[write](self.world.pointer, self.id, value), 2)
    end
end
local function length(m) return m end
local function squared(m) return m * m end

local function make(of, kind, a, b, ax, ay, bx, by, collide)
    local def = fettle.define("fettle_joint_def")
    def.body_a, def.body_b, def.collide = a.id, b.id, collide or false
    local x, y = a:getLocalPoint(ax, ay)
    def.anchor_a.x, def.anchor_a.y = x / units.meter, y / units.meter
    x, y = b:getLocalPoint(bx, by)
    def.anchor_b.x, def.anchor_b.y = x / units.meter, y / units.meter
    local id = ffi.new("fettle_id[1]")
    check(lib["fettle_world_create_" .. kind .. "_joint"](a.world.pointer, def, id), 3)
    return setmetatable({ world = a.world, id = id[0], a = a, b = b }, { __index = of })
end

local Distance = class("distance")
property(Distance, "Length", "distance_joint_length", length)
property(Distance, "Frequency", "distance_joint_hertz")
property(Distance, "DampingRatio", "distance_joint_damping_ratio")
function joints.newDistanceJoint(a, b, ax, ay, bx, by, collide)
    return make(Distance, "distance", a, b, ax, ay, bx, by, collide)
end

local Rope = class("rope")
property(Rope, "MaxLength", "distance_joint_max_length", length)
function joints.newRopeJoint(a, b, ax, ay, bx, by, longest, collide)
    local rope = make(Rope, "distance", a, b, ax, ay, bx, by, collide)
    check(lib.fettle_distance_joint_set_hertz(a.world.pointer, rope.id, 0))
    rope:setMaxLength(longest)
    return rope
end

--- "MotorEnabled" and "LimitsEnabled" of LÖVE: without them the motor has no strength, and the limits are infinite.
local function motor(to, prefix, strength, strength_name, scale)
    local write = "fettle_" .. prefix .. "_set_" .. strength
    local function update(self)
        local most = self.motor_enabled and (self.strength or 0) or 0
        check(lib[write](self.world.pointer, self.id, most), 3)
    end
    to["setMax" .. strength_name] = function(self, value)
        self.strength = value / scale(units.meter)
        update(self)
    end
    to["getMax" .. strength_name] = function(self) return (self.strength or 0) * scale(units.meter) end
    function to:setMotorEnabled(enabled)
        self.motor_enabled = enabled
        update(self)
    end
    function to:isMotorEnabled() return self.motor_enabled or false end
end

local function limits(to, prefix, coordinate, scale)
    local function update(self)
        local m, on = scale(units.meter), self.limits_enabled
        local low, high = on and (self.low or 0) / m or -math.huge, on and (self.high or 0) / m or math.huge
        check(lib["fettle_" .. prefix .. "_set_lower_" .. coordinate](self.world.pointer, self.id, low), 3)
        check(lib["fettle_" .. prefix .. "_set_upper_" .. coordinate](self.world.pointer, self.id, high), 3)
    end
    function to:setLimits(low, high)
        self.low, self.high = low, high
        update(self)
    end
    function to:getLimits() return self.low or 0, self.high or 0 end
    function to:setLimitsEnabled(enabled)
        self.limits_enabled = enabled
        update(self)
    end
    function to:areLimitsEnabled() return self.limits_enabled or false end
end

local function one() return 1 end

local Revolute = class("revolute")
property(Revolute, "MotorSpeed", "revolute_joint_motor_speed")
motor(Revolute, "revolute_joint", "max_motor_torque", "MotorTorque", squared)
limits(Revolute, "revolute_joint", "angle", one)
function Revolute:getJointAngle() return fettle.get("float", lib.fettle_revolute_joint_angle, self.world.pointer, self.id) end
function joints.newRevoluteJoint(a, b, x, y, collide) return make(Revolute, "revolute", a, b, x, y, x, y, collide) end

local function set_axis(joint, f, x, y)
    local ax, ay = joint.a:getLocalVector(x, y)
    check(f(joint.world.pointer, joint.id, ax, ay), 3)
end

local Prismatic = class("prismatic")
property(Prismatic, "MotorSpeed", "prismatic_joint_motor_speed", length)
motor(Prismatic, "prismatic_joint", "max_motor_force", "MotorForce", length)
limits(Prismatic, "prismatic_joint", "translation", length)
function Prismatic:getJointTranslation()
    return fettle.get("float", lib.fettle_prismatic_joint_translation, self.world.pointer, self.id) * units.meter
end
--- LÖVE's limits are enabled at first, and both are 0.
function joints.newPrismaticJoint(a, b, x, y, axis_x, axis_y, collide)
    local joint = make(Prismatic, "prismatic", a, b, x, y, x, y, collide)
    set_axis(joint, lib.fettle_prismatic_joint_set_axis, axis_x, axis_y)
    joint:setLimitsEnabled(true)
    return joint
end

local Wheel = class("wheel")
property(Wheel, "MotorSpeed", "wheel_joint_motor_speed")
property(Wheel, "SpringFrequency", "wheel_joint_hertz")
property(Wheel, "SpringDampingRatio", "wheel_joint_damping_ratio")
motor(Wheel, "wheel_joint", "max_motor_torque", "MotorTorque", squared)
function joints.newWheelJoint(a, b, x, y, axis_x, axis_y, collide)
    local joint = make(Wheel, "wheel", a, b, x, y, x, y, collide)
    set_axis(joint, lib.fettle_wheel_joint_set_axis, axis_x, axis_y)
    return joint
end

local Weld = class("weld")
property(Weld, "Frequency", "weld_joint_angular_hertz")
property(Weld, "DampingRatio", "weld_joint_angular_damping_ratio")
function joints.newWeldJoint(a, b, x, y, collide) return make(Weld, "weld", a, b, x, y, x, y, collide) end

local Mouse = class("mouse")
property(Mouse, "MaxForce", "mouse_joint_max_force", length)
property(Mouse, "Frequency", "mouse_joint_hertz")
property(Mouse, "DampingRatio", "mouse_joint_damping_ratio")
function Mouse:setTarget(x, y)
    check(lib.fettle_mouse_joint_set_target(self.world.pointer, self.id, x / units.meter, y / units.meter), 2)
end
function Mouse:getTarget()
    local target = fettle.get("fettle_vec2", lib.fettle_mouse_joint_target, self.world.pointer, self.id)
    return target.x * units.meter, target.y * units.meter
end
function joints.newMouseJoint(body, x, y)
    local def = fettle.define("fettle_mouse_joint_def")
    def.body, def.target.x, def.target.y = body.id, x / units.meter, y / units.meter
    def.max_force = 1000 * body:getMass()
    local id = ffi.new("fettle_id[1]")
    check(lib.fettle_world_create_mouse_joint(body.world.pointer, def, id), 2)
    return setmetatable({ world = body.world, id = id[0], a = body }, { __index = Mouse })
end

return joints
