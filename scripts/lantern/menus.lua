-- What lies over the picture: menus, the choice of a gift, and the bars while one plays. Sizes are those of a screen 800 px high.
local common, effects, arenas = require "common", require "effects", require "arenas"
local gold, ink, dim, teal = color("#ffd98a"), color("#f3efff"), color("#a79fc9"), color("#5ef2c4")
local menu, opened, shown = {}, 0, ""
local unit, middle = 1, 640

function menu.open(name)
    night.menu, night.pick = name, 1
    sounds.blip:play()
end

local function opens(label, name) return { label, go = function() menu.open(name) end } end
local function volume(label, name) return { label,
    value = function() return math.floor(10 * settings[name] + 0.5) * 10 .. " %" end,
    go = function(by) settings[name] = math.max(0, math.min(1, math.floor(10 * settings[name] + by + 0.5) / 10)) end } end
local function switch(label, owner, name) return { label,
    value = function() return owner[name] and "on" or "off" end, go = function() owner[name] = not owner[name] end } end
local back = { "Back", go = function() menu.open(night.running and "pause" or "title") end }
local start = { "Light the lantern", go = function() menu.begin() end }

local menus = {
    title = { y = 500, start, opens("Settings", "settings"), opens("High scores", "scores"), { "Quit", go = function() quit() end },
        { "Arena", value = function() return arenas[night.first].name end,
          go = function(by) night.first = (night.first - 1 + by) % (store.unlocked or 1) + 1 end } },
    settings = { y = 320, head = "Settings", volume("Sounds", "effects"), volume("Music", "music"), switch("Shaking", settings, "shake"),
        switch("Full screen", view.window, "fullscreen"), back },
    scores = { y = 700, head = "High scores", back },
    pause = { y = 360, head = "Pause", opens("Go on", ""), opens("Settings", "settings"),
        { "Give up", go = function() menu.open("") common.ended("over") end } },
    over = { y = 650, head = "The light went out", start, opens("Title", "title") },
    win = { y = 650, head = "Morning came", start, opens("Title", "title") },
    choose = { y = 440, head = "The light grows" },
}

local function items()
    if night.menu ~= "choose" then return menus[night.menu] or {} end
    local cards = {}
    for i, name in ipairs(night.choices) do
        cards[i] = { name, go = function() menu.open("") arms.take(name) end }
    end
    return cards
end

-- Middle, width and height of an item.
local function place_of(i, count)
    if night.menu == "choose" then return middle + (i - (count + 1) / 2) * 290, menus.choose.y, 260, 330 end
    return middle, menus[night.menu].y + 50 * (i - 1), 460, 46
end

local function item_at(point)
    local all = items()
    for i in ipairs(all) do
        local x, y, width, height = place_of(i, #all)
        if math.abs(point.x / unit - x) < width / 2 and math.abs(point.y / unit - y) < height / 2 then return i end
    end
end

local function go(item, by)
    if time.real - opened > (night.menu == "choose" and 0.4 or 0.15) then item.go(by) sounds.blip:play() end
end

function mouse_moved(_, point) night.pick = item_at(point) or night.pick end
function mouse_pressed(button, _, point)
    night.pick = item_at(point) or night.pick
    if button == "left" and item_at(point) then go(items()[night.pick], 1) end
end

local function pressed(name) return input[name].pressed and 1 or 0 end

-- Once a frame. A menu over a running game slows time down until it stands still, and the music with it.
function menu.update(real_dt)
    unit, middle = view.screen.y / 800, view.screen.x / view.screen.y * 400
    if night.menu ~= shown then opened, shown = time.real, night.menu end
    local all, cards = items(), night.menu == "choose"
    if #all > 0 then
        local across, down = pressed "menu_right" - pressed "menu_left", pressed "menu_down" - pressed "menu_up"
        night.pick = (night.pick - 1 + (cards and across or down)) % #all + 1
        if across ~= 0 and all[night.pick].value then go(all[night.pick], across) end
        if input.accept.pressed then go(all[night.pick], 1)
        elseif input.pause.pressed and night.menu == "pause" then menu.open("")
        elseif input.back.pressed and (night.menu == "settings" or night.menu == "scores") then back.go() end
    elseif input.pause.pressed and night.running then menu.open("pause") end
    local open = night.running and night.menu ~= ""
    time.scale = math.max(0, math.min(1, time.scale + (open and -5 or 3) * real_dt))
    time.paused = open and time.scale == 0
end

local function text(pen, x, y, words, size, tint, align, font)
    pen.text(vec(x, y) * unit, words, size * unit, tint or ink, align, font or "bold")
end
local function box(pen, x, y, width, height, ...) pen.box(vec(x, y) * unit, width * unit, height * unit, ...) end
local function image(pen, name, x, y, width, height, tint)
    pen.image("art/" .. name .. ".png", vec(x, y) * unit, width * unit, height * unit, 0, tint)
end

local function draw_card(pen, x, y, name, chosen)
    local level, gift = arms.level(name), arms.all[name]
    if chosen then
        y = y - 10 * math.abs(math.sin(3 * time.real))
        image(pen, "glow", x, y, 500, 540, "#ffb35a70")
    end
    box(pen, x, y, 260, 330, "#120f26f0", chosen and gold or "#4a4080", 2 * unit)
    image(pen, "icon_" .. name, x, y - 84, 110, 110)
    text(pen, x, y + 4, gift.name, 28, chosen and gold or ink)
    text(pen, x, y + 66, gift.text, 19, dim, "middle", "sans")
    text(pen, x, y + 130, level == 0 and "new!" or "level " .. level + 1, 19, level == 0 and teal or gold)
end

local function draw_menu(pen)
    local all, head = items(), menus[night.menu].head
    if head then
        box(pen, middle, 400, 4000, 800, "#070414b0")
        text(pen, middle, 120, head, 64, night.menu == "over" and color("#ff7a80") or gold)
    else
        image(pen, "glow", middle, 190, 1000, 420, "#ff9a4a55")
        text(pen, middle, 178 + 6 * math.sin(1.5 * time.real), "LANTERN", 132, gold)
        text(pen, middle, 280, "Keep the light until morning. A thousand come to put it out.", 24, ink, "middle", "sans")
        text(pen, middle, 770, "W A S D, arrows, stick or held mouse button: walk        Space, A or right mouse button: dash", 18, dim, "middle", "sans")
    end
    if night.menu == "over" or night.menu == "win" then
        text(pen, middle, 200, night.score .. " points     " .. night.kills .. " foes     " .. arenas[night.arena].name, 26)
    end
    for i, row in ipairs((night.menu == "over" or night.menu == "win" or night.menu == "scores") and store.scores or {}) do
        local y, tint = 230 + 44 * i, i == night.rank and gold or ink
        text(pen, middle - 60, y, i .. ".    " .. row.score, 26, tint, "right")
        text(pen, middle, y, (row.won and "morning" or arenas[row.arena].name) .. ",  " .. row.kills .. " foes", 22, dim, "left", "sans")
    end
    for i, item in ipairs(all) do
        local x, y, width, height = place_of(i, #all)
        local chosen = i == night.pick
        if night.menu == "choose" then draw_card(pen, x, y, item[1], chosen)
        else
            if chosen then image(pen, "glow", x, y, width * 1.3, height * 2.2, "#ffb35a60") end
            text(pen, x, y, item[1] .. (item.value and "   ‹ " .. item.value() .. " ›" or ""), chosen and 30 or 27, chosen and gold or ink)
        end
    end
end

local function bar(pen, x, y, width, height, part, tint)
    box(pen, x, y, width + 4, height + 4, "#0a0718d0")
    part = math.max(0, math.min(1, part))
    box(pen, x - width * (1 - part) / 2, y, width * part, height, tint)
end

local function draw_bars(pen)
    local hero, arena, place = world.hero, arenas[night.arena], 0
    bar(pen, middle, 8, 2 * middle, 10, hero.xp / hero:need(), teal)
    text(pen, 20, 38, "Level " .. hero.level, 22, teal, "left")
    bar(pen, 130, 68, 220, 18, hero.hp / hero.max_hp, hero.hp < 30 and "#ff4a5e" or "#e8743f")
    text(pen, 130, 68, math.ceil(hero.hp) .. " / " .. math.floor(hero.max_hp), 15)
    text(pen, 2 * middle - 20, 42, night.score, 32, gold, "right")
    text(pen, 2 * middle - 20, 74, night.kills .. " foes", 18, dim, "right")
    for _, name in ipairs(arms.order) do
        local level = arms.level(name)
        if level > 0 then
            local x = 40 + 56 * place
            box(pen, x, 752, 50, 50, "#120f26e0", "#4a4080", 2 * unit)
            image(pen, "icon_" .. name, x, 752, 44, 44)
            for i = 1, level do box(pen, x + 9 * i - 4.5 * (level + 1), 784, 6, 6, gold) end
            place = place + 1
        end
    end
    if world.swarm:has("boss") then
        text(pen, middle, 36, arena.boss, 22, color("#ff9d8a"))
        bar(pen, middle, 60, 520, 16, world.swarm.boss.hp / world.swarm.boss.max_hp, "#ff5a6e")
    elseif not night.boss then
        local left = math.ceil(math.max(0, arena.length - night.clock))
        text(pen, middle, 44, string.format("%d:%02d", left // 60, left % 60), 38)
        text(pen, middle, 76, arena.boss .. " comes", 16, dim)
    end
end

function menu.draw(pen)
    pen.screen(function()
        image(pen, "dark", middle, 400, 2.5 * middle, 1160, arenas[night.arena].ink)
        if night.running then draw_bars(pen) end
        effects.draw_banner(pen, vec(middle, 240) * unit, unit)
        if night.menu ~= "" then draw_menu(pen) end
        box(pen, middle, 400, 2 * middle, 800, color(0.02, 0.01, 0.05, night.curtain))
    end)
end

return menu
