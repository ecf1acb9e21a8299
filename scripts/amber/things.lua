-- What levels consist of. Everything teal obeys time; what is of amber does not.
local things = {
    gold = color("#ffb52e"), cream = color("#ffe9b8"), teal = color("#3c9a98"), pale = color("#a5ece0"), ink = color("#1d1230"),
    taken = {},                 -- names of the sparks that the ball has collected: nothing undoes that
    chosen = nil,               -- the name of the rope that the player points at
}
local gold, teal, pale, white = things.gold, things.teal, things.pale, color("white")
local stone = color("#483b70")

local function faded(c, opacity) return color(c.r, c.g, c.b, opacity) end
things.faded = faded

Level = class("Level", Object) { title = "", tip = "", par = 10.0, number = 0, doc = { tip = "Shown to a player who has lost a few times.", par = "Seconds below which there is a bonus." } }
Ball = class("Ball", Body) { can_sleep = false }
Rock = class("Rock", Body) { type = "static", color = stone }
Belt = class("Belt", Body) { type = "static", color = stone, z = 1 }
Crate = class("Crate", Body) { color = teal, z = 2 }
Cable = class("Cable", PulleyJoint) { z = 1 }
Goal = class("Goal", Object) { position = vec(0, 0), z = 3 }
Rope = class("Rope", DistanceJoint) { hertz = 0, collide = true, z = 4, of_amber = false }
Spark = class("Spark", Object) { position = vec(0, 0), z = 5 }
Wheel = class("Wheel", Sprite) { image = "art/wheel.png", tint = color("#2a2149"), turn = 0.0 }
Hint = class("Hint", Text) { size = 0.5, color = color("#cfc4ec"), z = -5 }

function Wheel:step(dt) self.angle = self.angle + self.turn * dt end
local function drawn(body, anchor) return body and body:to_drawn(anchor) or vec(anchor) end

function Rope:ends() return drawn(self.body_a, self.anchor_a), drawn(self.body_b, self.anchor_b) end
function Rope:holds() return self.enabled and not self.broken end
function Rope:middle()
    local a, b = self:ends()
    return (a + b) / 2
end

function Rope:draw(pen)
    local a, b = self:ends()
    local tint = self.of_amber and gold or pale
    if not self:holds() then return pen.line(a, a - vec(0, 0.35), faded(tint, 0.5), 3) end
    local chosen = self.name == things.chosen
    if chosen then pen.line(a, b, faded(white, 0.35), 14) end
    local sag, last = math.sqrt(math.max(0, self.max_length - (b - a):length()) * (b - a):length()) * 0.6, a
    for i = 1, 12 do
        local point = a:lerp(b, i / 12) - vec(0, sag * i * (12 - i) / 36)
        pen.line(last, point, tint, 5)
        last = point
    end
    for _, e in ipairs { a, b } do pen.circle(e, 0.11, tint) end
    local size = chosen and 0.26 + 0.04 * math.sin(time.real * 9) or 0.15
    pen.circle((a + b) / 2 - vec(0, sag), size, chosen and white or tint, things.ink, 2)
end

function Cable:draw(pen)
    local way = { drawn(self.body_a, self.anchor_a), vec(self.ground_a), vec(self.ground_b), drawn(self.body_b, self.anchor_b) }
    for i = 1, 3 do pen.line(way[i], way[i + 1], teal, 4) end
    for i = 2, 3 do pen.image("art/wheel.png", way[i], 0.9, nil, -way[1].y, pale) end
end

function Goal:draw(pen)
    pen.image("art/glow.png", self.position, 4.4 + 0.5 * math.sin(time.real * 3), nil, nil, gold)
    for i = 1, 3 do
        local far = (i / 3 + time.real * 0.35) % 1
        pen.circle(self.position, 1.8 - far, false, faded(gold, 0.4 * far), 2)
    end
    pen.image("art/home.png", self.position, 1.7, nil, -time.real * 0.6)
end

function Spark:draw(pen)
    if things.taken[self.name] then return end
    local t = time.real * 2 + self.position.x
    local at = self.position + vec(0, 0.08 * math.sin(t))
    pen.image("art/glow.png", at, 1.7 + 0.2 * math.sin(2 * t), nil, nil, faded(gold, 0.55))
    pen.image("art/spark.png", at, 0.45, nil, math.sin(t * 0.7) * 0.3)
end

function things.draw_ball(pen, ball, squash)
    local at, size = ball:drawn_position(), 2 * ball.circle.radius
    pen.image("art/glow.png", at, size * 3, nil, nil, faded(gold, 0.7))
    at = at - vec(0, size * squash * 0.2)
    pen.image("art/amber.png", at, size * (1 + squash * 0.4), size * (1 - squash * 0.4), ball:drawn_angle())
    pen.image("art/shine.png", at, size)
end

-- Arrows that run with the belt.
function Belt:draw(pen)
    local box = self.surface
    local speed, count = box.surface_speed, math.floor(box.width / 0.8)
    for i = 1, count do
        local at = self.position + vec(((i - 0.5) * 0.8 - speed * time.now) % (count * 0.8) - count * 0.4, box.height / 2 - 0.25)
        local s = speed > 0 and -0.16 or 0.16
        pen.polygon({ at + vec(-s, 0.16), at + vec(s, 0), at + vec(-s, -0.16), at }, pale)
    end
end

-- The rope nearest to a point, within a distance.
function things.rope_at(point, within)
    local best
    for _, rope in ipairs(world.level:find("Rope", Rope.holds)) do
        local a, b = rope:ends()
        local t = math.max(0, math.min(1, (point - a):dot(b - a) / math.max(1e-6, (b - a):dot(b - a))))
        local away = (a:lerp(b, t) - point):length()
        if away < within then best, within = rope, away end
    end
    return best
end

-- The next rope from the chosen one in a direction.
function things.rope_towards(way)
    local from, best, least = things.chosen and world.level[things.chosen]:middle() or vec(0, 0), nil, math.huge
    for _, rope in ipairs(world.level:find("Rope", Rope.holds)) do
        local to = rope:middle() - from
        local far, ahead = to:length(), to:dot(way)
        if ahead > 0.3 * far and far - ahead / 2 < least then best, least = rope, far - ahead / 2 end
    end
    return best or things.rope_at(from, math.huge)
end

return things
