-- What is seen for a moment: sparks, rings, lightning, numbers, the banner. Nothing in the game depends on it.
local effects, lists, seed = {}, { {}, {}, {} }, 1
local BRIGHT, PLAIN, SCREEN = 1, 2, 3             -- bright ones add their light to what is there

local function chance()                           -- not random(): how many are drawn here must not matter to the game
    seed = seed * 16807 % 2147483647
    return seed / 2147483647
end

-- Calls draw(pen, t) in each picture, with t from 0 to 1 during its life.
local function add(list, life, draw)
    if #lists[list] < (list == PLAIN and 60 or 300) then table.insert(lists[list], { age = 0, life = life, draw = draw }) end
end

function effects.burst(at, tint, count)
    at = vec(at)
    for _ = 1, count do
        local way, size = vec(0.4 + 1.3 * chance(), 0):rotated(chance() * 6.283), 0.6 + 0.8 * chance()
        add(BRIGHT, 0.3 + 0.4 * chance(), function(pen, t) pen.image("art/glow.png", at + way * (1 - (1 - t) ^ 3), size * (1 - t), nil, 0, tint) end)
    end
end

function effects.ring(at, radius, tint)
    at = vec(at)
    add(BRIGHT, 0.45, function(pen, t)
        pen.image("art/ring.png", at, 2.6 * radius * (1 - (1 - t) ^ 3), nil, 0, color(tint.r, tint.g, tint.b, (1 - t) ^ 2))
    end)
end

function effects.lightning(from, to)
    local side, points = (to - from):rotated(math.pi / 2) * 0.24, { [0] = from, [6] = to }
    for i = 1, 5 do points[i] = from:lerp(to, i / 6) + side * (chance() - 0.5) end
    add(BRIGHT, 0.18, function(pen, t)
        for i = 1, 12 do pen.line(points[(i - 1) // 2], points[(i + 1) // 2], color(0.6, 0.7, 1, (1 - t) / (1 + i % 2)), 3 + 8 * (i % 2)) end
    end)
end

function effects.comet(at)
    add(BRIGHT, 0.55, function(pen, t)
        local from = at + vec(5, 9) * (1 - t)
        pen.line(from, from + vec(1.2, 2.2), "#8ad0ff80", 5)
        pen.image("art/glow.png", from, 2.2 - t, nil, 0, "#bfe4ff")
        pen.image("art/glow.png", at, 2.4, nil, 0, "#5a8cff50")
    end)
end

function effects.number(at, amount)
    local text, size = math.max(1, math.floor(amount + 0.5)), math.min(0.85, 0.4 + 0.03 * amount)
    at = at + vec(0.6 * chance() - 0.3, 0.6)
    add(PLAIN, 0.6, function(pen, t)
        pen.text(at + vec(0, 0.9 * t), text, size * (1.5 - 0.5 * math.min(1, 5 * t)), color(1, 0.94, 0.77, math.min(1, 2 - 2 * t)), "middle", "bold")
    end)
end

function effects.banner(title, text)
    lists[SCREEN] = {}
    add(SCREEN, 3, function(pen, t)
        local unit, at = view.screen.y / 800, vec(view.screen.x / 2, view.screen.y / 4)
        pen.fade(math.min(1, 12 * t, 3 - 3 * t))
        pen.text(at, title, 64 * unit * (1.6 - 0.6 * math.min(1, 12 * t)), "#ffd98a", "middle", "bold")
        pen.text(at + vec(0, 54 * unit), text, 24 * unit, "#e9e4ff")
    end)
end

function effects.update(dt)
    for _, list in ipairs(lists) do
        for i = #list, 1, -1 do
            list[i].age = list[i].age + dt
            if list[i].age >= list[i].life then table.remove(list, i) end
        end
    end
end

function effects.draw(pen, list)
    pen.push()
    pen.blend(list == BRIGHT and "add" or "normal")
    for _, it in ipairs(lists[list]) do it.draw(pen, it.age / it.life) end
    pen.pop()
end

return effects
