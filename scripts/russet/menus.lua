-- Title, pause, settings, results, and what is shown during play.
local fx = require("fx")
local menus, theme, dark, gold = {}, interface.theme, color("#2b1d2e"), color("#ffcf4a")
theme.accent, theme.panel, theme.control = color("#d9692a"), color("#2b1d2ef0"), color("#4a3350")
theme.focus, theme.text, theme.muted, theme.shade = gold, color("#fff1d6"), color("#cbb3c4"), color("#1a102080")
theme.font, theme.font_size = "bold", 19
local function head(text, size) return Label { text = text, font_size = size or 34, text_align = "center", text_color = gold, fill = "width" } end
local function line(text) return Label { text = text, text_align = "center", fill = "width", font_size = 17 } end
local function row(text, widget) return Row { fill = "width", Label { text = text, grow = 1 }, widget } end
local function button(name, text, action)
    return Button { name = name, text = text, fill = "width", pressed = function() sounds.blip:play() action() end }
end
-- The button that has the keyboard is orange.
local function paint(button, look) if button and button:alive() and button:is_a(Button) then button.look = look end end
interface:watch("focus", function(now, before) paint(before, "normal") paint(now, "accent") end)
local function clock(level) return string.format("%d:%02d", level.clock // 60, math.floor(level.clock) % 60) end
-- Of the panels only the one that was opened last is shown.
local function show(all) for _, panel in ipairs(game:children("Panel")) do panel.visible = all end end
local function close(...) for _, name in ipairs { ... } do if game:has(name) then show(true) game[name]:delete() end end end
local function back() close("settings") end
local function open(name, children, cancelled, more)
    close(name) show(false)
    local all = Column { size = vec(380, 0), spacing = 9 }
    for _, child in ipairs(children) do all:add(child) end
    menus.rise = game:add(Panel { modal = true, cancelled = cancelled, all, opacity = 0 }, name)
    for key, value in pairs(more or {}) do menus.rise[key] = value end
end
-- Menus rise in real time, since the game may be paused.
function update(_, real_dt)
    local menu = menus.rise
    if not menu or not menu:alive() or menu.opacity == 1 then return end
    menu.opacity = math.min(1, menu.opacity + 6 * real_dt)
    menu.offset = vec(0, (menu.modal and 0 or 90) + 24 * (1 - menu.opacity) ^ 2)
end
function menus.play(number, new, had)
    had = new and { 0, 0, 5 } or had or { coins, points, lives }
    coins, points, lives, hearts = had[1], had[2], new and 5 or math.min(lives, had[3]), 3
    close("menu", "pause_menu", "settings")
    go_to_scene("Level", { transition = "iris", seconds = 0.7, color = dark, args = { number = number } })
end
function menus.title()
    close("menu", "pause_menu", "settings")
    time.paused = false
    go_to_scene("Title", { transition = "fade" })
end
-- What is on the screen at this edge, and as large a part of it on every screen.
function menus.overlay(level, anchor, z, name)
    return level:add(Layer { space = "screen", anchor = anchor, z = z,
        scale = formula(function() return math.min(view.screen.x / 1000, view.screen.y / 750) end) }, name)
end
-- The title stands over the beginning of the first level.
class("Title", World) {}
local function help() return (input.gamepad_1.connected and "The stick runs, A" or "Arrows run, " .. input.actions.jump[1]:gsub("[._]", " ")) .. " jumps." end
function Title:enter()
    view.follow, view.limits, view.height, view.center = nil, {}, 13, vec(12, 6.5)
    self:add(Tilemap { map = "levels/1.tmj", pixels_per_unit = 16 }, "map")
    for _, thing in ipairs(self.map.things:children()) do if not thing:is_a("Coin") then thing:delete() end end
    fx.backdrop(self, 1)
    menus.overlay(self, "top", 50, "logo")
    for i, letter in ipairs { "R", "U", "S", "S", "E", "T" } do
        self.logo:add(Text { text = letter, font = "bold", size = 96, outline = dark, outline_width = 0.09,
            color = color(i % 2 == 0 and "#ffcf4a" or "#ee8434"), position = vec((i - 3.5) * 84, 100) }, "letter_" .. i)
    end
    self:add(Sprite { image = "art/fox.png", columns = 11, animation = "3-8", frames_per_second = 13, smooth = false,
        size = vec(1.5, 1.5), origin = vec(0.5, 0), z = 5 }, "cub")
    fx.tune(sounds.music, 1)
    local reached = store.reached or 1
    local list = { line("Bring the cub home!"), line(formula(help)), button("new", "New game", function() menus.play(1, true) end) }
    if reached > 1 then list[4] = button("go_on", "Go on at " .. fx.places[reached].name, function() menus.play(reached, true) end) end
    for _, more in ipairs { button("scores", "Best scores", menus.scores), button("settings", "Settings", menus.settings),
        button("leave", "Quit", quit) } do list[#list + 1] = more end
    open("menu", list, nil, { modal = false, color = color("#2b1d2ec0") })
    game.menu.column.modal = true                -- not the panel, which would shade the title
end
function Title:step()
    view.center = vec(12 + 3 * math.sin(time.now * 0.15), 6.5)
    self.cub.position = vec((time.now * 4) % 17 - 6, 3.95)
    for i = 1, 6 do self.logo["letter_" .. i].position = vec((i - 3.5) * 84, 100 + 9 * math.sin(2.2 * time.now - 0.7 * i)) end
    self.air.position = view.center
end
function Title:leave() close("menu") end
function menus.scores()
    local list = { head("Best scores") }
    for i, entry in ipairs(store.scores or {}) do
        list[i + 1] = line(i .. ".    " .. entry.points .. "    " .. (entry.won and "home" or fx.places[entry.level].name))
    end
    list[2] = list[2] or line("Nobody has played yet.")
    list[#list + 1] = button("back", "Back", back)
    open("settings", list, back)
end
function menus.settings()
    open("settings", { head("Settings"), row("Music", Slider { name = "music", bind = "audio.buses.music.volume", max = 1, step = 0.1 }),
        row("Sounds", Slider { name = "effects", bind = "audio.buses.effects.volume", max = 1, step = 0.1 }),
        row("Jump", Button { name = "jump", bind = "input.actions.jump", size = vec(280, 0), font_size = 15, overflow = "wrap" }),
        Toggle { text = "Full screen", bind = "view.window.fullscreen" }, button("back", "Back", back) }, back)
end
function menus.pause()
    time.paused = true
    local function go_on() time.paused = false close("pause_menu") end
    open("pause_menu", { head("Pause"), button("go_on", "Go on", go_on),
        button("again", "Begin this place again", function() menus.play(game.scene.number, false, game.scene.had) end),
        button("settings", "Settings", menus.settings), button("title", "Title", menus.title) }, go_on)
end
-- Keeps the five best runs; says which place this one has.
local function keep_score(won)
    local list = { { points = points, level = game.scene.number, won = won } }
    for i, entry in ipairs(store.scores or {}) do list[i + 1] = { points = entry.points, level = entry.level, won = entry.won } end
    local mine, place = list[1], 6
    table.sort(list, function(a, b) return a.points > b.points end)
    for i, entry in ipairs(list) do if entry == mine then place = i end end
    list[6], store.scores = nil, list
    return place == 1 and "A new best score!" or place < 6 and "Place " .. place .. " of the best" or ""
end
function menus.game_over()
    local number, place = game.scene.number, points > 0 and keep_score(false) or ""
    open("menu", { head("Game over", 44), line(points .. " points"), line(place),
        button("again", "Try " .. fx.places[number].name .. " again", function() menus.play(number, true) end), button("title", "Title", menus.title) })
end
function menus.won(level, bonus)
    local last, prize = level.number == 6, "coins " .. level.coins .. " of " .. level.all_coins
    local list = { head(last and "Home at last!" or fx.places[level.number].name), line("time " .. clock(level) .. "   +" .. bonus.time),
        line("hearts " .. hearts .. "   +" .. bonus.hearts), line((last and "the Boar King is beaten" or prize) .. "   +" .. bonus.coins),
        line(bonus.hits > 0 and "not hurt once   +300" or "hurt " .. level.hits .. " times"), head(points .. " points", 28) }
    if last then list[7], list[8] = line(keep_score(true)), button("title", "Title", menus.title)
    else list[7] = button("next", "On to " .. fx.places[level.number + 1].name, function() menus.play(level.number + 1) end) end
    open("menu", list)
end
-- Hearts, coins, lives, time and points, and for a moment the name of the place.
function menus.hud(level)
    local function text(layer, x, y, size, right, words)
        layer:add(Text { font = "bold", size = size, outline = dark, outline_width = 0.1, position = vec(x, y), anchor = vec(right, 0.5), text = words })
    end
    local function icon(layer, image, x, frames)
        return layer:add(Sprite { image = "art/" .. image .. ".png", columns = frames, smooth = false, position = vec(x, 34), scale = 2.4 })
    end
    local left, right, banner = menus.overlay(level, "top_left", 55), menus.overlay(level, "top_right", 55), menus.overlay(level, "center", 60)
    for i = 1, 3 do
        icon(left, "heart", 4 + 38 * i, 1).tint = formula(function() return color(hearts >= i and "#ffffff" or "#2b1d2e90") end)
    end
    icon(left, "coin", 190, 6) icon(left, "fox", 320, 11)
    text(left, 214, 34, 28, 0, formula(function() return tostring(coins) end))
    text(left, 356, 34, 28, 0, formula(function() return "x " .. lives end))
    text(right, -24, 34, 28, 1, formula(function() return clock(level) .. string.format("      %06d", points) end))
    text(banner, 0, -120, 54, 0.5, level.number .. "  " .. fx.places[level.number].name)
    banner:after(1.6, function(layer) layer:tween("opacity", 0, 0.6):on("finished", function() layer:delete() end) end)
end
return menus
