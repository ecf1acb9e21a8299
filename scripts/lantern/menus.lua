-- Menus and what lies over the picture: title, settings, high scores, pause, choice of a gift, the end, and the bars while one plays.

local common = require "common"
local effects = require "effects"
local arenas = require "arenas"

local gold, ink, dim, teal = color("#ffd98a"), color("#f3efff"), color("#a79fc9"), color("#5ef2c4")
local menus, menu = {}, {}
local unit, middle, screen = 1, vec(0, 0), vec(1280, 800)
local opened, shown = 0, ""

function menu.open(name)
    night.menu, night.pick = name, 1
    sounds.blip:play()
end

local function volume(bus) return {
    bus == "music" and "Music" or "Sounds",
    value = function() return string.rep("●", math.floor(settings[bus] * 10 + 0.5)) .. string.rep("·", 10 - math.floor(settings[bus] * 10 + 0.5)) end,
    turn = function(by) settings[bus] = math.max(0, math.min(1, math.floor(settings[bus] * 10 + by + 0.5) / 10)) end,
} end

local function switch(label, read, write) return {
    label, value = function() return read() and "on" or "off" end, turn = function() write(not read()) end,
} end

local back = { "Back", go = function() menu.open(night.running and "pause" or "title") end }

menus.title = {
    { "Light the lantern", go = function() menu.begin() end },
    { "Arena", value = function() return night.first .. "  " .. arenas[night.first].name end,
      turn = function(by) night.first = (night.first - 1 + by) % (store.unlocked or 1) + 1 end },
    { "Settings", go = function() menu.open("settings") end },
    { "High scores", go = function() menu.open("scores") end },
    { "Quit", go = function() quit() end },
}
menus.settings = {
    volume("effects"), volume("music"),
    switch("Shaking", function() return settings.shake end, function(on) settings.shake = on end),
    switch("Full screen", function() return view.window.fullscreen end, function(on) view.window.fullscreen = on end),
    back,
}
menus.scores = { back }
menus.pause = {
    { "Go on", go = function() menu.open("") end },
    { "Settings", go = function() menu.open("settings") end },
    { "Give up", go = function() night.menu = "" common.ended("over") end },
}
menus.over = { { "Once more", go = function() menu.begin() end }, { "Title", go = function() menu.open("title") end } }
menus.win = menus.over

local function items()
    if night.menu ~= "choose" then return menus[night.menu] or {} end
    local cards = {}
    for i, name in ipairs(night.choices) do
        cards[i] = { name, go = function()
            night.menu = ""
            arms.take(name)
            sounds.heal:play()
        end }
    end
    return cards
end

-- Middle and size of an item, px.
local function place_of(i, count)
    if night.menu == "choose" then
        return vec(middle.x + (i - (count + 1) / 2) * 290 * unit, middle.y + 40 * unit), vec(260, 330) * unit
    end
    local top = night.menu == "scores" and 720 or night.menu == "title" and 500 or night.menu == "pause" and 390 or night.menu == "settings" and 330 or 560
    return vec(middle.x, (top + 50 * (i - 1)) * unit), vec(460, 46) * unit
end

local function measure()
    screen = view.screen
    unit, middle = screen.y / 800, screen * 0.5
end

local function item_at(point)
    measure()
    local all = items()
    for i in ipairs(all) do
        local at, size = place_of(i, #all)
        if math.abs(point.x - at.x) < size.x / 2 and math.abs(point.y - at.y) < size.y / 2 then return i end
    end
end

local function activate(item, by)
    if item.turn then item.turn(by) sounds.blip:play() elseif item.go and by > 0 then item.go() end
end

function mouse_moved(_, point) night.pick = item_at(point) or night.pick end

function mouse_pressed(button, _, point)
    local i = item_at(point)
    if button ~= "left" or not i or time.real - opened < 0.4 then return end
    night.pick = i
    activate(items()[i], 1)
end

-- Once a frame. A menu over a running game slows time down until it stands still, and the music with it.
function menu.update(real_dt)
    if night.menu ~= shown then opened, shown = time.real, night.menu end
    local all = items()
    if night.menu == "" then
        if input.pause.pressed and night.running then menu.open("pause") end
    elseif #all > 0 and time.real - opened > 0.15 then
        local before, cards = night.pick, night.menu == "choose"
        local by = (input.menu_right.pressed and 1 or 0) - (input.menu_left.pressed and 1 or 0)
        local down = (input.menu_down.pressed and 1 or 0) - (input.menu_up.pressed and 1 or 0)
        night.pick = (night.pick - 1 + (cards and by or down)) % #all + 1
        if night.pick ~= before then sounds.blip:play { pitch = 0.8 } end
        if by ~= 0 and not cards and all[night.pick].turn then activate(all[night.pick], by) end
        if input.accept.pressed and (not cards or time.real - opened > 0.4) then activate(all[night.pick], 1)
        elseif input.back.pressed and night.menu == "pause" then menu.open("")
        elseif input.back.pressed and (night.menu == "settings" or night.menu == "scores") then back.go() end
    end
    local open = night.running and night.menu ~= ""
    time.scale = math.max(0, math.min(1, time.scale + (open and -5 or 3) * real_dt))
    time.paused = open and time.scale == 0
end

local function text(pen, x, y, words, size, tint, align, font)
    pen.text(vec(x, y), words, size * unit, tint or ink, align, font)
end

local function panel(pen, at, size, edge)
    pen.box(at, size.x, size.y, "#120f26e6", edge or "#4a4080", 2 * unit)
end

local function draw_card(pen, i, name, count)
    local at, size = place_of(i, count)
    local chosen, level = i == night.pick, arms.level(name)
    if chosen then
        at = at - vec(0, 10 * unit * math.abs(math.sin(3 * time.real)))
        pen.image("art/glow.png", at, size.x * 1.9, size.y * 1.6, 0, "#ffb35a70")
    end
    panel(pen, at, size, chosen and gold or nil)
    pen.image("art/icon_" .. name .. ".png", at - vec(0, 84 * unit), 96 * unit, 96 * unit)
    text(pen, at.x, at.y + 4 * unit, arms.all[name].name, 28, chosen and gold or ink, "middle", "bold")
    text(pen, at.x, at.y + 66 * unit, arms.all[name].text, 19, dim)
    text(pen, at.x, at.y + 130 * unit, level == 0 and "new!" or "level " .. level + 1, 19, level == 0 and teal or gold, "middle", "bold")
end

local function draw_scores(pen, top)
    for i, row in ipairs(store.scores or {}) do
        local tint, y = i == night.rank and gold or ink, (top + 38 * i) * unit
        text(pen, middle.x - 220 * unit, y, i .. ".", 24, dim, "right")
        text(pen, middle.x - 60 * unit, y, row.score, 26, tint, "right", "bold")
        text(pen, middle.x - 20 * unit, y, row.won and "morning came" or arenas[row.arena].name, 22, dim, "left")
        text(pen, middle.x + 320 * unit, y, row.kills .. " foes", 22, dim, "right")
    end
end

local headings = { settings = "Settings", scores = "High scores", pause = "Pause", choose = "The light grows", over = "The light went out",
                   win = "Morning came" }

local function draw_menu(pen)
    local all = items()
    if night.menu == "title" then
        pen.image("art/glow.png", vec(middle.x, 190 * unit), 1000 * unit, 420 * unit, 0, "#ff9a4a55")
        text(pen, middle.x, (180 + 6 * math.sin(1.5 * time.real)) * unit, "LANTERN", 132, gold, "middle", "bold")
        text(pen, middle.x, 280 * unit, "Keep the light until morning. A thousand come to put it out.", 24)
        text(pen, middle.x, 770 * unit, "W A S D, arrows, stick or held mouse button: walk      Space, A or right mouse button: dash", 18, dim)
    else
        pen.box(middle, screen.x, screen.y, "#070414a8")
        text(pen, middle.x, 130 * unit, headings[night.menu], 64, night.menu == "over" and color("#ff7a80") or gold, "middle", "bold")
    end
    if night.menu == "scores" then draw_scores(pen, 190)
    elseif night.menu == "over" or night.menu == "win" then
        text(pen, middle.x, 210 * unit, string.format("%d points    %d foes    %s", night.score, night.kills, arenas[night.arena].name), 26)
        draw_scores(pen, 220)
    elseif night.menu == "choose" then text(pen, middle.x, 200 * unit, "Level " .. world.hero.level .. ": choose a gift", 26) end
    for i, item in ipairs(all) do
        if night.menu == "choose" then draw_card(pen, i, item[1], #all)
        else
            local at, size = place_of(i, #all)
            local chosen = i == night.pick
            if chosen then pen.image("art/glow.png", at, size.x * 1.3, size.y * 2.2, 0, "#ffb35a60") end
            local words = item[1]
            if item.value then words = words .. "   ‹ " .. item.value() .. " ›" end
            text(pen, at.x, at.y, words, chosen and 30 or 27, chosen and gold or ink, "middle", "bold")
        end
    end
end

local function bar(pen, at, width, height, part, tint)
    pen.box(at, width + 4 * unit, height + 4 * unit, "#0a0718d0")
    if part > 0 then pen.box(at - vec(width * (1 - part) / 2, 0), width * math.min(1, part), height, tint) end
end

local function draw_bars(pen)
    local hero, arena = world.hero, arenas[night.arena]
    bar(pen, vec(middle.x, 8 * unit), screen.x - 4 * unit, 10 * unit, hero.xp / hero:need(), teal)
    text(pen, 20 * unit, 40 * unit, "Level " .. hero.level, 22, teal, "left", "bold")
    bar(pen, vec(130 * unit, 70 * unit), 220 * unit, 16 * unit, hero.hp / hero.max_hp, hero.hp < 30 and "#ff4a5e" or "#ff8a5a")
    text(pen, 130 * unit, 70 * unit, string.format("%d / %d", math.ceil(hero.hp), hero.max_hp), 15, ink, "middle", "bold")
    text(pen, screen.x - 20 * unit, 44 * unit, night.score, 32, gold, "right", "bold")
    text(pen, screen.x - 20 * unit, 76 * unit, night.kills .. " foes", 18, dim, "right")
    local place = 0
    for _, name in ipairs(arms.order) do
        local level = arms.level(name)
        if level > 0 then
            local at = vec((38 + 54 * place) * unit, screen.y - 42 * unit)
            panel(pen, at, vec(48, 48) * unit)
            pen.image("art/icon_" .. name .. ".png", at, 40 * unit, 40 * unit)
            for i = 1, level do pen.circle(at + vec((9 * i - 9 * (level + 1) / 2) * unit, 31 * unit), 3 * unit, gold) end
            place = place + 1
        end
    end
    local boss = world.swarm:has("boss") and world.swarm.boss
    if boss then
        text(pen, middle.x, 36 * unit, arena.boss, 22, color("#ff9d8a"), "middle", "bold")
        bar(pen, vec(middle.x, 60 * unit), 520 * unit, 16 * unit, boss.hp / boss.max_hp, "#ff5a6e")
    elseif not night.boss then
        local left = math.max(0, math.ceil(arena.length - night.clock))
        text(pen, middle.x, 46 * unit, string.format("%d:%02d", left // 60, left % 60), 38, ink, "middle", "bold")
        text(pen, middle.x, 76 * unit, arena.boss .. " comes", 16, dim)
    end
end

function menu.draw(pen)
    measure()
    local arena = arenas[night.arena]
    pen.screen(function()
        pen.image("art/dark.png", middle, screen.x * 1.25, screen.y * 1.45, 0, arena.ink)
        if night.running then
            draw_bars(pen)
            effects.draw_banner(pen, vec(middle.x, 250 * unit), unit)
        end
        if night.menu ~= "" then draw_menu(pen) end
        if night.curtain > 0 then
            pen.fade(night.curtain)
            pen.box(middle, screen.x, screen.y, "#05030c")
        end
    end)
end

return menu
