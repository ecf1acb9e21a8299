-- Fixtures as love.physics has them: a shape on a body, with its surface and its filter.

local fettle = require "fettle"
local units = require "fettle.units"
local object = require "fettle.object"
local arguments = require "fettle.arguments"
local shapes = require "fettle.shapes"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local Fixture = object.class "Fixture"

local function newFixture(body, of, density)
    local def = fettle.define("fettle_shape_def")
    def.density, def.friction = density or 1, 0.2  -- LÖVE's default
    local made = setmetatable({ body = body, ids = {}, category = 1, mask = 65535, group = 0 }, Fixture)
    made.shape = shapes.copy(of, made)
    for _, geometry in ipairs(shapes.geometries(of)) do
        local id = ffi.new("fettle_id[1]")
        check(lib.fettle_body_add(body.world.pointer, body.id, geometry, def, id), 2)
        made.ids[#made.ids + 1] = id[0]
        body.world.fixtures[lib.fettle_slot(id[0])] = { id = id[0], fixture = made }
    end
    body.fixtures[#body.fixtures + 1] = made
    return made
end

function Fixture:getBody() return self.body end
function Fixture:getShape() return self.shape end
function Fixture:getType() return self.shape.kind end
function Fixture:getUserData() return self.data end
function Fixture:setUserData(data) self.data = data end
function Fixture:isDestroyed() return not lib.fettle_shape_is_valid(self.body.world.pointer, self.ids[1]) end

function Fixture:destroy()
    for _, id in ipairs(self.ids) do check(lib.fettle_shape_destroy(self.body.world.pointer, id), 2) end
    for i, other in ipairs(self.body.fixtures) do
        if other == self then table.remove(self.body.fixtures, i) end
    end
end

local function property(name, in_c, ctype)
    local read, write = "fettle_shape_" .. in_c, "fettle_shape_set_" .. in_c
    Fixture[(ctype == "bool" and "is" or "get") .. name] = function(self)
        return fettle.get(ctype, lib[read], self.body.world.pointer, self.ids[1])
    end
    Fixture["set" .. name] = function(self, value)
        for _, id in ipairs(self.ids) do check(lib[write](self.body.world.pointer, id, value), 2) end
    end
end
property("Friction", "friction", "float")
property("Restitution", "restitution", "float")
property("Density", "density", "float")
property("Sensor", "sensor", "bool")

function Fixture:testPoint(x, y)
    local body_x, body_y, angle = self.body:getTransform()
    return self.shape:testPoint(body_x, body_y, angle, x, y)
end
function Fixture:rayCast(x1, y1, x2, y2, most, index)
    local x, y, angle = self.body:getTransform()
    return self.shape:rayCast(x1, y1, x2, y2, most, x, y, angle, index)
end
--- Center x, center y, mass, and inertia about the origin of the body, which LÖVE has in kg m² here.
function Fixture:getMassData()
    local x, y, mass, inertia = self.shape:computeMass(self:getDensity())
    return x, y, mass, inertia / units.meter ^ 2
end

--- Of one child of a chain, or of all.
function Fixture:getBoundingBox(index)
    local left, top, right, bottom = math.huge, math.huge, -math.huge, -math.huge
    for i, id in ipairs(self.ids) do
        if not index or i == index then
            local box = fettle.get("fettle_aabb", lib.fettle_shape_aabb, self.body.world.pointer, id)
            left, top = math.min(left, box.min.x), math.min(top, box.min.y)
            right, bottom = math.max(right, box.max.x), math.max(bottom, box.max.y)
        end
    end
    local m = units.meter
    return left * m, top * m, right * m, bottom * m
end

--- Distance of two fixtures, and their nearest points.
local function getDistance(a, b)
    local least, found
    for _, id_a in ipairs(a.ids) do
        for _, id_b in ipairs(b.ids) do
            local out = ffi.new("fettle_separation[1]")
            check(lib.fettle_distance(a.body.world.pointer, id_a, b.body.world.pointer, id_b, out), 2)
            if not least or out[0].distance < least then least, found = out[0].distance, out end
        end
    end
    local m, s = units.meter, found[0]
    return least * m, s.point_a.x * m, s.point_a.y * m, s.point_b.x * m, s.point_b.y * m
end

-- LÖVE's mask is what is not collided with, in 16 categories.
local function apply_filter(self)
    local world = self.body.world.pointer
    for _, id in ipairs(self.ids) do
        check(lib.fettle_shape_set_category(world, id, self.category), 3)
        check(lib.fettle_shape_set_mask(world, id, self.mask), 3)
        check(lib.fettle_shape_set_group(world, id, self.group), 3)
    end
end

local function bits_of(...)
    local sum = 0
    for _, category in ipairs(type(...) == "table" and (...) or { ... }) do
        if type(category) ~= "number" or not (category >= 1 and category <= 16) then
            error(("category %s: expected a number from 1 to 16"):format(tostring(category)), 3)
        end
        sum = bit.bor(sum, bit.lshift(1, category - 1))
    end
    return sum
end

local function categories_of(sum)
    local found = {}
    for i = 1, 16 do
        if bit.band(sum, bit.lshift(1, i - 1)) ~= 0 then found[#found + 1] = i end
    end
    return unpack(found)
end

function Fixture:setFilterData(categories, mask, group)
    self.category, self.mask, self.group = categories, mask, group
    apply_filter(self)
end
function Fixture:getFilterData() return self.category, self.mask, self.group end
function Fixture:setCategory(...) self:setFilterData(bits_of(...), self.mask, self.group) end
function Fixture:getCategory() return categories_of(self.category) end
function Fixture:setMask(...) self:setFilterData(self.category, 65535 - bits_of(...), self.group) end
function Fixture:getMask() return categories_of(65535 - self.mask) end
function Fixture:setGroupIndex(group) self:setFilterData(self.category, self.mask, group) end
function Fixture:getGroupIndex() return self.group end

arguments.of_class(Fixture, {
    setFriction = "friction number", setRestitution = "restitution number", setDensity = "density number",
    setSensor = "sensor boolean",
    testPoint = "x number, y number",
    rayCast = "x1 number, y1 number, x2 number, y2 number, max_fraction number, child number?",
    getBoundingBox = "child number?",
    setFilterData = "categories number, mask number, group number", setGroupIndex = "group number",
})

return {
    newFixture = arguments.checked("newFixture", "body Body, shape Shape, density number?", newFixture),
    getDistance = arguments.checked("getDistance", "fixture_1 Fixture, fixture_2 Fixture", getDistance),
}
