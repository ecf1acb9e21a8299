-- Menus, the score of a level and what is written during play, all of it drawn in the world, of which 24 x 15 m are seen.

local things, sound = require("things"), require("sound")
local screens = { name = "title", age = 0, chosen = 1, game = { count = 12, level = 0 } }
local ink, gold, cream, dim, faded = things.ink, things.gold, things.cream, color("#a99bc9"), things.faded
local shown, sure = 0, false    -- the points that are counted up; whether erasing was asked for
local tops = { title = -1.3, pause = 1.8, settings = 1.8, won = -1.7, finale = -4.6 }

-- The last level that can be played.
function screens.reached() return math.min(screens.game.count, store.unlocked or 1) end

-- Whether a level is on the screen, and no menu.
function screens.in_level() return screens.name == "play" or screens.name == "lost" or screens.name == "home" end

function screens.open(name)
    screens.name, screens.age, screens.chosen, shown, sure = name, 0, name == "levels" and screens.reached() or 1, 0, false
end

local function opens(name, back) return function() screens.back = back or screens.back screens.open(name) end end
local function plays(level) return function() screens.game.play(level) end end

local function volume(key, text, default)
    return { text, level = store[key] or default, turn = function(way)
        store[key] = math.max(0, math.min(10, (store[key] or default) + way))
        sound.apply_volumes()
    end }
end

local function erase()
    if not sure then sure = true return end
    store:clear()
    sound.apply_volumes()
    screens.open("settings")
end

-- The items of each screen: a text and what it does, and for a slider how it turns.
local menus = {
    title = function(game)
        return { { screens.reached() > 1 and "Continue" or "Play", plays(screens.reached()) }, { "Levels", opens("levels") },
            { "Settings", opens("settings", "title") }, { "Quit", quit } }
    end,
    pause = function(game)
        return { { "Resume", opens("play") }, { "Restart", plays(game.level) }, { "Levels", opens("levels") },
            { "Settings", opens("settings", "pause") }, { "Title", game.title } }
    end,
    settings = function()
        local window = view.window
        return { volume("music", "Music", 7), volume("effects", "Effects", 8),
            { "Fullscreen: " .. (window.fullscreen and "on" or "off"), function() window.fullscreen = not window.fullscreen end },
            { sure and "Really erase?" or "Erase scores", erase }, { "Back", opens(screens.back) } }
    end,
    won = function(game)
        local last = game.level == game.count
        return { { last and "The end" or "Next level", last and opens("finale") or plays(game.level + 1) },
            { "Again", plays(game.level) }, { "Levels", opens("levels") } }
    end,
    finale = function(game) return { { "Title", game.title } } end,
    levels = function(game)
        local list = {}
        for i = 1, game.count do list[i] = { tostring(i), i <= screens.reached() and plays(i) } end
        return list
    end,
}

local function items()
    local list, cards = menus[screens.name] and menus[screens.name](screens.game) or {}, screens.name == "levels"
    for i, item in ipairs(list) do
        item.at = cards and vec(((i - 1) % 4 - 1.5) * 4.2, 2.6 - (i - 1) // 4 * 3.1) or vec(0, tops[screens.name] - (i - 1) * 1.15)
        item.width, item.height = cards and 3.6 or 6, cards and 2.6 or 0.95
    end
    return list
end

local function choose(index)
    if index ~= screens.chosen then sound.play("tick") end
    screens.chosen = index
end

function screens.confirm()
    local item = items()[screens.chosen]
    if not item or not item[2] or screens.age < 0.15 then return end
    sound.play("press")
    item[2]()
end

-- The mouse is at a point, and its button was pressed there or not.
function screens.point(point, pressed)
    for i, item in ipairs(items()) do
        if math.abs(point.x - item.at.x) < item.width / 2 and math.abs(point.y - item.at.y) < item.height / 2 then
            choose(i)
            if pressed and item.turn then item.turn(point.x > 1.4 and 1 or -1) elseif pressed then screens.confirm() end
        end
    end
end

function screens.leave()
    if screens.name == "title" then return end
    sound.play("tick")
    local back = { settings = screens.back, pause = "play" }
    if back[screens.name] then screens.open(back[screens.name]) else screens.game.title() end
end

function screens.move(x, y)
    local list = items()
    if list[screens.chosen].turn and x ~= 0 then return list[screens.chosen].turn(x) end
    choose((screens.chosen - 1 + math.tointeger(screens.name == "levels" and x - 4 * y or -y)) % #list + 1)
end

function screens.update(dt)
    screens.age = screens.age + dt
    if screens.name == "won" and screens.age > 0.5 then shown = math.min(screens.result.score, shown + math.ceil(dt * 2600)) end
end

local function grown(t) t = math.max(0, math.min(1, t)) - 1 return math.max(0, 1 + 2.7 * t ^ 3 + 1.7 * t ^ 2) end

local function draw_spark(pen, x, y, size, full)
    pen.image("art/spark.png", vec(x, y), size, nil, nil, full and "white" or faded(color("#3a2f5c"), 0.9))
end

local function draw_item(pen, i, item)
    local chosen, at = i == screens.chosen, item.at
    local grow = grown(screens.age * 4 - i * 0.12) * (chosen and 1.06 + 0.02 * math.sin(time.real * 6) or 1)
    if screens.name == "levels" then
        local best, open = (store.levels or {})[i], item[2]
        local edge, paper = chosen and gold or faded(dim, 0.5), faded(ink, open and 0.85 or 0.45)
        pen.box(at, item.width * grow, item.height * grow, paper, edge, chosen and 4 or 2)
        pen.text(at + vec(0, 0.55), item[1], 1.0 * grow, open and (chosen and gold or cream) or faded(dim, 0.4), nil, "bold")
        for k = 1, 3 do draw_spark(pen, at.x + (k - 2) * 0.65, at.y - 0.3, 0.36, best and best.sparks >= k) end
        if best then pen.text(at - vec(0, 0.95), best.score, 0.42, dim) end
        return
    end
    if chosen then pen.box(at, item.width * grow, item.height, gold, cream, 3) end
    pen.text(at - vec(item.turn and 2.6 or 0, 0), item[1], 0.62 * grow, chosen and ink or cream, item.turn and "left" or nil, "bold")
    for k = 1, item.turn and 10 or 0 do
        local tint = k > item.level and faded(dim, 0.5) or chosen and ink or gold
        pen.box(at + vec(0.1 + k * 0.25, 0), 0.16, 0.2 + k * 0.04, tint)
    end
end

local function total()
    local points, sparks = 0, 0
    for _, best in pairs(store.levels or {}) do points, sparks = points + best.score, sparks + best.sparks end
    return string.format("%d points, %d of %d sparks", points, sparks, 3 * screens.game.count)
end

local function headline(pen, y, text, size) pen.text(vec(0, y), text, size, gold, nil, "bold") end

local heads = {
    title = function(pen)
        pen.text(vec(0.1, 4.4 - grown(screens.age * 1.6)), "AMBER", 3.4, faded(ink, 0.7), nil, "bold")
        headline(pen, 4.5 - grown(screens.age * 1.6), "AMBER", 3.4)
        pen.text(vec(0, 1.3), "Time touches everything but you.", 0.62, cream)
        if store.levels then pen.text(vec(0, -6.1), total(), 0.5, gold) end
        pen.text(vec(0, -6.95), "Mouse, keyboard or gamepad", 0.36, dim)
    end,
    pause = function(pen) headline(pen, 3.4, "Paused", 1) end,
    settings = function(pen) headline(pen, 3.4, "Settings", 1) end,
    levels = function(pen) headline(pen, 5.6, "Levels", 1.2) end,
    finale = function(pen)
        headline(pen, 4, "Out of time", 2.2 * grown(screens.age * 2))
        pen.text(vec(0, 0.8), "The last drop is home.\nThe wheels turn on without you.", 0.7, cream)
        headline(pen, -1.9, total(), 0.9)
    end,
    won = function(pen)
        local result = screens.result
        pen.text(vec(0, 3.9), world.level.title, 0.8, cream, nil, "bold")
        for k = 1, 3 do
            local grow = grown(screens.age * 3 - 0.5 * k)
            draw_spark(pen, (k - 2) * 1.6, 2.35, 0.95 * math.max(0.4, grow), result.sparks >= k and grow > 0)
        end
        headline(pen, 0.65, shown, 1.2)
        local best = result.record and "New best!" or "Best: " .. result.best
        pen.text(vec(0, -0.5), string.format("%.1f s     %s", result.seconds, best), 0.5, dim)
    end,
}

function screens.draw_play(pen, past)
    pen.text(vec(-11.6, 6.9), screens.game.level .. "  " .. world.level.title, 0.62, cream, "left", "bold")
    for k = 1, 3 do draw_spark(pen, 9.6 + k * 0.65, 6.85, 0.4, screens.game.sparks() >= k) end
    pen.text(vec(11.6, -7.1), "R again    P pause", 0.34, faded(dim, 0.8), "right")
    local long = math.min(10, past / 2)
    pen.box(vec(0, -7.15), 10.2, 0.22, faded(ink, 0.6))
    pen.box(vec(-5 + long / 2, -7.15), long, 0.12, things.pale)
    pen.circle(vec(-5 + long, -7.15), 0.15, things.pale)
end

function screens.draw(pen)
    if screens.name ~= "title" then pen.box(vec(0, 0), 40, 16, faded(ink, math.min(0.6, screens.age * 3))) end
    if screens.name == "pause" or screens.name == "settings" or screens.name == "won" then
        pen.box(vec(0, 0), 9, 9.8 * grown(screens.age * 3), faded(ink, 0.86), faded(gold, 0.7), 3)
    end
    heads[screens.name](pen)
    for i, item in ipairs(items()) do draw_item(pen, i, item) end
end

return screens
