-- What is seen for a moment: sparks, rings, lightning, numbers, the banner. Nothing in the game depends on it.
local effects = {}
local bright, plain, banner = {}, {}, { "", "", age = 99 }
local seed = 1

-- Random numbers of its own: how many are drawn here must not matter to the game.
local function chance()
    seed = (seed * 1103515245 + 12345) % 2147483648
    return seed / 2147483648
end

-- Calls draw(pen, t) in each picture, with t from 0 to 1 during its life. Bright ones add their light to what is there.
function effects.add(life, draw, list)
    list = list or bright
    if #list < 300 then list[#list + 1] = { age = 0, life = life, draw = draw } end
end

function effects.burst(at, tint, count)
    at = vec(at)
    for _ = 1, count do
        local angle, speed, size = chance() * 6.283, 0.4 + 1.3 * chance(), 0.6 + 0.8 * chance()
        local way = vec(math.cos(angle), math.sin(angle)) * speed
        effects.add(0.3 + 0.4 * chance(), function(pen, t)
            pen.image("art/glow.png", at + way * (1 - (1 - t) ^ 3), size * (1 - t), nil, 0, tint)
        end)
    end
end

function effects.ring(at, radius, tint)
    at = vec(at)
    effects.add(0.45, function(pen, t)
        pen.image("art/ring.png", at, 2.6 * radius * (1 - (1 - t) ^ 3), nil, 0, color(tint.r, tint.g, tint.b, (1 - t) ^ 2))
    end)
end

function effects.lightning(from, to)
    local points, side = { from }, (to - from):rotated(math.pi / 2) * 0.12
    for i = 1, 5 do points[i + 1] = from:lerp(to, i / 6) + side * (2 * chance() - 1) end
    points[7] = to
    effects.add(0.18, function(pen, t)
        for i = 2, 7 do
            pen.line(points[i - 1], points[i], color(0.4, 0.5, 1, 0.4 * (1 - t)), 12)
            pen.line(points[i - 1], points[i], color(0.9, 0.95, 1, 1 - t), 3)
        end
    end)
end

function effects.comet(at)
    effects.add(0.55, function(pen, t)
        local from = at + vec(5, 9) * (1 - t)
        pen.image("art/glow.png", at, 2.4, nil, 0, "#5a8cff50")
        pen.line(from, from + vec(1.2, 2.2), "#8ad0ff80", 5)
        pen.image("art/glow.png", from, 2.2 - t, nil, 0, "#bfe4ff")
    end)
end

function effects.number(at, amount)
    at = at + vec(0.6 * chance() - 0.3, 0.6)
    local text, size = math.max(1, math.floor(amount + 0.5)), math.min(0.85, 0.4 + 0.03 * amount)
    if #plain > 50 then return end
    effects.add(0.6, function(pen, t)
        pen.text(at + vec(0, 0.9 * t), text, size * (1 + 0.5 * math.max(0, 1 - 5 * t)), color(1, 0.94, 0.77, math.min(1, 2 - 2 * t)), "middle", "bold")
    end, plain)
end

function effects.banner(title, text) banner = { title, text, age = 0 } end

function effects.update(dt, real_dt)
    banner.age = banner.age + real_dt
    for _, list in ipairs { bright, plain } do
        for i = #list, 1, -1 do
            list[i].age = list[i].age + dt
            if list[i].age >= list[i].life then list[i], list[#list] = list[#list], nil end
        end
    end
end

function effects.draw(pen)
    pen.push()
    pen.blend("add")
    for _, it in ipairs(bright) do it.draw(pen, it.age / it.life) end
    pen.pop()
    for _, it in ipairs(plain) do it.draw(pen, it.age / it.life) end
end

-- A large text on the screen that comes and goes.
function effects.draw_banner(pen, at, unit)
    local t = banner.age
    if t > 3 then return end
    pen.push()
    pen.fade(math.min(1, 4 * t, 3 - t))
    pen.text(at, banner[1], 64 * unit * (1 + 0.6 * math.max(0, 1 - 4 * t)), "#ffd98a", "middle", "bold")
    pen.text(at + vec(0, 54 * unit), banner[2], 24 * unit, "#e9e4ff")
    pen.pop()
end

return effects
