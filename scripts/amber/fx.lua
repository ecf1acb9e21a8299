-- Sparks, the trail of the ball and what else is only seen. It is not in the tree, so it goes on while time goes back.
local things = require("things")
local fx = { squash = 0, tide = 0 }          -- how flat the ball is; how thick the veil over a world that goes back is
local bits, trail, pops = {}, {}, {}

function fx.clear() bits, trail, pops, fx.tide = {}, {}, {}, 0 end

function fx.burst(at, count, speed, tint, size, weight)
    for _ = 1, math.min(count, 300 - #bits) do
        local life, way = 0.3 + 0.5 * random(), vec(speed * (0.2 + 0.8 * random()), 0):rotated(random() * 2 * math.pi)
        bits[#bits + 1] = { at = vec(at), way = way, left = life, life = life, tint = tint, size = size * (1 + 2 * random()),
            fall = vec(0, weight or 6) }
    end
end

function fx.pop(at, text) pops[#pops + 1] = { at = vec(at), text = text, left = 1.1 } end   -- a text that rises

local function expire(list, dt)
    for i = #list, 1, -1 do
        list[i].left = list[i].left - dt
        if list[i].left <= 0 then table.remove(list, i) end
    end
end

function fx.update(dt, ball, back)
    expire(bits, dt)
    expire(pops, dt)
    fx.squash = fx.squash * math.exp(-9 * dt)
    fx.tide = fx.tide + ((back and 1 or 0) - fx.tide) * math.min(1, 10 * dt)
    if ball and dt > 0 then table.insert(trail, 1, vec(ball.position)) trail[26] = nil end
end

function fx.draw_trail(pen)
    pen.push() pen.blend("add")
    for i = #trail, 2, -1 do
        pen.line(trail[i], trail[i - 1], things.faded(things.gold, 0.22 * (1 - i / 26)), 2 + 20 * (1 - i / 26))
    end
    pen.pop()
end

function fx.draw(pen)
    pen.push() pen.blend("add")
    for _, bit in ipairs(bits) do
        local share, age = bit.left / bit.life, bit.life - bit.left
        local at = bit.at + bit.way * (age - 0.5 * age ^ 2) - bit.fall * (0.5 * age ^ 2)
        pen.image("art/glow.png", at, 3 * bit.size * share, nil, nil, things.faded(bit.tint, share))
    end
    pen.pop()
    for _, pop in ipairs(pops) do
        local age = 1.1 - pop.left
        local size = 0.55 * math.min(1, age * 7) * (1 + 0.4 * math.max(0, 1 - age * 5))
        pen.text(pop.at + vec(0, age * 1.2), pop.text, size, things.faded(things.cream, math.min(1, 3 * pop.left)), nil, "bold")
    end
    if fx.tide < 0.01 then return end
    pen.box(vec(0, 0), 40, 16, things.faded(things.teal, 0.16 * fx.tide))
    for i = 0, 17 do
        local x = 14 - (time.real * (9 + i % 5 * 4) + i * 5.3) % 30
        pen.box(vec(x, -7.2 + i * 0.86), 1.5 + i % 4, 0.035, things.faded(things.pale, 0.35 * fx.tide))
    end
    for i = 0, 1 do
        local x = -0.9 + i * 0.9 - 0.12 * math.sin(time.real * 8)
        pen.polygon({ vec(x, 6.2), vec(x + 0.8, 6.65), vec(x + 0.8, 5.75) }, things.faded(things.pale, 0.9 * fx.tide))
    end
end

return fx
