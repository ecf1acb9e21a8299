-- Menus, the score of a level and what is written during play, all of it drawn in the world, of which 24 x 15 m are seen.

local things, sound = require("things"), require("sound")
local screens = { name = "title", age = 0, chosen = 1 }
local ink, gold, cream, dim, faded = things.ink, things.gold, things.cream, color("#a99bc9"), things.faded
local shown, sure = 0, false    -- the points that are counted up; whether erasing was asked for
local tops = { title = -1.3, pause = 1.8, settings = 1.8, won = -1.9, finale = -4.6 }

function screens.open(name)
    screens.name, screens.age, screens.chosen, shown, sure = name, 0, 1, 0, false
    if name == "levels" then screens.chosen = screens.reached() end
end

-- The last level that can be played.
function screens.reached() return math.min(screens.game.count, store.unlocked or 1) end

-- Whether a menu is open, and whether a level is on the screen.
function screens.in_menu() return not screens.in_level() end
function screens.in_level() return screens.name == "play" or screens.name == "lost" or screens.name == "home" end

local function opens(name, back) return function() screens.back = back or screens.back screens.open(name) end end

local function volume(key, text, default)
    local function turn(way)
        store[key] = math.max(0, math.min(10, (store[key] or default) + way))
        sound.apply_volumes()
    end
    return { text, turn = turn, level = store[key] or default }
end

local function erase()
    if sure then store:clear() sound.apply_volumes() screens.open("settings") else sure = true end
end

-- The items of each screen: a text and what it does, and for a slider how it turns.
local menus = {
    title = function(game)
        return { { screens.reached() > 1 and "Continue" or "Play", function() game.play(screens.reached()) end },
            { "Levels", opens("levels") }, { "Settings", opens("settings", "title") }, { "Quit", quit } }
    end,
    pause = function(game)
        return { { "Resume", opens("play") }, { "Restart", function() game.play(game.level) end },
            { "Levels", opens("levels") }, { "Settings", opens("settings", "pause") }, { "Title", game.title } }
    end,
    settings = function()
        local window = view.window
        return { volume("music", "Music", 7), volume("effects", "Effects", 8),
            { "Fullscreen: " .. (window.fullscreen and "on" or "off"), function() window.fullscreen = not window.fullscreen end },
            { sure and "Really erase?" or "Erase scores", erase }, { "Back", opens(screens.back) } }
    end,
    won = function(game)
        local last = game.level == game.count
        return { { last and "The end" or "Next level", last and opens("finale") or function() game.play(game.level + 1) end },
            { "Again", function() game.play(game.level) end }, { "Levels", opens("levels") } }
    end,
    finale = function(game) return { { "Title", game.title } } end,
    levels = function(game)
        local list = {}
        for i = 1, game.count do list[i] = { tostring(i), i <= screens.reached() and function() game.play(i) end } end
        return list
    end,
}

local function items()
    local list = menus[screens.name] and menus[screens.name](screens.game) or {}
    for i, item in ipairs(list) do
        item.at, item.width, item.height = vec(0, (tops[screens.name] or 0) - (i - 1) * 1.15), 6, 0.95
        if screens.name == "levels" then
            item.at, item.width, item.height = vec(((i - 1) % 4 - 1.5) * 4.2, 2.6 - (i - 1) // 4 * 3.1), 3.6, 2.6
        end
    end
    return list
end

local function choose(index)
    if index ~= screens.chosen then sound.play("tick") end
    screens.chosen = index
end

-- The mouse is at a point, and its button was pressed there or not.
function screens.point(point, pressed)
    for i, item in ipairs(items()) do
        if math.abs(point.x - item.at.x) < item.width / 2 and math.abs(point.y - item.at.y) < item.height / 2 then
            choose(i)
            if pressed and item.turn then item.turn(point.x > 1.4 and 1 or -1) sound.play("tick")
            elseif pressed then screens.confirm() end
        end
    end
end

function screens.confirm()
    local item = items()[screens.chosen]
    if not item or not item[2] or screens.age < 0.15 then return end
    sound.play("press")
    item[2]()
end

function screens.leave()
    if screens.name == "title" then return end
    sound.play("tick")
    if screens.name == "settings" then screens.open(screens.back) elseif screens.name == "pause" then screens.open("play")
    else screens.game.title() end
end

function screens.move(x, y)
    local list = items()
    local item = list[screens.chosen]
    if item.turn and x ~= 0 then
        item.turn(x)
        sound.play("tick")
    else
        choose((screens.chosen - 1 + (screens.name == "levels" and x - 4 * y or -y)) % #list + 1)
    end
end

function screens.update(dt)
    screens.age = screens.age + dt
    if screens.name == "won" and screens.age > 0.5 then shown = math.min(screens.result.score, shown + math.ceil(dt * 2600)) end
end

local function grown(t) t = math.max(0, math.min(1, t)) - 1 return math.max(0, 1 + 2.7 * t ^ 3 + 1.7 * t ^ 2) end

local function draw_spark(pen, at, size, full)
    pen.image("art/spark.png", at, size, nil, nil, full and "white" or faded(color("#3a2f5c"), 0.9))
end

local function draw_item(pen, i, item)
    local chosen = i == screens.chosen
    local grow = grown(screens.age * 4 - i * 0.12) * (chosen and 1.06 + 0.02 * math.sin(time.real * 6) or 1)
    local tint = chosen and ink or cream
    if screens.name == "levels" then
        local best = (store.levels or {})[i]
        tint = item[2] and (chosen and gold or cream) or faded(dim, 0.4)
        pen.box(item.at, item.width * grow, item.height * grow, faded(ink, item[2] and 0.85 or 0.45), chosen and gold or faded(dim, 0.5), chosen and 4 or 2)
        pen.text(item.at + vec(0, 0.55), item[1], 1.0 * grow, tint, nil, "bold")
        for k = 1, 3 do draw_spark(pen, item.at + vec((k - 2) * 0.65, -0.3), 0.36, best and best.sparks >= k) end
        if best then pen.text(item.at + vec(0, -0.95), best.score, 0.42, dim) end
        return
    end
    if chosen then pen.box(item.at, item.width * grow, item.height, gold, cream, 3) end
    pen.text(item.at - vec(item.turn and 2.6 or 0, 0), item[1], 0.62 * grow, tint, item.turn and "left" or nil, "bold")
    for k = 1, item.turn and 10 or 0 do
        pen.box(item.at + vec(0.1 + k * 0.25, 0), 0.16, 0.2 + k * 0.04, k <= item.level and (chosen and ink or gold) or faded(dim, 0.5))
    end
end

local function total()
    local points, sparks = 0, 0
    for _, best in pairs(store.levels or {}) do points, sparks = points + best.score, sparks + best.sparks end
    return string.format("%d points, %d of %d sparks", points, sparks, 3 * screens.game.count), points
end

local heads = {
    title = function(pen)
        local y = 4.5 - grown(screens.age * 1.6)
        pen.text(vec(0.1, y - 0.1), "AMBER", 3.4, faded(ink, 0.7), nil, "bold")
        pen.text(vec(0, y), "AMBER", 3.4, gold, nil, "bold")
        pen.text(vec(0, 1.3), "Time touches everything but you.", 0.62, cream)
        local best, points = total()
        if points > 0 then pen.text(vec(0, -6.1), best, 0.5, gold) end
        pen.text(vec(0, -6.95), "Mouse, keyboard or gamepad", 0.36, dim)
    end,
    levels = function(pen) pen.text(vec(0, 5.6), "Levels", 1.2, gold, nil, "bold") end,
    finale = function(pen)
        pen.text(vec(0, 4), "Out of time", 2.2 * grown(screens.age * 2), gold, nil, "bold")
        pen.text(vec(0, 0.8), "The last drop is home.\nThe wheels turn on without you.", 0.7, cream)
        pen.text(vec(0, -1.9), total(), 0.9, gold, nil, "bold")
    end,
    won = function(pen)
        local result = screens.result
        pen.text(vec(0, 3.9), world.level.title, 0.8, cream, nil, "bold")
        for k = 1, 3 do
            local grow = grown(screens.age * 3 - 0.5 * k)
            draw_spark(pen, vec((k - 2) * 1.6, 2.35), 0.95 * math.max(0.4, grow), result.sparks >= k and grow > 0)
        end
        pen.text(vec(0, 0.65), shown, 1.2, gold, nil, "bold")
        pen.text(vec(0, -0.5), string.format("%.1f s     ", result.seconds) .. (result.record and "New best!" or "Best: " .. result.best), 0.5, dim)
    end,
}

function screens.draw_play(pen, past)
    local game = screens.game
    pen.text(vec(-11.6, 6.9), game.level .. "  " .. world.level.title, 0.62, cream, "left", "bold")
    for k = 1, 3 do draw_spark(pen, vec(9.6 + k * 0.65, 6.85), 0.4, game.sparks() >= k) end
    pen.text(vec(11.6, -7.1), "R again    P pause", 0.34, faded(dim, 0.8), "right")
    if past < 0.5 then return end
    local long = math.min(1, past / 20) * 10
    pen.box(vec(0, -7.15), 10.2, 0.22, faded(ink, 0.6))
    pen.box(vec(-5 + long / 2, -7.15), long, 0.12, things.pale)
    pen.circle(vec(-5 + long, -7.15), 0.15, things.pale)
end

function screens.draw(pen)
    if screens.in_level() then return end
    if screens.name ~= "title" then pen.box(vec(0, 0), 40, 16, faded(ink, math.min(0.6, screens.age * 3))) end
    if tops[screens.name] and tops[screens.name] > -2 and screens.name ~= "title" then
        pen.box(vec(0, 0.1), 9, 9.2 * grown(screens.age * 3), faded(ink, 0.86), faded(gold, 0.7), 3)
    end
    local head = heads[screens.name]
    if head then head(pen) else pen.text(vec(0, 3.4), screens.name == "pause" and "Paused" or "Settings", 1, gold, nil, "bold") end
    for i, item in ipairs(items()) do draw_item(pen, i, item) end
end

return screens
