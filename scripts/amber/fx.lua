-- Particles, the trail of the ball and what else is only seen. It is no state of the game: nothing of it is in the tree.

local things = require("things")
local fx = { squash = 0 }
local bits, trail, pops = {}, {}, {}

function fx.clear() bits, trail, pops = {}, {}, {} end

function fx.burst(at, count, speed, tint, size, weight)
    for _ = 1, math.min(count, 300 - #bits) do
        local life = 0.3 + 0.5 * math.random()
        bits[#bits + 1] = { at = vec(at), way = vec(speed * (0.2 + 0.8 * math.random()), 0):rotated(math.random() * 2 * math.pi),
            left = life, life = life, tint = tint, size = size * (0.5 + math.random()), weight = weight or 6 }
    end
end

-- A text that pops up and rises.
function fx.pop(at, text) pops[#pops + 1] = { at = vec(at), text = text, age = 0 } end

function fx.update(dt, ball)
    local n = 0
    for _, bit in ipairs(bits) do
        bit.left = bit.left - dt
        bit.way = bit.way * (1 - 1.5 * dt) - vec(0, bit.weight * dt)
        bit.at = bit.at + bit.way * dt
        if bit.left > 0 then n = n + 1 bits[n] = bit end
    end
    for i = #bits, n + 1, -1 do bits[i] = nil end
    for i = #pops, 1, -1 do
        pops[i].age = pops[i].age + dt
        if pops[i].age > 1.1 then table.remove(pops, i) end
    end
    fx.squash = fx.squash * math.exp(-9 * dt)
    if ball and dt > 0 then
        table.insert(trail, 1, vec(ball.position))
        trail[26] = nil
    end
end

function fx.draw_trail(pen)
    pen.push() pen.blend("add")
    for i = #trail, 2, -1 do
        local share = 1 - i / 26
        pen.line(trail[i], trail[i - 1], things.faded(things.gold, 0.22 * share), 2 + 20 * share)
    end
    pen.pop()
end

function fx.draw(pen)
    pen.push() pen.blend("add")
    for _, bit in ipairs(bits) do
        local share = bit.left / bit.life
        pen.circle(bit.at, bit.size * share, things.faded(bit.tint, share))
    end
    pen.pop()
    for _, pop in ipairs(pops) do
        local grow = math.min(1, pop.age * 7) * (1 + 0.4 * math.max(0, 1 - pop.age * 5))
        pen.text(pop.at + vec(0, pop.age * 1.2), pop.text, 0.55 * grow, things.faded(things.cream, math.min(1, 3 * (1.1 - pop.age))), nil, "bold")
    end
end

-- Dusk, stars, and wheels of a clock that turn with the time of the world, backwards with it, too.
local function wheel(pen, center, radius, teeth, angle, tint)
    pen.push(center, angle)
    local edge = {}
    for i = 0, teeth - 1 do
        for k, r in ipairs { 1, 1.1, 1.1, 1 } do
            edge[#edge + 1] = vec(radius * r, 0):rotated((i + (k - 1) * 0.25 + (k == 2 and 0.07 or k == 3 and -0.07 or 0)) * 2 * math.pi / teeth)
        end
    end
    pen.polygon(edge, tint)
    pen.circle(vec(0, 0), radius * 0.78, color("#1f1839"))
    for i = 0, 2 do pen.box(vec(0, 0), radius * 1.6, radius * 0.13, tint, nil, nil, i * math.pi / 3) end
    pen.circle(vec(0, 0), radius * 0.2, tint)
    pen.pop()
end

function fx.draw_sky(pen, clock)
    local low, high = color("#4a2f55"), color("#17122f")
    for i = 0, 29 do pen.box(vec(0, -7.25 + i * 0.5), 40, 0.52, low:lerp(high, (i / 29) ^ 0.8)) end
    local tint = color("#272043")
    wheel(pen, vec(6.5, 2.5), 5.2, 24, clock * 0.25, tint)
    wheel(pen, vec(-0.6, -2.1), 2.9, 14, -clock * 0.43 + 0.12, tint)
    wheel(pen, vec(-8.6, 3.6), 3.2, 16, clock * 0.4, tint)
    for i = 1, 40 do
        local at = vec((i * 7.31) % 26 - 13, (i * 4.77 + clock * 0.12 * (1 + i % 3)) % 16 - 8)
        pen.circle(at, 0.03 + 0.02 * (i % 3), things.faded(things.cream, 0.10 + 0.08 * math.sin(i + clock)))
    end
end

-- While time goes back: a teal veil, lines that run to the left, two arrows.
function fx.draw_tide(pen, share)
    if share < 0.01 then return end
    pen.box(vec(0, 0), 40, 16, things.faded(things.teal, 0.16 * share))
    for i = 0, 17 do
        local x = 14 - (time.real * (9 + i % 5 * 4) + i * 5.3) % 30
        pen.box(vec(x, -7.2 + i * 0.86), 1.5 + i % 4, 0.035, things.faded(things.pale, 0.35 * share))
    end
    for i = 0, 1 do
        local x = -0.9 + i * 0.9 - 0.12 * math.sin(time.real * 8)
        pen.polygon({ vec(x, 6.2), vec(x + 0.8, 6.65), vec(x + 0.8, 5.75) }, things.faded(things.pale, 0.9 * share))
    end
end

return fx
