-- What is seen for a moment: sparks, rings, lightning, numbers, the banner. Nothing in the game depends on it.
local effects, bright, plain, banner, seed = {}, {}, {}, { "", "", age = 9 }, 1

-- Random numbers of its own: how many are drawn here must not matter to the game.
local function chance()
    seed = seed * 16807 % 2147483647
    return seed / 2147483647
end

-- Calls draw(pen, t) in each picture, with t from 0 to 1 during its life. Bright ones add their light to what is there.
local function add(list, life, draw)
    if #list < 300 then list[#list + 1] = { age = 0, life = life, draw = draw } end
end

function effects.burst(at, tint, count)
    at = vec(at)
    for _ = 1, count do
        local way, size = vec(0.4 + 1.3 * chance(), 0):rotated(chance() * 6.283), 0.6 + 0.8 * chance()
        add(bright, 0.3 + 0.4 * chance(), function(pen, t)
            pen.image("art/glow.png", at + way * (1 - (1 - t) ^ 3), size * (1 - t), nil, 0, tint)
        end)
    end
end

function effects.ring(at, radius, tint)
    at = vec(at)
    add(bright, 0.45, function(pen, t)
        pen.image("art/ring.png", at, 2.6 * radius * (1 - (1 - t) ^ 3), nil, 0, color(tint.r, tint.g, tint.b, (1 - t) ^ 2))
    end)
end

function effects.lightning(from, to)
    local side, points = (to - from):rotated(math.pi / 2) * 0.24, { [0] = from, [6] = to }
    for i = 1, 5 do points[i] = from:lerp(to, i / 6) + side * (chance() - 0.5) end
    add(bright, 0.18, function(pen, t)
        for i = 1, 12 do pen.line(points[(i - 1) // 2], points[(i + 1) // 2], color(0.6, 0.7, 1, (1 - t) / (1 + i % 2)), 3 + 8 * (i % 2)) end
    end)
end

function effects.comet(at)
    add(bright, 0.55, function(pen, t)
        local from = at + vec(5, 9) * (1 - t)
        pen.line(from, from + vec(1.2, 2.2), "#8ad0ff80", 5)
        pen.image("art/glow.png", from, 2.2 - t, nil, 0, "#bfe4ff")
        pen.image("art/glow.png", at, 2.4, nil, 0, "#5a8cff50")
    end)
end

function effects.number(at, amount)
    local text, size = math.max(1, math.floor(amount + 0.5)), math.min(0.85, 0.4 + 0.03 * amount)
    at = at + vec(0.6 * chance() - 0.3, 0.6)
    add(plain, 0.6, function(pen, t)
        pen.text(at + vec(0, 0.9 * t), text, size * (1.5 - 0.5 * math.min(1, 5 * t)), color(1, 0.94, 0.77, math.min(1, 2 - 2 * t)), "middle", "bold")
    end)
end

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
    for i, list in ipairs { bright, plain } do
        pen.push()
        pen.blend(i == 1 and "add" or "normal")
        for _, it in ipairs(list) do it.draw(pen, it.age / it.life) end
        pen.pop()
    end
end

-- A large text on the screen that comes and goes.
function effects.banner(title, text) banner = { title, text, age = 0 } end

function effects.draw_banner(pen, at, unit)
    pen.push()
    pen.fade(math.max(0, math.min(1, 4 * banner.age, 3 - banner.age)))
    pen.text(at, banner[1], 64 * unit * (1.6 - 0.6 * math.min(1, 4 * banner.age)), "#ffd98a", "middle", "bold")
    pen.text(at + vec(0, 54 * unit), banner[2], 24 * unit, "#e9e4ff")
    pen.pop()
end

return effects
