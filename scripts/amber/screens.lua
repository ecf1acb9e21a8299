-- Menus, the score of a level and what is written during play. All of it is drawn in the world, whose visible part is always 24 x 15 m.

local things, sound, fx = require("things"), require("sound"), require("fx")
local screens = { name = "title", age = 0, chosen = 1 }
local ink, gold, cream, dim = color("#1d1230"), things.gold, things.cream, color("#a99bc9")
local shown = 0                 -- points that the counting-up score shows

function screens.open(name)
    screens.name, screens.age, screens.chosen, shown = name, 0, 1, 0
    if name == "levels" then screens.chosen = math.min(screens.game.count, store.unlocked or 1) end
    if name == "won" then screens.chosen = 1 end
end

local function volume(key, default)
    return {
        text = key == "music" and "Music" or "Effects", level = function() return store[key] or default end,
        turn = function(way)
            store[key] = math.max(0, math.min(10, (store[key] or default) + way))
            sound.apply_volumes()
        end,
    }
end

-- The items of each screen: a text, what it does, for a slider how it turns, and where it is if not below the last.
local function items()
    local game, list = screens.game, {}
    local function item(text, action) list[#list + 1] = { text = text, action = action } end
    if screens.name == "title" then
        item((store.unlocked or 1) > 1 and "Continue" or "Play", function() game.play(math.min(store.unlocked or 1, game.count)) end)
        item("Levels", function() screens.open("levels") end)
        item("Settings", function() screens.back = "title" screens.open("settings") end)
        item("Quit", quit)
    elseif screens.name == "pause" then
        item("Resume", function() screens.open("play") end)
        item("Restart", function() game.play(game.level) end)
        item("Levels", function() screens.open("levels") end)
        item("Settings", function() screens.back = "pause" screens.open("settings") end)
        item("Title", game.title)
    elseif screens.name == "settings" then
        list = { volume("music", 7), volume("effects", 8) }
        item("Fullscreen: " .. (view.window.fullscreen and "on" or "off"), function() view.window.fullscreen = not view.window.fullscreen end)
        item("Erase scores", function() store:clear() sound.apply_volumes() end)
        item("Back", function() screens.open(screens.back) end)
    elseif screens.name == "won" then
        if game.level < game.count then
            item("Next level", function() game.play(game.level + 1) end)
        else
            item("The end", function() screens.open("finale") end)
        end
        item("Again", function() game.play(game.level) end)
        item("Levels", function() screens.open("levels") end)
    elseif screens.name == "finale" then
        item("Title", game.title)
    elseif screens.name == "levels" then
        for i = 1, game.count do item(tostring(i), i <= (store.unlocked or 1) and function() game.play(i) end) end
    end
    local top = ({ title = -1.3, pause = 1.8, settings = 1.8, won = -1.6, finale = -4.6 })[screens.name]
    for i, one in ipairs(list) do
        one.at, one.width, one.height = vec(0, (top or 0) - (i - 1) * 1.15), 6, 0.95
        if screens.name == "levels" then
            one.at = vec(((i - 1) % 4 - 1.5) * 4.2, 2.6 - (i - 1) // 4 * 3.1)
            one.width, one.height = 3.6, 2.6
        end
    end
    return list
end

local function item_at(point)
    for i, one in ipairs(items()) do
        if math.abs(point.x - one.at.x) < one.width / 2 and math.abs(point.y - one.at.y) < one.height / 2 then return i, one end
    end
end

local function choose(index)
    if index ~= screens.chosen then
        screens.chosen = index
        sound.play("tick")
    end
end

function screens.in_menu() return screens.name ~= "play" and screens.name ~= "lost" and screens.name ~= "home" end

function screens.point(point)
    if screens.in_menu() then choose(item_at(point) or screens.chosen) end
end

function screens.click(point)
    local i, one = item_at(point)
    if not i then return end
    screens.chosen = i
    if one.turn then one.turn(point.x > 1.4 and 1 or -1) sound.play("tick") else screens.confirm() end
end

function screens.confirm()
    local one = items()[screens.chosen]
    if one and one.action and screens.age > 0.15 then
        sound.play("press")
        one.action()
    end
end

function screens.leave()
    sound.play("tick")
    if screens.name == "settings" then screens.open(screens.back)
    elseif screens.name == "pause" then screens.open("play")
    elseif screens.name ~= "title" then screens.game.title() end
end

-- A step of the cursor, in a direction with x and y in -1, 0, 1.
function screens.move(x, y)
    local list = items()
    local one = list[screens.chosen]
    if one and one.turn and x ~= 0 then
        one.turn(x)
        sound.play("tick")
        return
    end
    local by = screens.name == "levels" and x - 4 * y or -y
    if #list > 0 and by ~= 0 then choose((screens.chosen - 1 + by) % #list + 1) end
end

function screens.update(dt)
    screens.age = screens.age + dt
    if screens.name == "won" and screens.age > 0.5 then shown = math.min(screens.result.score, shown + math.ceil(dt * 2600)) end
end

local function out_back(t) t = math.min(1, t) - 1 return math.max(0, 1 + 2.7 * t ^ 3 + 1.7 * t ^ 2) end

local function draw_diamond(pen, at, size, full)
    pen.polygon({ at + vec(0, size), at + vec(size * 0.62, 0), at + vec(0, -size), at + vec(-size * 0.62, 0) },
        full and cream or false, full and gold or dim, 3)
end

local function panel(pen, at, width, height)
    pen.box(at, width, height, things.faded(ink, 0.86), things.faded(gold, 0.7), 3)
end

local function draw_items(pen)
    for i, one in ipairs(items()) do
        local chosen = i == screens.chosen
        local grow = out_back(math.max(0, (screens.age - i * 0.03) * 4)) * (chosen and 1.06 + 0.02 * math.sin(time.real * 6) or 1)
        if screens.name == "levels" then
            local best = (store.levels or {})[i]
            pen.box(one.at, one.width * grow, one.height * grow, things.faded(ink, one.action and 0.85 or 0.45), chosen and gold or things.faded(dim, 0.5), chosen and 4 or 2)
            pen.text(one.at + vec(0, 0.5), one.text, 1.0 * grow, one.action and (chosen and gold or cream) or things.faded(dim, 0.4), nil, "bold")
            for k = 1, 3 do draw_diamond(pen, one.at + vec((k - 2) * 0.65, -0.35), 0.26, best and best.sparks >= k) end
            if best then pen.text(one.at + vec(0, -0.93), tostring(best.score), 0.42, dim) end
        else
            if chosen then pen.box(one.at, one.width * grow, one.height, gold, cream, 3) end
            if one.level then
                pen.text(one.at - vec(2.6, 0), one.text, 0.55, chosen and ink or cream, "left", "bold")
                for k = 1, 10 do
                    pen.box(one.at + vec(0.1 + k * 0.25, 0), 0.16, 0.2 + k * 0.04, k <= one.level() and (chosen and ink or gold) or things.faded(dim, 0.5))
                end
            else
                pen.text(one.at, one.text, 0.62 * grow, chosen and ink or cream, nil, "bold")
            end
        end
    end
end

local function total()
    local points, sparks = 0, 0
    for _, best in pairs(store.levels or {}) do points, sparks = points + best.score, sparks + best.sparks end
    return points, sparks
end

function screens.draw_play(pen, past, tide)
    local game = screens.game
    pen.text(vec(-11.6, 6.9), game.level .. "  " .. (world.level and world.level.title or ""), 0.62, cream, "left", "bold")
    for k = 1, 3 do draw_diamond(pen, vec(9.6 + k * 0.62, 6.9), 0.27, game.sparks() >= k) end
    if past > 0.5 then
        local long = math.min(1, past / 20) * 10
        pen.box(vec(0, -7.15), 10.2, 0.2, things.faded(ink, 0.6))
        pen.box(vec(-5 + long / 2, -7.15), long, 0.12, things.pale:lerp(gold, 0))
        pen.circle(vec(-5 + long, -7.15), 0.13 + 0.1 * tide, things.pale)
    end
end

function screens.draw(pen)
    local game = screens.game
    if screens.in_menu() and screens.name ~= "title" then pen.box(vec(0, 0), 40, 16, things.faded(ink, math.min(0.6, screens.age * 3))) end
    if screens.name == "title" then
        local drop = out_back(screens.age * 1.6)
        pen.text(vec(0.08, 4.42 - drop), "AMBER", 3.4, things.faded(ink, 0.6), nil, "bold")
        pen.text(vec(0, 4.5 - drop), "AMBER", 3.4, gold, nil, "bold")
        pen.text(vec(0, 1.35), "Time touches everything but you.", 0.62, cream)
        local points, sparks = total()
        if points > 0 then pen.text(vec(0, -6.3), string.format("Best: %d points, %d of %d sparks", points, sparks, 3 * game.count), 0.5, gold) end
        pen.text(vec(0, -7.0), "Mouse, keyboard or gamepad", 0.36, dim)
    elseif screens.name == "pause" or screens.name == "settings" then
        panel(pen, vec(0, 0.2), 8, 8.2)
        pen.text(vec(0, 3.3), screens.name == "pause" and "Paused" or "Settings", 1, gold, nil, "bold")
    elseif screens.name == "levels" then
        pen.text(vec(0, 5.6), "Levels", 1.2, gold, nil, "bold")
    elseif screens.name == "won" then
        local result = screens.result
        panel(pen, vec(0, 0.2), 10, 9.4 * out_back(screens.age * 3))
        pen.text(vec(0, 3.9), world.level and world.level.title or "", 0.7, cream, nil, "bold")
        for k = 1, 3 do
            local grow = out_back(math.max(0, screens.age * 3 - 0.5 * k))
            draw_diamond(pen, vec((k - 2) * 1.6, 2.4), 0.75 * math.max(0.3, grow), result.sparks >= k and grow > 0)
        end
        pen.text(vec(0, 0.75), tostring(shown), 1.2, gold, nil, "bold")
        pen.text(vec(0, -0.3), string.format("%.1f s", result.seconds) .. (result.record and "    New best!" or "    Best " .. result.best), 0.5, result.record and gold or dim)
    elseif screens.name == "finale" then
        local points, sparks = total()
        pen.text(vec(0, 4.4), "Out of time", 2.2 * out_back(screens.age * 2), gold, nil, "bold")
        pen.text(vec(0, 1.2), "The last drop is home.\nThe wheels go on without you.", 0.7, cream)
        pen.text(vec(0, -1.3), string.format("%d points", points), 1.3, gold, nil, "bold")
        pen.text(vec(0, -2.7), string.format("%d of %d sparks", sparks, 3 * game.count), 0.7, cream)
    end
    draw_items(pen)
end

return screens
