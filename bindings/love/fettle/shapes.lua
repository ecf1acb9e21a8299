-- Shapes as love.physics has them: geometries in pixels. The shapes of a fixture are its own copies.

local fettle = require "fettle"
local units = require "fettle.units"
local object = require "fettle.object"
local arguments = require "fettle.arguments"
local ffi, lib, check = fettle.ffi, fettle.lib, fettle.check

local shapes = {}

local Shape = object.class "Shape"
local Circle, Polygon = object.class("CircleShape", Shape), object.class("PolygonShape", Shape)
local Edge, Chain = object.class("EdgeShape", Shape), object.class("ChainShape", Shape)

function Shape:getType() return self.kind end
function Shape:getChildCount() return 1 end

-- The skin that Box2D puts around polygons, edges and chains; other radii are those of circles.
function Shape:getRadius() return self.radius or 0.01 * units.meter end

local function shape(class, kind, values)
    values.kind = kind
    return setmetatable(values, class)
end

--- Checks the numbers of a shape, so that an error names the line of the game. `n` in the list: the required count.
local function numbers(what, values, least)
    for i = 1, values.n or #values do
        if type(values[i]) ~= "number" then
            error(("%s: number %d: expected a number, got %s"):format(what, i, type(values[i])), 3)
        end
    end
    if least and (#values < 2 * least or #values % 2 == 1) then
        error(("%s: expected x and y of at least %d points, got %d numbers"):format(what, least, #values), 3)
    end
    return values
end

function shapes.newCircleShape(x, y, radius)
    if not radius then x, y, radius = 0, 0, x end
    numbers("newCircleShape", { n = 3, x, y, radius })
    return shape(Circle, "circle", { x = x, y = y, radius = radius })
end

local function flat(...)
    if type(...) == "table" then return { unpack((...)) } end
    return { ... }
end

function shapes.newPolygonShape(...)
    return shape(Polygon, "polygon", { points = numbers("newPolygonShape", flat(...), 3) })
end
function shapes.newEdgeShape(...) return shape(Edge, "edge", { points = numbers("newEdgeShape", { ... }, 2) }) end
function shapes.newChainShape(loop, ...)
    return shape(Chain, "chain", { points = numbers("newChainShape", flat(...), loop and 3 or 2), loop = loop })
end

function shapes.newRectangleShape(x, y, width, height, angle)
    if not width then x, y, width, height = 0, 0, x, y end
    numbers("newRectangleShape", { n = 5, x, y, width, height, angle or 0 })
    local c, s = math.cos(angle or 0), math.sin(angle or 0)
    local points = {}
    for _, corner in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
        local px, py = corner[1] * width / 2, corner[2] * height / 2
        points[#points + 1] = x + c * px - s * py
        points[#points + 1] = y + s * px + c * py
    end
    return shape(Polygon, "polygon", { points = points, box = { x, y, width, height, angle or 0 } })
end

function shapes.copy(of, fixture)
    local made = {}
    for key, value in pairs(of) do made[key] = value end
    made.points = of.points and { unpack(of.points) }
    made.fixture = fixture
    return setmetatable(made, getmetatable(of))
end

--- Geometries in meters. Chains and edges of LÖVE are solid on both sides, as segments are.
function shapes.geometries(of)
    local m = units.meter
    if of.kind == "circle" then
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
    if of.kind == "polygon" then
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

local function child(self, index)
    local all = shapes.geometries(self)
    local geometry = all[index or 1]
    if not geometry then error(("child %s: expected a number from 1 to %d"):format(tostring(index), #all), 3) end
    return geometry, all  -- which keeps the points alive
end

local function pose(x, y, angle)
    return ffi.new("fettle_pose[1]", { { { (x or 0) / units.meter, (y or 0) / units.meter }, angle or 0 } })
end

function Shape:testPoint(x, y, angle, point_x, point_y)
    local at, inside, all = pose(x, y, angle), ffi.new("bool[1]"), shapes.geometries(self)
    for _, geometry in ipairs(all) do
        check(lib.fettle_geometry_contains(geometry, at, point_x / units.meter, point_y / units.meter, inside), 2)
        if inside[0] and geometry.type ~= lib.FETTLE_SHAPE_SEGMENT then return true end
    end
    return false
end

--- Normal x, normal y and fraction of the point where a ray enters the shape; nothing where it does not.
function Shape:rayCast(x1, y1, x2, y2, most, x, y, angle, index)
    local m, geometry, all = units.meter, child(self, index)
    local found, hit = ffi.new("bool[1]"), ffi.new("fettle_surface_hit[1]")
    x2, y2 = x1 + most * (x2 - x1), y1 + most * (y2 - y1)
    check(lib.fettle_geometry_cast_ray(geometry, pose(x, y, angle), x1 / m, y1 / m, x2 / m, y2 / m, found, hit), 2)
    -- `all` is read so that the points live until here.
    if found[0] and all then return hit[0].normal.x, hit[0].normal.y, hit[0].fraction * most end
end

function Shape:computeAABB(x, y, angle, index)
    local m, geometry, all = units.meter, child(self, index)
    local box = ffi.new("fettle_aabb[1]")
    check(lib.fettle_geometry_bounding_box(geometry, pose(x, y, angle), box), 2)
    local b = all and box[0]  -- the points live until here
    return b.min.x * m, b.min.y * m, b.max.x * m, b.max.y * m
end

--- Center x, center y, mass, and inertia about the origin of the body.
function Shape:computeMass(density)
    local m = units.meter
    if self.kind == "edge" or self.kind == "chain" then
        local p = self.points
        if self.kind == "chain" then return 0, 0, 0, 0 end
        return (p[1] + p[3]) / 2, (p[2] + p[4]) / 2, 0, 0
    end
    local out, geometry, all = ffi.new("fettle_mass_properties[1]"), child(self, 1)
    check(lib.fettle_geometry_mass_properties(geometry, density, out), 2)
    local p = all and out[0]  -- the points live until here
    local about_origin = p.inertia + p.mass * (p.centroid.x ^ 2 + p.centroid.y ^ 2)
    return p.centroid.x * m, p.centroid.y * m, p.mass, about_origin * m * m
end

--- Sets numbers of the shape of a fixture in Fettle; a shape of no fixture has none yet.
local function set(self, name, ...)
    if not self.fixture then return end
    for _, id in ipairs(self.fixture.ids) do
        check(lib["fettle_shape_set_" .. name](self.fixture.body.world.pointer, id, ...), 3)
    end
end

function Circle:getPoint() return self.x, self.y end
function Circle:setPoint(x, y)
    set(self, "center", x / units.meter, y / units.meter)
    self.x, self.y = x, y
end
function Circle:setRadius(radius)
    set(self, "radius", radius / units.meter)
    self.radius = radius
end

function Polygon:getPoints() return unpack(self.points) end
--- Whether it is convex: its corners turn one way.
function Polygon:validate()
    local p, n, turn = self.points, #self.points / 2, nil
    local function at(i) return p[2 * (i % n) + 1], p[2 * (i % n) + 2] end
    for i = 0, n - 1 do
        local x0, y0 = at(i)
        local x1, y1 = at(i + 1)
        local x2, y2 = at(i + 2)
        local cross = (x1 - x0) * (y2 - y1) - (y1 - y0) * (x2 - x1)
        if cross == 0 or turn and cross * turn < 0 then return false end
        turn = cross
    end
    return n > 2
end

-- The neighbors of an outline smooth its seams in Box2D. Fettle's segments need none, so they are only kept.
local function neighbor(class, name)
    class["set" .. name] = function(self, x, y) self[name] = x and { x, y } end
    class["get" .. name] = function(self) if self[name] then return unpack(self[name]) end end
end
for _, class in ipairs { Edge, Chain } do
    neighbor(class, "NextVertex")
    neighbor(class, "PreviousVertex")
    function class:getPoints() return unpack(self.points) end
end

function Chain:getVertexCount() return #self.points / 2 + (self.loop and 1 or 0) end
function Chain:getChildCount() return self:getVertexCount() - 1 end
function Chain:getPoint(index)
    if not (index >= 1 and index <= self:getVertexCount()) then
        error(("point %s: expected a number from 1 to %d"):format(tostring(index), self:getVertexCount()), 2)
    end
    local i = (index - 1) % (#self.points / 2)
    return self.points[2 * i + 1], self.points[2 * i + 2]
end
function Chain:getChildEdge(index)
    local x1, y1 = self:getPoint(index)
    local x2, y2 = self:getPoint(index + 1)
    return shapes.newEdgeShape(x1, y1, x2, y2)
end

arguments.of_class(Shape, {
    testPoint = "x number, y number, angle number, point_x number, point_y number",
    rayCast = "x1 number, y1 number, x2 number, y2 number, max_fraction number, x number, y number, angle number, child number?",
    computeAABB = "x number, y number, angle number, child number?",
    computeMass = "density number",
})
arguments.of_class(Circle, { setPoint = "x number, y number", setRadius = "radius number" })
arguments.of_class(Polygon, {})
for _, class in ipairs { Edge, Chain } do
    local signatures = { setNextVertex = "x number?, y number?", setPreviousVertex = "x number?, y number?" }
    if class == Chain then signatures.getPoint, signatures.getChildEdge = "index number", "index number" end
    arguments.of_class(class, signatures)
end

return shapes
