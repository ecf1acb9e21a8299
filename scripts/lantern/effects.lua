-- What is seen for a moment: sparks, rings, lightning, numbers, the banner. Nothing in the game depends on it.

local effects = {}
local sparks, rings, bolts, numbers = {}, {}, {}, {}
local banner = { age = 99 }
local most = 260

-- Random numbers of its own: how many are drawn here must not matter to the game.
local seed = 1
local function chance()
    seed = (seed * 1103515245 + 12345) % 2147483648
    return seed / 2147483648
end

function effects.burst(at, tint, count)
    for _ = 1, count do
        if #sparks >= most then return end
        local angle, speed = chance() * 6.283, 2 + 5 * chance()
        sparks[#sparks + 1] = { x = at.x, y = at.y, vx = math.cos(angle) * speed, vy = math.sin(angle) * speed, age = 0,
            life = 0.3 + 0.4 * chance(), size = 0.3 + 0.4 * chance(), tint = tint }
    end
end

function effects.ring(at, radius, tint) rings[#rings + 1] = { at = vec(at), radius = radius, tint = tint, age = 0 } end

function effects.bolt(from, to)
    local points, side = { from }, (to - from):rotated(math.pi / 2) * 0.12
    for i = 1, 5 do points[i + 1] = from:lerp(to, i / 6) + side * (2 * chance() - 1) end
    points[7] = to
    bolts[#bolts + 1] = { points = points, age = 0 }
end

function effects.number(at, amount)
    if #numbers < 40 then
        numbers[#numbers + 1] = { at = at + vec(0.6 * chance() - 0.3, 0.6), text = tostring(math.max(1, math.floor(amount + 0.5))),
            size = math.min(0.85, 0.4 + 0.03 * amount), age = 0 }
    end
end

function effects.banner(title, text) banner = { title = title, text = text, age = 0 } end

local function grow_old(list, dt, life)
    for i = #list, 1, -1 do
        local it = list[i]
        it.age = it.age + dt
        if it.age > (it.life or life) then
            list[i] = list[#list]
            list[#list] = nil
        end
    end
end

function effects.update(dt, real_dt)
    banner.age = banner.age + real_dt
    grow_old(sparks, dt)
    grow_old(rings, dt, 0.45)
    grow_old(bolts, dt, 0.18)
    grow_old(numbers, dt, 0.6)
    for _, s in ipairs(sparks) do
        s.x, s.y, s.vx, s.vy = s.x + s.vx * dt, s.y + s.vy * dt, s.vx * (1 - 4 * dt), s.vy * (1 - 4 * dt)
    end
end

function effects.draw(pen)
    pen.push()
    pen.blend("add")
    for _, s in ipairs(sparks) do
        local size = s.size * (1 - s.age / s.life) * 2
        pen.image("art/glow.png", vec(s.x, s.y), size, size, 0, s.tint)
    end
    for _, r in ipairs(rings) do
        local t = r.age / 0.45
        pen.push()
        pen.fade((1 - t) ^ 2)
        local size = 2.6 * r.radius * (1 - (1 - t) ^ 3)
        pen.image("art/ring.png", r.at, size, size, 0, r.tint)
        pen.pop()
    end
    for _, b in ipairs(bolts) do
        pen.push()
        pen.fade(1 - b.age / 0.18)
        for i = 2, #b.points do
            pen.line(b.points[i - 1], b.points[i], "#6f8cff66", 12)
            pen.line(b.points[i - 1], b.points[i], "#e8f0ff", 3)
        end
        pen.pop()
    end
    pen.pop()
    for _, n in ipairs(numbers) do
        local t = n.age / 0.6
        pen.push()
        pen.fade(math.min(1, 2 - 2 * t))
        pen.text(n.at + vec(0, 0.9 * t), n.text, n.size * (1 + 0.5 * math.max(0, 1 - 5 * t)), "#fff1c4", "middle", "bold")
        pen.pop()
    end
end

-- A large text in the middle of the screen that comes and goes.
function effects.draw_banner(pen, middle, unit)
    local t = banner.age
    if t > 3 then return end
    local pop = 1 + 0.6 * math.max(0, 1 - 4 * t)
    pen.push()
    pen.fade(math.min(1, 4 * t, 3 - t))
    pen.text(middle, banner.title, 64 * unit * pop, "#ffd98a", "middle", "bold")
    pen.text(middle + vec(0, 54 * unit), banner.text, 24 * unit, "#e9e4ff")
    pen.pop()
end

return effects
