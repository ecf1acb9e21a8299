-- Shapes and fixtures as love.physics has them. A shape is a geometry in pixels; a fixture is the shape on a body.

local fettle = require "fettle"
local units = require "fettle.units"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local shapes = {}

local Shape = {}
Shape.__index = Shape

function Shape:getType() return self.type end
function Shape:getRadius() return self.radius or 0 end
function Shape:getPoints() return unpack(self.points or {}) end
function Shape:getPoint() return self.x, self.y end

local function shape(type, values)
    values.type = type
    return setmetatable(values, Shape)
end

function shapes.newCircleShape(x, y, radius)
    if not radius then x, y, radius = 0, 0, x end
    return shape("circle", { x = x, y = y, radius = radius })
end

local function flat(...)
    if type(...) == "table" then return { unpack((...)) } end
    return { ... }
end

function shapes.newPolygonShape(...) return shape("polygon", { points = flat(...) }) end
function shapes.newEdgeShape(x1, y1, x2, y2) return shape("edge", { points = { x1, y1, x2, y2 } }) end
function shapes.newChainShape(loop, ...) return shape("chain", { points = flat(...), loop = loop }) end

function shapes.newRectangleShape(x, y, width, height, angle)
    if not width then x, y, width, height = 0, 0, x, y end
    local c, s = math.cos(angle or 0), math.sin(angle or 0)
    local points = {}
    for _, corner in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
        local px, py = corner[1] * width / 2, corner[2] * height / 2
        points[#points + 1] = x + c * px - s * py
        points[#points + 1] = y + s * px + c * py
    end
    return shape("polygon", { points = points, box = { x, y, width, height, angle or 0 } })
end

--- Geometries in meters. Chains and edges of LÖVE are solid on both sides, as segments are.
local function geometries(of)
    local m = units.meter
    if of.type == "circle" then
        local g = fettle.define("fettle_geometry", lib.FETTLE_SHAPE_CIRCLE)
        g.radius, g.center.x, g.center.y = of.radius / m, of.x / m, of.y / m
        return { g }
    elseif of.box then
        local g, b = fettle.define("fettle_geometry", lib.FETTLE_SHAPE_BOX), of.box
        g.center.x, g.center.y, g.width, g.height, g.angle = b[1] / m, b[2] / m, b[3] / m, b[4] / m, b[5]
        return { g }
    end
    local count = math.floor(#of.points / 2)
    local points = ffi.new("fettle_vec2[?]", count)
    for i = 0, count - 1 do
        points[i].x, points[i].y = of.points[2 * i + 1] / m, of.points[2 * i + 2] / m
    end
    if of.type == "polygon" then
        local g = fettle.define("fettle_geometry", lib.FETTLE_SHAPE_POLYGON)
        g.points, g.point_count = points, count
        return { g, points = points }  -- keeps the points alive
    end
    local segments = {}
    for i = 0, count - (of.loop and 1 or 2) do
        local g = fettle.define("fettle_geometry", lib.FETTLE_SHAPE_SEGMENT)
        g.from, g.to = points[i], points[(i + 1) % count]
        segments[#segments + 1] = g
    end
    return segments
end

local Fixture = {}
Fixture.__index = Fixture

function shapes.newFixture(body, of, density)
    local def = fettle.define("fettle_shape_def")
    def.density, def.friction = density or 1, 0.2  -- LÖVE's default
    local made = setmetatable({ body = body, shape = of, ids = {}, category = 1, mask = 65535, group = 0 }, Fixture)
    for _, geometry in ipairs(geometries(of)) do
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
function Fixture:getType() return self.shape.type end
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
    local inside = ffi.new("bool[1]")
    for _, id in ipairs(self.ids) do
        check(lib.fettle_shape_contains(self.body.world.pointer, id, x / units.meter, y / units.meter, inside), 2)
        if inside[0] then return true end
    end
    return false
end

function Fixture:getBoundingBox()
    local left, top, right, bottom = math.huge, math.huge, -math.huge, -math.huge
    for _, id in ipairs(self.ids) do
        local box = fettle.get("fettle_aabb", lib.fettle_shape_aabb, self.body.world.pointer, id)
        left, top = math.min(left, box.min.x), math.min(top, box.min.y)
        right, bottom = math.max(right, box.max.x), math.max(bottom, box.max.y)
    end
    local m = units.meter
    return left * m, top * m, right * m, bottom * m
end

-- LÖVE's mask is what is not collided with, in 16 categories.
local function filter(self)
    local world = self.body.world.pointer
    for _, id in ipairs(self.ids) do
        check(lib.fettle_shape_set_category(world, id, self.category), 3)
        check(lib.fettle_shape_set_mask(world, id, self.mask), 3)
        check(lib.fettle_shape_set_group(world, id, self.group), 3)
    end
end

local function bits(...)
    local sum = 0
    for _, category in ipairs { ... } do sum = bit.bor(sum, bit.lshift(1, category - 1)) end
    return sum
end

local function numbers(sum)
    local found = {}
    for i = 1, 16 do
        if bit.band(sum, bit.lshift(1, i - 1)) ~= 0 then found[#found + 1] = i end
    end
    return unpack(found)
end

function Fixture:setFilterData(categories, mask, group)
    self.category, self.mask, self.group = categories, mask, group
    filter(self)
end
function Fixture:getFilterData() return self.category, self.mask, self.group end
function Fixture:setCategory(...) self:setFilterData(bits(...), self.mask, self.group) end
function Fixture:getCategory() return numbers(self.category) end
function Fixture:setMask(...) self:setFilterData(self.category, 65535 - bits(...), self.group) end
function Fixture:getMask() return numbers(65535 - self.mask) end
function Fixture:setGroupIndex(group) self:setFilterData(self.category, self.mask, group) end
function Fixture:getGroupIndex() return self.group end

return shapes
