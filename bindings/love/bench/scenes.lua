-- The scenes of the table, in a form that does not depend on an engine: bodies, shapes and pins in meters, kilograms, seconds and radians. They
-- are those of `fettle-bench scenes` without capsules and round corners, which love.physics does not have, and two of the size of a game.
--
-- body: { type, x, y, velocity, turning, asleep, shapes, path }; one with `path(time)` is moved.
-- shape: { box = { half width, half height }, x, y } or { circle } or { polygon } or { segment }, with density, friction, category, mask.
-- pin: { a, b, x, y, speed, torque }: bodies by number, and a point of the world, where both are held together.
--
-- `figure(motions, scene)` describes its final state.

local scenes = { names = {} }
local makers = {}

local function static(x, y, ...) return { type = "static", x = x, y = y, shapes = { ... } } end
local function dynamic(x, y, ...) return { type = "dynamic", x = x, y = y, shapes = { ... } } end
local function box(width, height, more)
    local made = { box = { width, height or width }, friction = 0.6 }
    for key, value in pairs(more or {}) do made[key] = value end
    return made
end

local function outside(wrong)
    return function(motions, scene)
        local count = 0
        for i, m in ipairs(motions) do
            if scene.bodies[i].type == "dynamic" and wrong(m) then count = count + 1 end
        end
        return "outside " .. count
    end
end

--- How far the body that has moved most is from where it began.
local function farthest(motions, scene)
    local most = 0
    for i, m in ipairs(motions) do
        local b = scene.bodies[i]
        most = math.max(most, math.sqrt((m.x - b.x) ^ 2 + (m.y - b.y) ^ 2))
    end
    return ("moved, m %.3f"):format(most)
end

--- The widest gap of a pin.
local function widest(motions, scene)
    local function at(i, p)
        local m, b = motions[i], scene.bodies[i]
        local c, s, x, y = math.cos(m.angle), math.sin(m.angle), p.x - b.x, p.y - b.y
        return m.x + c * x - s * y, m.y + s * x + c * y
    end
    local most = 0
    for _, p in ipairs(scene.pins) do
        local ax, ay = at(p.a, p)
        local bx, by = at(p.b, p)
        most = math.max(most, math.sqrt((ax - bx) ^ 2 + (ay - by) ^ 2))
    end
    return ("gap, m %.3f"):format(most)
end

local function scene(name, make)
    scenes.names[#scenes.names + 1] = name
    makers[name] = make
end

--- The scene of this name.
function scenes.make(name)
    local made = makers[name]()
    made.gravity, made.pins, made.sleeping = made.gravity or -10, made.pins or {}, made.sleeping or false
    return made
end

local function add_pyramid(bodies, base, left, ground)
    for i = 0, base - 1 do
        for j = i, base - 1 do bodies[#bodies + 1] = dynamic(left + i / 2 + (j - i), ground + (2 * i + 1) / 2, box(0.5)) end
    end
end

local function pyramid(base)
    local bodies = { static(0, -1, box(100, 1)) }
    add_pyramid(bodies, base, 0.5 - base / 2, 0)
    return bodies
end
scene("pyramid of 210", function() return { steps = 300, bodies = pyramid(20), figure = farthest } end)
--- Boxes and circles in turn that fall into a pit.
scene("heap of 1000", function()
    local wide, bodies = 16, {}
    bodies[1], bodies[2], bodies[3] = static(0, -0.5, box(2 * wide, 0.5)), static(-wide - 0.5, 20, box(0.5, 60)), static(wide + 0.5, 20, box(0.5, 60))
    for row = 0, 39 do
        for i = 0, 24 do
            local shape = (row + i) % 2 == 1 and box(0.45) or { circle = 0.45, friction = 0.6 }
            bodies[#bodies + 1] = dynamic((i - 12.5) * 1.1 + row % 2 * 0.3, 2 + row * 1.1, shape)
        end
    end
    return { steps = 400, bodies = bodies, figure = outside(function(m) return math.abs(m.x) > wide or m.y < 0 end) }
end)
scene("large_pyramid", function() return { steps = 500, bodies = pyramid(100), figure = farthest } end)

scene("many_pyramids", function()
    local bodies = {}
    for row = 0, 19 do
        bodies[#bodies + 1] = static(0, 0, { segment = { -110, 11 * row, 110, 11 * row }, friction = 0.6 })
        for i = 0, 19 do add_pyramid(bodies, 10, -110 + 11 * i + 0.5, 11 * row) end
    end
    return { steps = 200, bodies = bodies, figure = farthest }
end)

scene("joint_grid", function()
    local side, bodies, pins = 100, {}, {}
    local function held(i, k) return i == 0 and k >= 47 and k <= 53 end
    for k = 0, side - 1 do
        for i = 0, side - 1 do
            local self = #bodies + 1
            local make = held(i, k) and static or dynamic
            bodies[self] = make(k, -i, { circle = 0.4, friction = 0.6, category = 2, mask = 0xfffd })
            if i > 0 then pins[#pins + 1] = { a = self - 1, b = self, x = k, y = -i + 0.5 } end
            if k > 0 and not (held(i, k) and held(i, k - 1)) then pins[#pins + 1] = { a = self - side, b = self, x = k - 0.5, y = -i } end
        end
    end
    return { steps = 500, bodies = bodies, pins = pins, figure = widest }
end)

scene("smash", function()
    local bodies = { dynamic(-20, 0, box(4, 4, { density = 8 })) }
    bodies[1].velocity = { 40, 0 }
    for i = 0, 119 do
        for j = 0, 79 do
            local small = dynamic(30 + 0.4 * i, 0.4 * (j - 40), box(0.2))
            small.asleep = true
            bodies[#bodies + 1] = small
        end
    end
    local function momentum(motions)
        local sum = 0
        for i, m in ipairs(motions) do sum = sum + (i == 1 and 8 * 64 or 0.16) * m.vx end
        return ("momentum, %% %.3f"):format(100 * (sum / (8 * 64 * 40) - 1))
    end
    return { steps = 300, sleeping = true, gravity = 0, bodies = bodies, figure = momentum }
end)

scene("tumbler", function()
    local walls = {}
    for _, side in ipairs { -10, 10 } do
        walls[#walls + 1] = box(0.5, 10, { x = side, density = 50 })
        walls[#walls + 1] = box(10, 0.5, { y = side, density = 50 })
    end
    local bodies = { static(0, 0), dynamic(0, 10, unpack(walls)) }
    for i = 0, 44 do
        for j = 0, 44 do bodies[#bodies + 1] = dynamic(-9 + 0.4 * i, 1 + 0.4 * j, box(0.125)) end
    end
    return {
        steps = 750, sleeping = true, bodies = bodies, pins = { { a = 1, b = 2, x = 0, y = 10, speed = math.rad(25), torque = 1e8 } },
        figure = outside(function(m) return math.sqrt(m.x ^ 2 + (m.y - 10) ^ 2) > 14.2 end),
    }
end)

scene("washer", function()
    local function piece(inner, outer, from, to)
        local points = {}
        for _, corner in ipairs { { inner, from }, { outer, from }, { outer, to }, { inner, to } } do
            local r, angle = corner[1], math.rad(corner[2])
            points[#points + 1], points[#points + 2] = r * math.cos(angle), r * math.sin(angle)
        end
        return { polygon = points, friction = 0.6 }
    end
    local drum = { type = "kinematic", x = 0, y = 10, velocity = { 0.001, -0.002 }, turning = math.rad(25), shapes = {} }
    for i = 0, 35 do
        drum.shapes[#drum.shapes + 1] = piece(16, 18, 10 * i - 1, 10 * i + 11)
        if i % 9 == 0 then drum.shapes[#drum.shapes + 1] = piece(14, 16, 10 * i, 10 * (i + 1)) end
    end
    local bodies = { drum }
    for j = 0, 89 do
        for i = 0, 89 do bodies[#bodies + 1] = dynamic(-9.9 + 0.21 * i, 0.1 + 0.21 * j, box(0.1)) end
    end
    return { steps = 500, sleeping = true, bodies = bodies, figure = outside(function(m) return math.sqrt(m.x ^ 2 + (m.y - 9) ^ 2) > 19 end) }
end)

--- A floor of boxes that overlap, and two walls of them.
local function bin(reach, high)
    local bodies = {}
    for i = -reach, reach do bodies[#bodies + 1] = static(i, 0, box(0.55, 0.5)) end
    for _, x in ipairs { -reach, reach } do
        for i = 0, high - 1 do bodies[#bodies + 1] = static(x, 1 + i, box(0.5, 0.55)) end
    end
    return bodies
end

scene("compounds", function()
    local bodies = bin(40, 100)
    bodies[#bodies + 1] = static(0, 0, { segment = { -800, -80, 800, -80 }, friction = 0.6 })
    local left = { polygon = { -1, 0, 0.5, 1, 0, 2 }, friction = 0.5 }
    local right = { polygon = { 1, 0, 0, 2, -0.5, 1 }, friction = 0.5 }
    for i = 0, 19 do
        for j = 0, 149 do bodies[#bodies + 1] = dynamic(2 * i - 19 + (j % 2 == 1 and -0.25 or 0.25), 2.25 * j + 5.575, left, right) end
    end
    return { steps = 500, sleeping = true, bodies = bodies, figure = outside(function(m) return m.y < -3 end) }
end)

scene("junkyard", function()
    local bodies, points = bin(80, 50), {}
    bodies[#bodies + 1] = {
        type = "kinematic", x = 0, y = 0, shapes = { box(2, 4, { y = 4 }) }, path = function(time) return 60 * math.sin(0.2 * time), 0 end,
    }
    for _, n in ipairs { 0, 2, 4, 1, 3 } do
        local angle = n * math.pi * (math.sqrt(5) - 1)
        points[#points + 1], points[#points + 2] = 0.25 * math.cos(angle), 0.25 * math.sin(angle)
    end
    for i = 0, 199 do
        for j = 0, 39 do
            bodies[#bodies + 1] = dynamic(0.375 * (2 * i - 200) + (j % 2 == 1 and 0.1 or -0.1), j + 15, { polygon = points, friction = 0.6 })
        end
    end
    return { steps = 800, sleeping = true, bodies = bodies, figure = outside(function(m) return m.y < 0 end) }
end)

return scenes
