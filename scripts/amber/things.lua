-- What levels consist of. Everything teal obeys time; what is of amber does not.

local things = {}
local teal, pale, gold, cream = color("#3c9a98"), color("#a5ece0"), color("#ffb52e"), color("#ffe9b8")
things.gold, things.cream, things.teal, things.pale = gold, cream, teal, pale

local function faded(c, opacity) return color(c.r, c.g, c.b, opacity) end
things.faded = faded

Level = class("Level", Object) { title = "", par = 10.0, doc = { par = "Seconds below which there is a bonus." } }
Ball = class("Ball", Body) { can_sleep = false, z = 6 }
Rock = class("Rock", Body) { type = "static", color = color("#483b70") }
Crate = class("Crate", Body) { color = teal, z = 2 }
Belt = class("Belt", Body) { type = "static", color = color("#483b70") }
Spark = class("Spark", Object) { position = vec(0, 0), z = 5 }
Goal = class("Goal", Object) { position = vec(0, 0), z = 3 }
Rope = class("Rope", DistanceJoint) { hertz = 0, collide = true, z = 4, of_amber = false }
Cable = class("Cable", PulleyJoint) { z = 1 }
Hint = class("Hint", Text) { size = 0.5, color = color("#cfc4ec"), z = -5 }

things.taken = {}               -- names of the sparks that the ball has collected: nothing undoes that
things.chosen = nil             -- the name of the rope that the player points at

-- The two ends of a rope where they are drawn.
function Rope:holds() return self.enabled and not self.broken end

function Rope:ends()
    local function at(body, anchor) return body and body:to_drawn(anchor) or vec(anchor) end
    return at(self.body_a, self.anchor_a), at(self.body_b, self.anchor_b)
end

function Rope:middle()
    local a, b = self:ends()
    return (a + b) / 2
end

function Rope:draw(pen)
    local a, b = self:ends()
    local tint = self.of_amber and gold or pale
    if not self:holds() then
        pen.line(a, a + vec(0, -0.35), faded(tint, 0.5), 3)
        return
    end
    if self.name == things.chosen then
        pen.line(a, b, faded(color("white"), 0.35), 14)
        pen.circle((a + b) / 2, 0.24 + 0.04 * math.sin(time.real * 9), "white")
    end
    local slack = math.max(0, self.max_length - (b - a):length())
    local sag, last = math.sqrt(slack * (b - a):length()) * 0.6, a
    for i = 1, 12 do
        local t = i / 12
        local point = a:lerp(b, t) - vec(0, 4 * sag * t * (1 - t))
        pen.line(last, point, tint, 5)
        last = point
    end
    pen.circle(a, 0.11, tint)
    pen.circle(b, 0.11, tint)
    pen.circle((a + b) / 2 - vec(0, sag), 0.15, tint, color("#1d1736"), 2)
end

-- A rope over two wheels of the world.
function Cable:draw(pen)
    local a, b = self.body_a:to_drawn(self.anchor_a), self.body_b:to_drawn(self.anchor_b)
    for _, part in ipairs { { a, self.ground_a }, { self.ground_a, self.ground_b }, { self.ground_b, b } } do pen.line(part[1], part[2], teal, 4) end
    for _, at in ipairs { self.ground_a, self.ground_b } do pen.circle(at, 0.3, color("#483b70"), pale, 3) end
end

function Goal:draw(pen)
    local t = time.real
    pen.push(self.position)
    pen.blend("add")
    for i = 1, 4 do
        local r = (i / 4 + t * 0.35) % 1
        pen.circle(vec(0, 0), 1.5 - 0.9 * r, false, faded(gold, 0.5 * r), 2)
    end
    pen.circle(vec(0, 0), 0.62 + 0.05 * math.sin(t * 3), faded(gold, 0.22))
    pen.pop()
    pen.circle(self.position, 0.52, color("#1d1230"), gold, 5)
    for i = 0, 5 do
        local way = vec(1, 0):rotated(i * math.pi / 3 + t * 0.5)
        pen.circle(self.position + way * 0.8, 0.07, gold)
    end
end

function Spark:draw(pen)
    if things.taken[self.name] then return end
    local t = time.real * 2 + self.position.x
    local at, turn = self.position + vec(0, 0.08 * math.sin(t)), math.sin(t * 0.7) * 0.3
    pen.circle(at, 0.42, faded(gold, 0.12 + 0.05 * math.sin(t * 2)))
    pen.push(at, turn)
    pen.polygon({ vec(0, 0.32), vec(0.2, 0), vec(0, -0.32), vec(-0.2, 0) }, cream, gold, 3)
    pen.polygon({ vec(0, 0.32), vec(0.2, 0), vec(0, 0) }, color("white"))
    pen.pop()
end

-- A drop of amber with a small beetle in it.
function things.draw_ball(pen, at, angle, radius, squash)
    pen.push(at, 0, radius)
    pen.blend("add")
    for i = 1, 4 do pen.circle(vec(0, 0), 1 + i * 0.32, faded(gold, 0.10)) end
    pen.pop()
    pen.push(at + vec(0, -radius * squash * 0.3), 0, radius)
    pen.circle(vec(0, 0), 1, color("#d97a0b"), color("#ffe08a"), 2)
    pen.circle(vec(-0.08, 0.1), 0.82, color("#f29a1c"))
    pen.circle(vec(-0.16, 0.2), 0.56, color("#ffbe4a"))
    pen.push(vec(0, 0), angle)
    local dark = color("#5b2a0a")
    for side = -1, 1, 2 do
        for leg = -1, 1 do pen.line(vec(leg * 0.16, 0), vec(leg * 0.3, side * 0.36), dark, 2) end
    end
    pen.circle(vec(-0.08, 0), 0.25, dark)
    pen.circle(vec(0.24, 0), 0.14, dark)
    pen.pop()
    pen.circle(vec(-0.36, 0.42), 0.16, faded(color("white"), 0.8))
    pen.pop()
end

-- Lines on crates, so that one sees how they turn, and arrows on belts.
function things.draw_details(pen, level)
    for _, crate in ipairs(level:find("Crate")) do
        pen.push(crate:drawn_position(), crate:drawn_angle())
        for _, box in ipairs(crate:children("Box")) do
            local w, h = box.width - 0.24, box.height - 0.24
            if w > 0.1 and h > 0.1 then
                pen.push(box.center, box.angle)
                pen.box(vec(0, 0), w, h, false, faded(pale, 0.55), 2)
                if w < 3 * h and h < 3 * w then pen.line(vec(-w / 2, -h / 2), vec(w / 2, h / 2), faded(pale, 0.35), 2) end
                pen.pop()
            end
        end
        for _, disc in ipairs(crate:children("Circle")) do
            pen.circle(disc.center, disc.radius * 0.7, false, faded(pale, 0.5), 2)
            pen.circle(disc.center, disc.radius * 0.2, faded(pale, 0.6))
        end
        pen.pop()
    end
    for _, belt in ipairs(level:find("Belt")) do
        local box = belt.surface
        local speed, count = box.surface_speed, math.floor(box.width / 0.8)
        for i = 0, count - 1 do
            local x = ((i + 0.5) * 0.8 - speed * time.now) % (count * 0.8) - count * 0.4
            local s = speed > 0 and -0.16 or 0.16
            pen.push(belt.position, belt.angle)
            local y = box.height / 2 - 0.2
            pen.polygon({ vec(x - s, y + 0.16), vec(x + s, y), vec(x - s, y - 0.16), vec(x, y) }, teal)
            pen.pop()
        end
    end
end

-- The rope nearest to a point, within a distance.
function things.rope_at(point, within)
    local best
    for _, rope in ipairs(world.level and world.level:find("Rope") or {}) do
        if rope:holds() then
            local a, b = rope:ends()
            local along = b - a
            local t = math.max(0, math.min(1, (point - a):dot(along) / math.max(1e-6, along:dot(along))))
            local away = (a:lerp(b, t) - point):length()
            if away < within then best, within = rope, away end
        end
    end
    return best
end

-- The next rope from the chosen one in a direction.
function things.rope_towards(way)
    local ropes = world.level:find("Rope", Rope.holds)
    local from, best, least
    for _, rope in ipairs(ropes) do if rope.name == things.chosen then from = rope end end
    if not from then return ropes[1] end
    for _, rope in ipairs(ropes) do
        local to = rope:middle() - from:middle()
        local ahead = to:dot(way)
        if rope ~= from and ahead > 0.01 then
            local cost = to:length() * (2 - ahead / to:length())
            if not least or cost < least then best, least = rope, cost end
        end
    end
    return best or from
end

return things
