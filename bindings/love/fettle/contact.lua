-- Contacts as the callbacks of a world get them.

local fettle = require "fettle"
local units = require "fettle.units"
local object = require "fettle.object"
local arguments = require "fettle.arguments"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local Contact = object.class "Contact"

--- `edit`: the contact in C while it is about to be solved; nil in other callbacks, where it cannot be changed.
function Contact.new(a, b, values, edit)
    return setmetatable({ a = a, b = b, edit = edit, enabled = true, nx = values.normal.x, ny = values.normal.y,
        x = values.point.x, y = values.point.y, friction = values.friction, restitution = values.restitution,
        part_a = values.part_a, part_b = values.part_b, id_a = values.shape_a, id_b = values.shape_b }, Contact)
end

local function points_of(c)
    local points = {}
    for i = 0, c.point_count - 1 do
        points[#points + 1] = c.points[i].point.x
        points[#points + 1] = c.points[i].point.y
    end
    return points
end

--- A contact of the list of a world or of a body.
function Contact.of(a, b, c)
    local made = Contact.new(a, b, { normal = c.normal, point = c.points[0].point, friction = c.friction,
        restitution = c.restitution, part_a = c.part_a, part_b = c.part_b })
    made.points = points_of(c)
    return made
end

function Contact:getFixtures() return self.a, self.b end
function Contact:getNormal() return self.nx, self.ny end

--- One point, or the two ends of the line in which they touch.
function Contact:getPositions()
    if self.id_a then  -- an event has the middle: the line through it is in the world
        local out, count = ffi.new("fettle_contact[1]"), ffi.new("uint32_t[1]")
        check(lib.fettle_world_contacts_of(self.a.body.world.pointer, self.id_a, self.id_b, out, 1, count), 2)
        if count[0] > 0 and out[0].point_count == 2 then
            local p = points_of(out[0])
            local dx, dy = (p[3] - p[1]) / 2, (p[4] - p[2]) / 2
            self.points = { self.x - dx, self.y - dy, self.x + dx, self.y + dy }
        end
        self.id_a = nil
    end
    local m, p = units.meter, self.points
    if not p then return self.x * m, self.y * m end
    if p[3] then return p[1] * m, p[2] * m, p[3] * m, p[4] * m end
    return p[1] * m, p[2] * m
end
--- The numbers of the edges of chains.
function Contact:getChildren() return (self.part_a or 0) + 1, (self.part_b or 0) + 1 end
function Contact:isTouching() return true end
function Contact:isDestroyed() return self.a:isDestroyed() or self.b:isDestroyed() end

local function editable(self)
    return self.edit or error("a contact can be changed only in the callback preSolve", 3)
end

function Contact:isEnabled() return self.enabled end
function Contact:setEnabled(enabled)
    editable(self).enabled = enabled
    self.enabled = enabled
end
function Contact:getFriction() return self.friction end
function Contact:setFriction(friction)
    editable(self).friction = friction
    self.friction = friction
end
function Contact:getRestitution() return self.restitution end
function Contact:setRestitution(restitution)
    editable(self).restitution = restitution
    self.restitution = restitution
end
--- Computes the value again from the surfaces of both fixtures.
function Contact:resetFriction()
    self:setFriction(math.sqrt(self.a:getFriction() * self.b:getFriction()))
end
function Contact:resetRestitution()
    self:setRestitution(math.max(self.a:getRestitution(), self.b:getRestitution()))
end
--- Of a belt; LÖVE has it in meters a second.
function Contact:getTangentSpeed() return self.edit and self.edit.surface_speed or 0 end
function Contact:setTangentSpeed(speed) editable(self).surface_speed = speed end

local new, of = Contact.new, Contact.of
arguments.of_class(Contact, {
    setEnabled = "enabled boolean", setFriction = "friction number", setRestitution = "restitution number",
    setTangentSpeed = "speed number",
})
Contact.new, Contact.of = new, of  -- no methods: without the check of `self`

return Contact
