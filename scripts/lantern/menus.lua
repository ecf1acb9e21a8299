-- What lies over the picture: menus, the choice of a gift, and the bars while one plays. Sizes are those of a screen 800 px high.
local effects, arenas = require "effects", require "arenas"
local gold, ink, dim, teal = color("#ffd98a"), color("#f3efff"), color("#a79fc9"), color("#5ef2c4")
local menu, opened, shown, unit, middle = {}, 0, "", 1, 640

function menu.open(name)
    night.menu, night.pick = name, 1
    sounds.blip:play()
end
local function opens(label, name) return { label, go = function() menu.open(name) end } end
local function setting(label, owner, name) return { label,
    value = function() return owner[name] == true and "on" or not owner[name] and "off" or math.floor(100 * owner[name] + 0.5) .. " %" end,
    go = function(by)
        owner[name] = type(owner[name]) == "number" and math.max(0, math.min(1, owner[name] + 0.1 * by)) or owner[name] == false
        store.settings = { effects = settings.effects, music = settings.music, shake = settings.shake }
    end } end
local back = { "Back", go = function() menu.open(night.running and "pause" or "title") end }
local start = { "Light the lantern", go = function() night:begin() end }
local menus = {
    title = { y = 500, start, { "Arena", value = function() return arenas[night.first].name end,
        go = function(by) night.first = (night.first - 1 + by) % (store.unlocked or 1) + 1 end },
        opens("Settings", "settings"), { "Quit", go = function() quit() end } },
    settings = { y = 320, head = "Settings", setting("Sounds", settings, "effects"), setting("Music", settings, "music"),
        setting("Shaking", settings, "shake"), setting("Full screen", view.window, "fullscreen"), back },
    pause = { y = 360, head = "Pause", opens("Go on", ""), opens("Settings", "settings"), { "Give up", go = function() night:finish("over") end } },
    over = { y = 660, head = "The light went out", start, opens("Title", "title") },
    win = { y = 660, head = "Morning came", start, opens("Title", "title") },
    choose = { y = 300, head = "The light grows" },
}
local function items()
    local gifts = {}
    for i, name in ipairs(night.choices) do gifts[i] = { name, go = function() menu.open("") arms.take(name) end } end
    return night.menu == "choose" and gifts or menus[night.menu] or {}
end
local function place_of(i)                       -- height, and its distance from the upper edge
    local height = night.menu == "choose" and 130 or 48
    return menus[night.menu].y + (height + 4) * (i - 1), height
end
local function go(by)
    if time.real - opened < (night.menu == "choose" and 0.4 or 0.15) then return end
    items()[night.pick].go(by)
    sounds.blip:play()
end

function mouse_moved(_, point)                   -- whether it is on an item, which is then the chosen one
    for i in ipairs(items()) do
        local y, height = place_of(i)
        if math.abs(point.x / unit - middle) < 280 and math.abs(point.y / unit - y) < height / 2 then night.pick = i return true end
    end
end
function mouse_pressed(button, _, point)
    if button == "left" and mouse_moved(nil, point) then go(1) end
end
local function pressed(name) return input[name].pressed and 1 or 0 end

-- Once a frame. A menu over a running game slows time down until it stands still, and the music with it.
function menu.update(real_dt)
    local open, all, across = night.running and night.menu ~= "", items(), pressed "menu_right" - pressed "menu_left"
    unit, middle = view.screen.y / 800, view.screen.x / view.screen.y * 400
    if night.menu ~= shown then opened, shown = time.real, night.menu end
    if #all > 0 then
        night.pick = (night.pick - 1 + pressed "menu_down" - pressed "menu_up") % #all + 1
        if across ~= 0 and all[night.pick].value then go(across) elseif input.accept.pressed then go(1)
        elseif input.back.pressed and all[#all] == back then back.go()
        elseif input.pause.pressed and night.menu == "pause" then menu.open("") end
    elseif input.pause.pressed and night.running then menu.open("pause") end
    time.scale = math.max(0, math.min(1, time.scale + (open and -5 or 3) * real_dt))
    time.paused = open and time.scale == 0
end

local function text(pen, x, y, words, size, tint, align, font) pen.text(vec(x, y) * unit, words, size * unit, tint or ink, align, font or "bold") end
local function box(pen, x, y, width, height, ...) pen.box(vec(x, y) * unit, width * unit, height * unit, ...) end
local function image(pen, name, x, y, width, height, tint)
    pen.image("art/" .. name .. ".png", vec(x, y) * unit, width * unit, height * unit, 0, tint)
end
local function bar(pen, x, y, width, height, part, tint)
    box(pen, x, y, width + 4, height + 4, "#0a0718d0")
    box(pen, x - width * (1 - part) / 2, y, width * math.min(1, part), height, tint)
end

local function draw_item(pen, item, y, height, chosen)
    local gift, tint = night.menu == "choose" and arms.all[item[1]], chosen and gold or ink
    if chosen then image(pen, "glow", middle, y, gift and 900 or 600, height * 2.2, "#ffb35a70") end
    if not gift then return text(pen, middle, y, item[1] .. (item.value and "   ‹ " .. item.value() .. " ›" or ""), 28, tint) end
    local level = arms.level(item[1])
    box(pen, middle, y, 560, height, "#120f26f0", chosen and gold or "#4a4080", 2 * unit)
    image(pen, "icon_" .. item[1], middle - 214, y, 104, 104)
    text(pen, middle - 145, y - 20, gift.name, 28, tint, "left")
    text(pen, middle - 145, y + 20, gift.text, 20, dim, "left", "sans")
    text(pen, middle + 262, y - 20, level == 0 and "new!" or "level " .. level + 1, 20, level == 0 and teal or gold, "right")
end

local function draw_menu(pen)
    local title, rows = night.menu == "title", (night.menu == "over" or night.menu == "win") and store.scores or {}
    if title then
        image(pen, "glow", middle, 190, 1000, 420, "#ff9a4a55")
        text(pen, middle, 280, "Keep the light until morning. A thousand come to put it out.", 24, ink, "middle", "sans")
        text(pen, middle, 738, "W A S D, arrows, stick or held mouse button: walk        Space, A or right mouse button: dash", 18, dim, "middle", "sans")
        text(pen, middle, 772, store.scores and "Best  " .. store.scores[1].score or "", 20, teal)
    else
        box(pen, middle, 400, 4000, 800, "#070414b0")
    end
    text(pen, middle, title and 178 + 6 * math.sin(1.5 * time.real) or 120, menus[night.menu].head or "LANTERN", title and 132 or 64, gold)
    if rows[1] then text(pen, middle, 190, night.score .. " points", 28) end
    for i, row in ipairs(rows) do
        local y, tint = 205 + 44 * i, i == night.rank and gold or ink
        text(pen, middle - 60, y, i .. ".    " .. row.score, 26, tint, "right")
        text(pen, middle, y, (row.won and "morning" or arenas[row.arena].name) .. ",  " .. row.kills .. " banished", 22, dim, "left", "sans")
    end
    for i, item in ipairs(items()) do
        local y, height = place_of(i)
        draw_item(pen, item, y, height, i == night.pick)
    end
end

local function draw_bars(pen)
    local hero, arena, place, left = world.hero, arenas[night.arena], 0, math.ceil(arenas[night.arena].length - night.clock)
    bar(pen, middle, 8, 2 * middle, 10, hero.xp / hero:need(), teal)
    text(pen, 20, 38, "Level " .. hero.level, 22, teal, "left")
    bar(pen, 130, 68, 220, 18, hero.hp / hero.max_hp, hero.hp < 30 and "#ff4a5e" or "#e8743f")
    text(pen, 130, 68, math.ceil(hero.hp) .. " / " .. math.floor(hero.max_hp), 15)
    text(pen, 2 * middle - 20, 42, night.score, 32, gold, "right")
    text(pen, 2 * middle - 20, 74, night.kills .. " banished", 18, dim, "right")
    for _, name in ipairs(arms.order) do
        for i = 1, arms.level(name) do box(pen, 13 + 56 * place + 9 * i, 784, 6, 6, gold) end
        if arms.level(name) > 0 then image(pen, "icon_" .. name, 40 + 56 * place, 752, 46, 46) place = place + 1 end
    end
    if world.swarm:has("boss") then bar(pen, middle, 76, 520, 16, world.swarm.boss.hp / world.swarm.boss.max_hp, "#ff5a6e") end
    if night.rest == 0 then text(pen, middle, 44, left > 0 and string.format("%d:%02d", left // 60, left % 60) or arena.boss, 34) end
    if left > 0 then text(pen, middle, 76, arena.boss .. " comes", 16, dim) end
end

function menu.draw(pen)
    pen.screen(function()
        image(pen, "dark", middle, 400, 2.5 * middle, 1160, arenas[night.arena].ink)
        if night.running then draw_bars(pen) end
        if night.menu == "" then effects.draw(pen, 3) end
        if night.menu ~= "" then draw_menu(pen) end
        if night.curtain > 0 then box(pen, middle, 400, 2 * middle, 800, color(0.02, 0.01, 0.05, night.curtain)) end
    end)
end

return menu
