-- The joints of love.physics. Anchors are points of the world in pixels.

local fettle = require "fettle"
local units = require "fettle.units"
local joint = require "fettle.joint"
local arguments = require "fettle.arguments"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check
local property, getter, make, length, squared = joint.property, joint.getter, joint.make, joint.length, joint.squared

local joints = {}

--- Both points of a joint for which the caller may give one point or two, and the arguments after them. `count_for_two`: with so many
--- arguments or more there are two.
local function points(count_for_two, x, y, ...)
    if select("#", ...) + 2 >= count_for_two then return x, y, ... end
    return x, y, x, y, ...
end

local Distance = joint.class "distance"
property(Distance, "Length", "distance_joint_length", length)
joint.stiffness(Distance, "Frequency", "distance_joint_hertz")
property(Distance, "DampingRatio", "distance_joint_damping_ratio")
function joints.newDistanceJoint(a, b, ax, ay, bx, by, collide)
    return make(Distance, "distance", a, b, ax, ay, bx, by, collide)
end

local Rope = joint.class "rope"
property(Rope, "MaxLength", "distance_joint_max_length", length)
function joints.newRopeJoint(a, b, ax, ay, bx, by, longest, collide)
    local rope = make(Rope, "distance", a, b, ax, ay, bx, by, collide)
    check(lib.fettle_distance_joint_set_hertz(a.world.pointer, rope.id, 0))
    rope:setMaxLength(longest)
    return rope
end

--- Sets the angle of b relative to a at which the angle of the joint is 0. Without `angle` it is that at the creation of the joint.
local function set_reference_angle(made, kind, angle)
    if angle then check(lib["fettle_" .. kind .. "_joint_set_reference_angle"](made.world.pointer, made.id, angle), 3) end
    return made
end

local Revolute = joint.class "revolute"
property(Revolute, "MotorSpeed", "revolute_joint_motor_speed")
joint.motor(Revolute, "revolute_joint", "motor_torque", "MotorTorque", squared)
joint.limits(Revolute, "revolute_joint", "angle", joint.one)
getter(Revolute, "JointAngle", "revolute_joint_angle")
getter(Revolute, "ReferenceAngle", "revolute_joint_reference_angle")
function Revolute:getJointSpeed() return self.b:getAngularVelocity() - self.a:getAngularVelocity() end
function joints.newRevoluteJoint(a, b, ...)
    local ax, ay, bx, by, collide, reference = points(4, ...)
    return set_reference_angle(make(Revolute, "revolute", a, b, ax, ay, bx, by, collide), "revolute", reference)
end

-- Joints with an axis, which turns with body a.
local function set_axis(made, kind, x, y)
    local long = math.sqrt(x * x + y * y)
    local ax, ay = made.a:getLocalVector(x / long, y / long)
    check(lib["fettle_" .. kind .. "_joint_set_axis"](made.world.pointer, made.id, ax, ay), 3)
    return made
end
local function with_axis(class, kind)
    getter(class, "JointTranslation", kind .. "_joint_translation", length)
    function class:getAxis()
        local axis = fettle.get("fettle_vec2", lib["fettle_" .. kind .. "_joint_axis"], self.world.pointer, self.id)
        return self.a:getWorldVector(axis.x, axis.y)
    end
end

local Prismatic = joint.class "prismatic"
with_axis(Prismatic, "prismatic")
property(Prismatic, "MotorSpeed", "prismatic_joint_motor_speed", length)
joint.motor(Prismatic, "prismatic_joint", "motor_force", "MotorForce", length)
joint.limits(Prismatic, "prismatic_joint", "translation", length)
getter(Prismatic, "ReferenceAngle", "prismatic_joint_reference_angle")
function Prismatic:getJointSpeed()
    local x, y = self:getAxis()
    local ax, ay, bx, by = self:getAnchors()
    local vax, vay = self.a:getLinearVelocityFromWorldPoint(ax, ay)
    local vbx, vby = self.b:getLinearVelocityFromWorldPoint(bx, by)
    local turning = self.a:getAngularVelocity()
    return (vbx - vax) * x + (vby - vay) * y + turning * ((by - ay) * x - (bx - ax) * y)
end
--- LÖVE's limits are enabled at first, and both are 0.
function joints.newPrismaticJoint(a, b, ...)
    local ax, ay, bx, by, axis_x, axis_y, collide, reference = points(6, ...)
    local made = set_reference_angle(make(Prismatic, "prismatic", a, b, ax, ay, bx, by, collide), "prismatic", reference)
    made:setLimitsEnabled(true)
    return set_axis(made, "prismatic", axis_x, axis_y)
end

local Wheel = joint.class "wheel"
with_axis(Wheel, "wheel")
property(Wheel, "MotorSpeed", "wheel_joint_motor_speed")
property(Wheel, "SpringFrequency", "wheel_joint_hertz")
property(Wheel, "SpringDampingRatio", "wheel_joint_damping_ratio")
joint.motor(Wheel, "wheel_joint", "motor_torque", "MotorTorque", squared)
function Wheel:getJointSpeed() return self.b:getAngularVelocity() - self.a:getAngularVelocity() end
function joints.newWheelJoint(a, b, ...)
    local ax, ay, bx, by, axis_x, axis_y, collide = points(6, ...)
    local made = make(Wheel, "wheel", a, b, ax, ay, bx, by, collide)
    made:setSpringFrequency(2)  -- LÖVE's default
    return set_axis(made, "wheel", axis_x, axis_y)
end

local Weld = joint.class "weld"
joint.stiffness(Weld, "Frequency", "weld_joint_angular_hertz")
property(Weld, "DampingRatio", "weld_joint_angular_damping_ratio")
getter(Weld, "ReferenceAngle", "weld_joint_reference_angle")
function joints.newWeldJoint(a, b, ...)
    local ax, ay, bx, by, collide, reference = points(4, ...)
    return set_reference_angle(make(Weld, "weld", a, b, ax, ay, bx, by, collide), "weld", reference)
end

local Mouse = joint.class "mouse"
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
function Mouse:translate(x, y)
    local target_x, target_y = self:getTarget()
    self:setTarget(target_x - x, target_y - y)
end
function joints.newMouseJoint(body, x, y) return joint.make_mouse(Mouse, body, x, y) end

-- A motor joint of Fettle without a motion is friction, and with a stiffness it holds offsets.

local Friction = joint.class "friction"
property(Friction, "MaxForce", "motor_joint_max_force", length)
property(Friction, "MaxTorque", "motor_joint_max_torque", squared)
function joints.newFrictionJoint(a, b, ...)
    local ax, ay, bx, by, collide = points(4, ...)
    return make(Friction, "motor", a, b, ax, ay, bx, by, collide)
end

local Motor = joint.class "motor"
property(Motor, "MaxForce", "motor_joint_max_force", length)
property(Motor, "MaxTorque", "motor_joint_max_torque", squared)
property(Motor, "AngularOffset", "motor_joint_angular_offset")
function Motor:getLinearOffset()
    local offset = fettle.get("fettle_vec2", lib.fettle_motor_joint_linear_offset, self.world.pointer, self.id)
    return offset.x * units.meter, offset.y * units.meter
end
function Motor:setLinearOffset(x, y)
    check(lib.fettle_motor_joint_set_linear_offset(self.world.pointer, self.id, x / units.meter, y / units.meter), 2)
end
function Motor:getCorrectionFactor() return self.correction end
--- The part of an error that is corrected in a step of 1/60 s. Fettle has a damped spring, which is as fast.
function Motor:setCorrectionFactor(correction)
    if not (correction >= 0 and correction <= 1) then
        error(("correction factor %s: expected a number from 0 to 1"):format(tostring(correction)), 2)
    end
    check(lib.fettle_motor_joint_set_hertz(self.world.pointer, self.id, correction * 60 / (2 * math.pi)), 2)
    self.correction = correction
end
function joints.newMotorJoint(a, b, correction, collide)
    local ax, ay = a:getPosition()
    local made = make(Motor, "motor", a, b, ax, ay, b:getX(), b:getY(), collide)
    made:setLinearOffset(a:getLocalPoint(b:getPosition()))
    made:setAngularOffset(b:getAngle() - a:getAngle())
    made:setCorrectionFactor(correction or 0.3)
    made:setMaxForce(units.meter)        -- 1 N
    made:setMaxTorque(units.meter ^ 2)  -- 1 N m
    return made
end

local Pulley = joint.class "pulley"
getter(Pulley, "LengthA", "pulley_joint_length_a", length)
getter(Pulley, "LengthB", "pulley_joint_length_b", length)
getter(Pulley, "Ratio", "pulley_joint_ratio")
function Pulley:getGroundAnchors()
    local m, world = units.meter, self.world.pointer
    local a = fettle.get("fettle_vec2", lib.fettle_pulley_joint_ground_a, world, self.id)
    local ax, ay = a.x * m, a.y * m
    local b = fettle.get("fettle_vec2", lib.fettle_pulley_joint_ground_b, world, self.id)
    return ax, ay, b.x * m, b.y * m
end
local function set_grounds(self, ax, ay, bx, by)
    local m, world = units.meter, self.world.pointer
    check(lib.fettle_pulley_joint_set_ground_a(world, self.id, ax / m, ay / m), 3)
    check(lib.fettle_pulley_joint_set_ground_b(world, self.id, bx / m, by / m), 3)
end
function Pulley:translate(x, y)
    local ax, ay, bx, by = self:getGroundAnchors()
    set_grounds(self, ax - x, ay - y, bx - x, by - y)
end
--- The bodies collide unless `collide` is false.
function joints.newPulleyJoint(a, b, ground_ax, ground_ay, ground_bx, ground_by, ax, ay, bx, by, ratio, collide)
    local world = a.world.pointer
    local made = make(Pulley, "pulley", a, b, ax, ay, bx, by, collide ~= false)
    set_grounds(made, ground_ax, ground_ay, ground_bx, ground_by)
    check(lib.fettle_pulley_joint_set_ratio(world, made.id, ratio or 1), 2)
    check(lib.fettle_pulley_joint_set_length(world, made.id, fettle.get("float", lib.fettle_pulley_joint_length_now, world, made.id)), 2)
    return made
end

-- A gear of LÖVE keeps angle 1 + ratio * angle 2; one of Fettle keeps angle b - ratio * angle a of two bodies.
local Gear = joint.class "gear"
function Gear:getJoints() return self.first, self.second end
function Gear:getRatio() return self.ratio end
function Gear:setRatio(ratio)
    if ratio == 0 then error("gear: expected a ratio that is not 0", 2) end
    local world = self.world.pointer
    check(lib.fettle_gear_joint_set_ratio(world, self.id, -1 / ratio), 2)
    local phase = fettle.get("float", lib.fettle_gear_joint_phase_now, world, self.id)
    check(lib.fettle_gear_joint_set_phase(world, self.id, phase), 2)
    self.ratio = ratio
end
--- Two revolute joints whose first bodies do not rotate: Fettle's gears turn two bodies.
function joints.newGearJoint(first, second, ratio, collide)
    for _, one in ipairs { first, second } do
        if one.kind ~= "revolute" or one.a:getType() == "dynamic" then
            error("gear: expected two revolute joints whose first body is static or kinematic; Fettle has no others", 2)
        end
    end
    local a, b = first.b, second.b
    local made = make(Gear, "gear", a, b, a:getX(), a:getY(), b:getX(), b:getY(), collide)
    made.first, made.second = first, second
    made:setRatio(ratio or 1)
    return made
end

-- --- Arguments ------------------------------------------------------------------------------------

local motor = { setMotorSpeed = "speed number", setMotorEnabled = "enabled boolean" }
local limits = {
    setLimits = "lower number, upper number", setLowerLimit = "limit number", setUpperLimit = "limit number",
    setLimitsEnabled = "enabled boolean",
}
local spring = { setFrequency = "frequency number", setDampingRatio = "ratio number" }
local strength = { setMaxForce = "force number", setMaxTorque = "torque number" }

local function signatures(...)
    local all = {}
    for _, some in ipairs { ... } do
        for name, signature in pairs(some) do all[name] = signature end
    end
    return all
end
arguments.of_class(Distance, signatures(spring, { setLength = "length number" }))
arguments.of_class(Rope, { setMaxLength = "length number" })
arguments.of_class(Revolute, signatures(motor, limits, { setMaxMotorTorque = "torque number", getMotorTorque = "rate number?" }))
arguments.of_class(Prismatic, signatures(motor, limits, { setMaxMotorForce = "force number", getMotorForce = "rate number?" }))
arguments.of_class(Wheel, signatures(motor, {
    setSpringFrequency = "frequency number", setSpringDampingRatio = "ratio number", setMaxMotorTorque = "torque number",
    getMotorTorque = "rate number?",
}))
arguments.of_class(Weld, signatures(spring))
arguments.of_class(Mouse, signatures(spring, { setMaxForce = "force number", setTarget = "x number, y number" }))
arguments.of_class(Friction, signatures(strength))
arguments.of_class(Motor, signatures(strength, {
    setAngularOffset = "angle number", setLinearOffset = "x number, y number", setCorrectionFactor = "factor number",
}))
arguments.of_class(Pulley, {})
arguments.of_class(Gear, { setRatio = "ratio number" })

local bodies = "body_1 Body, body_2 Body"
for name, further in pairs {
    newDistanceJoint = ", x1 number, y1 number, x2 number, y2 number, collide boolean?",
    newRopeJoint = ", x1 number, y1 number, x2 number, y2 number, max_length number, collide boolean?",
    newRevoluteJoint = ", x number, y number, ...",
    newPrismaticJoint = ", x number, y number, third number, fourth number, ...",
    newWheelJoint = ", x number, y number, third number, fourth number, ...",
    newWeldJoint = ", x number, y number, ...",
    newFrictionJoint = ", x number, y number, ...",
    newMotorJoint = ", factor number?, collide boolean?",
    newPulleyJoint = ", ground_x1 number, ground_y1 number, ground_x2 number, ground_y2 number, x1 number, y1 number, "
        .. "x2 number, y2 number, ratio number?, collide boolean?",
} do
    joints[name] = arguments.checked(name, bodies .. further, joints[name])
end
joints.newMouseJoint = arguments.checked("newMouseJoint", "body Body, x number, y number", joints.newMouseJoint)
joints.newGearJoint = arguments.checked("newGearJoint", "joint_1 Joint, joint_2 Joint, ratio number?, collide boolean?",
    joints.newGearJoint)

return joints
