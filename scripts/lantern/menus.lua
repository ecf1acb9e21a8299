-- What the menus of display.json do; formulas in that file say what is written in them. `night.menu` is the name of the one that is open.
local arenas = require "arenas"
local menu, theme = {}, interface.theme
theme.font, theme.font_size, theme.text, theme.spacing = "bold", 25, color("#f3efff"), 6
theme.accent, theme.focus, theme.control = color("#e8743f"), color("#ffd98aa0"), color("#4a4080")

Menu = class("Menu", Column) { modal = true, anchor = "center", align = "center", back = "" }
Item = class("Item", Button) { look = "quiet", min_size = vec(420, 0), go = "" }
Shake = class("Shake", Toggle) { changed = function() interface:prefer("game.settings.shake", settings.shake) end }

local actions = {
    begin = function() night:begin() end,
    play = function() night.menu = "" end,
    give_up = function() night:finish(false) end,
    back = function() night.menu = night.running and "pause" or "title" end,
    arena = function() night.first = night.first % (store.unlocked or 1) + 1 end,
    quit = function() quit() end,
}

local function go(to)                            -- does an action, or takes a gift, or opens the menu of that name
    sounds.blip:play()
    if actions[to] then return actions[to]() end
    if world.arms:has(to) then arms.take(to) end
    night.menu = display:has(to) and to or ""
end
function Item:pressed() go(self.go) end
function Menu:cancelled() if self.back ~= "" then go(self.back) end end

-- When a menu opens it shows what is in the store, which formulas cannot read.
function menu.opened()
    local lines = {}
    for i, row in ipairs(store.scores or {}) do
        local how = (row.won and "morning" or arenas[row.arena].title) .. ",  " .. row.kills .. " banished"
        lines[i] = i .. ".   " .. row.score .. "      " .. how
    end
    display.title.arena.visible = (store.unlocked or 1) > 1
    display.title.best.text = store.scores and "Best  " .. store.scores[1].score or ""
    display.over.scores.items, display.over.scores.selected = lines, night.rank <= #lines and night.rank or 0
    night.open = 0
end

-- Once a frame. A menu over a running game slows time down until it stands still, and the music with it. Between menus,
-- time is left as it is: the console may have stopped it or slowed it down.
function menu.update(_, real_dt)
    local open = night.running and night.menu ~= ""
    night.open = night.open + real_dt
    if input.pause.pressed and night.running and not open then go("pause") end
    if open or night.slowed then
        time.scale = math.max(0, math.min(1, time.scale + (open and -5 or 3) * real_dt))
        time.paused = open and time.scale == 0
        night.slowed = open or time.scale < 1
    end
end

-- What lies over the world and under the widgets: the dark, and a glow behind the chosen item.
function menu.draw(pen)
    local size, chosen = view.screen, interface.focus
    local unit = math.min(size.x, size.y) / 720                                 -- a pixel of the widgets
    pen.screen(function()
        pen.image("art/dark.png", size / 2, 1.25 * size.x, 1.45 * size.y, 0, arenas[night.arena].ink)
        if night.running then
            pen.push() pen.linear(vec(0, 0), vec(0, 122 * unit), { "#05030ce0", "#05030c00" })     -- a shade behind the texts
            pen.box(vec(size.x / 2, 61 * unit), size.x, 122 * unit, "white") pen.pop() end
        if night.menu == "title" then
            pen.box(vec(size.x / 2, size.y - 43 * unit), size.x, 86 * unit, "#05030cc0")
            pen.image("art/glow.png", vec(size.x / 2, 0.22 * size.y), 0.8 * size.x, 0.5 * size.y, 0, "#ff9a4a55")
        elseif night.menu ~= "" then pen.box(size / 2, size.x, size.y, "#070414b0") end
        if chosen then
            local around = chosen.screen_size
            pen.image("art/glow.png", chosen.screen_position + around / 2, 1.6 * around.x, 2.2 * around.y, 0, "#ffb35a70")
        end
        if night.curtain > 0 then pen.box(size / 2, size.x, size.y, color(0.02, 0.01, 0.05, night.curtain)) end
    end)
end

return menu
