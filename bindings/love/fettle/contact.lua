-- Contacts as the callbacks of a world get them.

local units = require "fettle.units"

local Contact = {}
Contact.__index = Contact

--- `edit`: the contact in C while it is about to be solved; nil in other callbacks, where it cannot be changed.
function Contact.new(a, b, values, edit)
    return setmetatable({ a = a, b = b, edit = edit, enabled = true, nx = values.normal.x, ny = values.normal.y,
        x = values.point.x, y = values.point.y, friction = values.friction, restitution = values.restitution }, Contact)
end

function Contact:getFixtures() return self.a, self.b end
function Contact:getNormal() return self.nx, self.ny end
function Contact:getPositions() return self.x * units.meter, self.y * units.meter end
function Contact:isTouching() return true end

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

return Contact
