-- Title, pause, settings, results, and what is shown during play.

local fx = require("fx")
local menus = {}
local theme = interface.theme
theme.accent, theme.panel, theme.control = color("#d9692a"), color("#2b1d2ef0"), color("#4a3350")
theme.focus, theme.text, theme.muted, theme.shade = color("#ffcf4a"), color("#fff1d6"), color("#cbb3c4"), color("#1a102080")
theme.font, theme.font_size = "bold", 19

local function head(text, size) return Label { text = text, font_size = size or 34, text_align = "center", text_color = color("#ffcf4a"), fill = "width" } end
local function line(text, size) return Label { text = text, text_align = "center", fill = "width", font_size = size or 18 } end
local function button(name, text, action, look)
    return Button { name = name, text = text, look = look or "normal", fill = "width", pressed = function() sounds.blip:play() action() end }
end

local function open(name, children, cancelled, more)
    if game:has(name) then game[name]:delete() end
    local all = Column { size = vec(380, 0), spacing = 9 }
    for _, child in ipairs(children) do all:add(child) end
    local menu = game:add(Panel { modal = true, cancelled = cancelled, all }, name)
    for key, value in pairs(more or {}) do menu[key] = value end
    menu.opacity = 0
    menu.offset = vec(0, 24)
    menus.rise = menu
    return menu
end

-- Menus rise in real time, since the game may be paused.
function update(_, real_dt)
    local menu = menus.rise
    if not menu or not menu:alive() or menu.opacity == 1 then return end
    menu.opacity = math.min(1, menu.opacity + 6 * real_dt)
    menu.offset = vec(0, (menu.modal and 0 or 90) + 24 * (1 - menu.opacity) ^ 2)
end

local function clock(level) return string.format("%d:%02d", level.clock // 60, math.floor(level.clock) % 60) end
local function close(name) if game:has(name) then game[name]:delete() end end

function menus.play(number, new)
    if new then lives, hearts, coins, points = 5, 3, 0, 0 end
    hearts = 3
    for _, name in ipairs { "menu", "pause_menu", "settings" } do close(name) end
    go_to_scene("Level", { transition = "iris", seconds = 0.7, color = color("#2b1d2e"), args = { number = number } })
end

function menus.title()
    for _, name in ipairs { "menu", "pause_menu", "settings" } do close(name) end
    time.paused = false
    go_to_scene("Title", { transition = "fade" })
end

class("Title", World) {}
function Title:enter()
    view.follow, view.limits, view.height, view.center = nil, {}, 13, vec(12, 6.5)
    self:add(Tilemap { map = "levels/1.tmj", pixels_per_unit = 16 }, "map")
    for _, thing in ipairs(self.map.things:children()) do if not thing:is_a("Coin") then thing:delete() end end
    fx.backdrop(self, 1)
    self:add(Layer { space = "screen", anchor = "top", z = 50 }, "logo")
    for i, letter in ipairs { "R", "U", "S", "S", "E", "T" } do
        self.logo:add(Text { text = letter, font = "bold", size = 96, outline = color("#2b1d2e"), outline_width = 0.09,
            color = color(i % 2 == 0 and "#ffcf4a" or "#ee8434"), position = vec((i - 3.5) * 84, 100) }, "letter_" .. i)
    end
    self:add(Sprite { image = "art/fox.png", columns = 11, animation = "3-8", frames_per_second = 13, smooth = false, size = vec(1.5, 1.5),
        origin = vec(0.5, 0), z = 5, position = vec(0, 3.95) }, "cub")
    if #sounds.music:children("Voice") == 0 then sounds.music:play() end
    sounds.music.pitch = 1
    local reached = store.reached or 1
    local list = { line("Bring the cub home! Arrows run, space jumps.", 15), button("new", "New game", function() menus.play(1, true) end, "accent") }
    if reached > 1 then list[#list + 1] = button("go_on", "Go on at " .. fx.places[reached].name, function() menus.play(reached, true) end) end
    list[#list + 1] = button("scores", "Best scores", menus.scores)
    list[#list + 1] = button("settings", "Settings", menus.settings)
    list[#list + 1] = button("leave", "Quit", function() quit() end, "quiet")
    local menu = open("menu", list, nil, { modal = false, color = color("#2b1d2ec0") })
    menu.column.new:focus()
end
function Title:step(dt)
    local x = 10 + time.now * 1.2 % 100
    view.center = vec(view.center.x + (12 + 3 * math.sin(time.now * 0.15) - view.center.x) * 0.02, 6.5)
    self.cub.position = vec((time.now * 4) % 34 - 6, 3.95)
    self.cub.visible = self.cub.position.x < 11.6
    for i = 1, 6 do
        local letter = self.logo["letter_" .. i]
        letter.position = vec(letter.position.x, 100 + 9 * math.sin(2.2 * time.now - 0.7 * i))
    end
    self.air.position = view.center
end
function Title:leave() close("menu") end

function menus.scores()
    local list = { head("Best scores") }
    for i, entry in ipairs(store.scores or {}) do
        list[#list + 1] = line(i .. ".    " .. entry.points .. "    " .. (entry.won and "home" or fx.places[entry.level].name))
    end
    if #list == 1 then list[2] = line("Nobody has played yet.") end
    local function back() close("settings") end
    list[#list + 1] = button("back", "Back", back, "accent")
    open("settings", list, back)
end

function menus.settings()
    local function row(text, widget) return Row { fill = "width", Label { text = text, grow = 1 }, widget } end
    local function back()
        store.music, store.effects, store.jump = audio.buses.music.volume, audio.buses.effects.volume, input.actions.jump
        close("settings")
    end
    open("settings", { head("Settings"),
        row("Music", Slider { name = "music", bind = "audio.buses.music.volume", max = 1, step = 0.1 }),
        row("Sounds", Slider { name = "effects", bind = "audio.buses.effects.volume", max = 1, step = 0.1 }),
        row("Jump", Button { name = "jump", bind = "input.actions.jump", size = vec(210, 0) }),
        Toggle { text = "Full screen", bind = "view.window.fullscreen" },
        button("back", "Back", back, "accent") }, back)
end

function menus.pause()
    time.paused = true
    local function go_on() time.paused = false close("pause_menu") end
    open("pause_menu", { head("Pause"), button("go_on", "Go on", go_on, "accent"),
        button("again", "Begin this place again", function() menus.play(game.scene.number) end),
        button("settings", "Settings", menus.settings), button("title", "Title", menus.title) }, go_on)
end

-- Keeps the five best runs; returns the place of this one.
local function keep_score(won)
    local list, place = {}, nil
    for i, entry in ipairs(store.scores or {}) do list[i] = { points = entry.points, level = entry.level, won = entry.won } end
    for i = 1, 5 do
        if not place and (not list[i] or points > list[i].points) then
            place = i
            table.insert(list, i, { points = points, level = game.scene.number, won = won })
        end
    end
    list[6] = nil
    store.scores = list
    return place == 1 and "A new best score!" or place and "Place " .. place .. " of the best" or ""
end

function menus.game_over()
    local number, place = game.scene.number, keep_score(false)
    open("menu", { head("Game over", 44), line(points .. " points"), line(place),
        button("again", "Try " .. fx.places[number].name .. " again", function() menus.play(number, true) end, "accent"),
        button("title", "Title", menus.title) })
    sounds.lost:play { pitch = 0.7 }
end

function menus.won(level, bonus)
    local list = { head(level.number == 6 and "Home at last!" or fx.places[level.number].name) }
    if level.number == 6 then list[2] = line("The boar is beaten and the cub is safe.") end
    list[#list + 1] = line("time " .. clock(level) .. "   +" .. bonus.time)
    list[#list + 1] = line("hearts " .. hearts .. "   +" .. bonus.hearts)
    list[#list + 1] = line("coins " .. level.coins .. " of " .. level.all_coins .. (bonus.coins > 0 and "   +500" or ""))
    if bonus.hits > 0 then list[#list + 1] = line("not hurt once   +300") end
    list[#list + 1] = head(points .. " points", 28)
    if level.number == 6 then
        list[#list + 1] = line(keep_score(true))
        list[#list + 1] = button("title", "Title", menus.title, "accent")
    else
        list[#list + 1] = button("next", "On to " .. fx.places[level.number + 1].name, function() menus.play(level.number + 1) end, "accent")
    end
    open("menu", list)
end

function menus.banner(level, text)
    local layer = level:add(Layer { space = "screen", anchor = "center", z = 60,
        Text { text = text, font = "bold", size = 54, outline = color("#2b1d2e"), outline_width = 0.1, position = vec(0, -120), color = color("#fff1d6") } })
    layer:after(1.6, function(l) l:tween("opacity", 0, 0.6) end)
    layer:after(2.4, layer.delete)
end

local function icon(image, x, frame)
    return Sprite { image = "art/" .. image .. ".png", columns = frame or 1, smooth = false, position = vec(x, 34), scale = 2.4 }
end
local function shown(x, anchor, f)
    return Text { font = "bold", size = 28, outline = color("#2b1d2e"), outline_width = 0.1, position = vec(x, 34), anchor = vec(anchor, 0.5), text = formula(f) }
end

function menus.hud(level)
    local left = level:add(Layer { space = "screen", anchor = "top_left", z = 55 }, "hud")
    for i = 1, 3 do
        local heart = left:add(icon("heart", 4 + 38 * i))
        heart.tint = formula(function() return color(hearts >= i and "#ffffff" or "#2b1d2e90") end)
    end
    left:add(icon("coin", 190, 6))
    left:add(shown(214, 0, function() return tostring(coins) end))
    left:add(icon("fox", 320, 11))
    left:add(shown(350, 0, function() return "x " .. lives end))
    local right = level:add(Layer { space = "screen", anchor = "top_right", z = 55 }, "hud_right")
    right:add(shown(-24, 1, function()
        return clock(level) .. string.format("      %06d", points)
    end))
end

return menus
