-- Bodies as love.physics has them: lengths are in pixels, angles in radians, clockwise on the screen.

local fettle = require "fettle"
local units = require "fettle.units"
local object = require "fettle.object"
local arguments = require "fettle.arguments"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local Body = object.class "Body"

local types = { static = 0, kinematic = 1, dynamic = 2 }
local names = { [0] = "static", "kinematic", "dynamic" }

local function type_of(name)
    return types[name] or error("expected static, kinematic or dynamic, got " .. tostring(name), 3)
end

local function newBody(world, x, y, kind)
    local def = fettle.define("fettle_body_def")
    def.type = type_of(kind or "static")
    def.position.x, def.position.y = (x or 0) / units.meter, (y or 0) / units.meter
    local id = ffi.new("fettle_id[1]")
    check(lib.fettle_world_create_body(world.pointer, def, id), 2)
    local made = setmetatable({ world = world, id = id[0], fixtures = {} }, Body)
    world.bodies[lib.fettle_slot(id[0])] = made
    return made
end

function Body:isDestroyed() return not lib.fettle_body_is_valid(self.world.pointer, self.id) end
function Body:destroy()
    check(lib.fettle_body_destroy(self.world.pointer, self.id), 2)
    self.world.bodies[lib.fettle_slot(self.id)] = nil
end
function Body:getWorld() return self.world end
function Body:getFixtures() return { unpack(self.fixtures) } end
Body.getFixtureList = Body.getFixtures
function Body:getJoints()
    local found = {}
    for _, id in ipairs(fettle.ids(lib.fettle_body_joints, self.world.pointer, self.id)) do
        found[#found + 1] = self.world:joint_of(id)
    end
    return found
end
Body.getJointList = Body.getJoints
function Body:getContacts()
    return self.world:contacts_in(function(...) return lib.fettle_body_contacts(self.world.pointer, self.id, ...) end)
end
Body.getContactList = Body.getContacts
function Body:getUserData() return self.data end
function Body:setUserData(data) self.data = data end

local vec2 = ffi.new("fettle_vec2[1]")
local pose = ffi.new("fettle_body_state[1]")

-- Reading the state by slot is the fastest way. As with every call, a destroyed body is an error.
local function state(self)
    if not lib.fettle_body_is_valid(self.world.pointer, self.id) then error("the body was destroyed", 3) end
    check(lib.fettle_world_state(self.world.pointer, lib.fettle_slot(self.id), pose), 3)
    return pose[0]
end

function Body:getPosition()
    local s = state(self)
    return s.position.x * units.meter, s.position.y * units.meter
end
function Body:getX() return state(self).position.x * units.meter end
function Body:getY() return state(self).position.y * units.meter end
function Body:getAngle() return state(self).angle end
function Body:getTransform()
    local s = state(self)
    return s.position.x * units.meter, s.position.y * units.meter, s.angle
end
function Body:getLinearVelocity()
    local s = state(self)
    return s.velocity.x * units.meter, s.velocity.y * units.meter
end
function Body:getAngularVelocity() return state(self).angular_velocity end

function Body:setPosition(x, y)
    check(lib.fettle_body_set_position(self.world.pointer, self.id, x / units.meter, y / units.meter), 2)
end
function Body:setX(x) self:setPosition(x, self:getY()) end
function Body:setY(y) self:setPosition(self:getX(), y) end
function Body:setAngle(angle) check(lib.fettle_body_set_angle(self.world.pointer, self.id, angle), 2) end
function Body:setTransform(x, y, angle)
    check(lib.fettle_body_set_pose(self.world.pointer, self.id, x / units.meter, y / units.meter, angle), 2)
end
function Body:setLinearVelocity(x, y)
    check(lib.fettle_body_set_velocity(self.world.pointer, self.id, x / units.meter, y / units.meter), 2)
end
function Body:setAngularVelocity(w) check(lib.fettle_body_set_angular_velocity(self.world.pointer, self.id, w), 2) end

function Body:getType() return names[fettle.get("int32_t", lib.fettle_body_type, self.world.pointer, self.id)] end
function Body:setType(name) check(lib.fettle_body_set_type(self.world.pointer, self.id, type_of(name)), 2) end

local function property(name, in_c, ctype)
    local read, write = "fettle_body_" .. in_c, "fettle_body_set_" .. in_c
    Body[(ctype == "bool" and "is" or "get") .. name] = function(self)
        return fettle.get(ctype, lib[read], self.world.pointer, self.id)
    end
    Body["set" .. name] = function(self, value) check(lib[write](self.world.pointer, self.id, value), 2) end
end
property("LinearDamping", "linear_damping", "float")
property("AngularDamping", "angular_damping", "float")
property("GravityScale", "gravity_scale", "float")
property("Awake", "awake", "bool")
property("SleepingAllowed", "can_sleep", "bool")
property("Bullet", "bullet", "bool")
property("FixedRotation", "locked_rotation", "bool")
property("Active", "enabled", "bool")

function Body:getMass() return fettle.get("float", lib.fettle_body_mass, self.world.pointer, self.id) end
function Body:setMass(mass) check(lib.fettle_body_set_mass(self.world.pointer, self.id, ffi.new("float[1]", mass)), 2) end
function Body:resetMassData()
    check(lib.fettle_body_set_mass(self.world.pointer, self.id, nil), 2)
    check(lib.fettle_body_set_inertia(self.world.pointer, self.id, nil), 2)
    check(lib.fettle_body_set_center(self.world.pointer, self.id, nil), 2)
end

-- The inertia of LÖVE is about the origin of the body, that of Fettle about its center of mass.
local function inertia_of_offset(self)
    local center = fettle.get("fettle_vec2", lib.fettle_body_center, self.world.pointer, self.id)
    return (center.x ^ 2 + center.y ^ 2) * self:getMass()
end
function Body:getInertia()
    local about_center = fettle.get("float", lib.fettle_body_inertia, self.world.pointer, self.id)
    return (about_center + inertia_of_offset(self)) * units.meter ^ 2
end
function Body:setInertia(inertia)
    local about_center = inertia / units.meter ^ 2 - inertia_of_offset(self)
    check(lib.fettle_body_set_inertia(self.world.pointer, self.id, ffi.new("float[1]", about_center)), 2)
end
--- Center x, center y, mass and inertia.
function Body:getMassData()
    local x, y = self:getLocalCenter()
    return x, y, self:getMass(), self:getInertia()
end
function Body:setMassData(x, y, mass, inertia)
    local center = ffi.new("fettle_vec2[1]", { { x / units.meter, y / units.meter } })
    check(lib.fettle_body_set_center(self.world.pointer, self.id, center), 2)
    self:setMass(mass)
    self:setInertia(inertia)
end

-- Forces and impulses are in pixels, too: a force of 1 in LÖVE accelerates 1 kg by one pixel per second squared.
local function apply(name, self, x, y, at_x, at_y)
    local m, world = units.meter, self.world.pointer
    if at_x then
        check(lib["fettle_body_apply_" .. name .. "_at"](world, self.id, x / m, y / m, at_x / m, at_y / m), 3)
    else
        check(lib["fettle_body_apply_" .. name](world, self.id, x / m, y / m), 3)
    end
end
function Body:applyForce(...) apply("force", self, ...) end
function Body:applyLinearImpulse(...) apply("impulse", self, ...) end
function Body:applyTorque(torque)
    check(lib.fettle_body_apply_torque(self.world.pointer, self.id, torque / units.meter ^ 2), 2)
end
function Body:applyAngularImpulse(impulse)
    check(lib.fettle_body_apply_angular_impulse(self.world.pointer, self.id, impulse / units.meter ^ 2), 2)
end

local function mapped(name, in_c)
    local f = "fettle_body_" .. in_c
    Body[name] = function(self, x, y)
        local m = units.meter
        check(lib[f](self.world.pointer, self.id, x / m, y / m, vec2), 2)
        return vec2[0].x * m, vec2[0].y * m
    end
end
mapped("getWorldPoint", "world_point")
mapped("getLocalPoint", "local_point")
mapped("getWorldVector", "world_vector")
mapped("getLocalVector", "local_vector")
mapped("getLinearVelocityFromWorldPoint", "velocity_at")

function Body:getLinearVelocityFromLocalPoint(x, y)
    return self:getLinearVelocityFromWorldPoint(self:getWorldPoint(x, y))
end
for _, place in ipairs { "World", "Local" } do
    Body["get" .. place .. "Points"] = function(self, ...)
        local points, one = { ... }, self["get" .. place .. "Point"]
        for i = 1, #points - 1, 2 do points[i], points[i + 1] = one(self, points[i], points[i + 1]) end
        return unpack(points)
    end
end

function Body:getWorldCenter()
    local center = fettle.get("fettle_vec2", lib.fettle_body_world_center, self.world.pointer, self.id)
    return center.x * units.meter, center.y * units.meter
end
function Body:getLocalCenter()
    local center = fettle.get("fettle_vec2", lib.fettle_body_center, self.world.pointer, self.id)
    return center.x * units.meter, center.y * units.meter
end
function Body:isTouching(other)
    for _, contact in ipairs(self:getContacts()) do
        local a, b = contact:getFixtures()
        if a.body == other or b.body == other then return true end
    end
    return false
end

arguments.of_class(Body, {
    setUserData = "...",
    setPosition = "x number, y number", setX = "x number", setY = "y number", setAngle = "angle number",
    setTransform = "x number, y number, angle number",
    setLinearVelocity = "x number, y number", setAngularVelocity = "velocity number",
    setType = "type string",
    setLinearDamping = "damping number", setAngularDamping = "damping number", setGravityScale = "scale number",
    setAwake = "awake boolean", setSleepingAllowed = "allowed boolean", setBullet = "bullet boolean",
    setFixedRotation = "fixed boolean", setActive = "active boolean",
    setMass = "mass number", setInertia = "inertia number", setMassData = "x number, y number, mass number, inertia number",
    applyForce = "x number, y number, at_x number?, at_y number?",
    applyLinearImpulse = "x number, y number, at_x number?, at_y number?",
    applyTorque = "torque number", applyAngularImpulse = "impulse number",
    getWorldPoint = "x number, y number", getLocalPoint = "x number, y number",
    getWorldVector = "x number, y number", getLocalVector = "x number, y number",
    getLinearVelocityFromWorldPoint = "x number, y number", getLinearVelocityFromLocalPoint = "x number, y number",
    getWorldPoints = "coordinate number...", getLocalPoints = "coordinate number...",
    isTouching = "other Body",
})

return arguments.checked("newBody", "world World, x number?, y number?, type string?", newBody)
