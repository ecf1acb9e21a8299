-- Menus and scenes: a title, a level with a pause menu, and settings with keys to choose.

local open_settings = require("settings")

state("gravity", 16)
input.actions.jump = { "space", "gamepad.a" }
input.actions.left = { "left", "a", "gamepad.left_x-" }
input.actions.right = { "right", "d", "gamepad.left_x+" }
interface.theme.accent = color("#e4572e")
view.background = color("#141a2b")
view.height = 12

-- Hills behind everything, farther ones paler.
local function hills(pen, color_name, height, wave, speed)
    for i = -14, 14 do
        local y = height + math.sin(i * wave) * 0.9
        pen.circle(vec(i * 1.3 + speed, y - 4), 4, color(color_name))
    end
end

function draw_behind(pen)
    local drift = math.sin(time.now * 0.1)
    hills(pen, "#1d2743", -1.2, 0.9, drift)
    hills(pen, "#26345a", -2.6, 1.7, drift * 2)
    hills(pen, "#2f4172", -4.2, 2.6, drift * 3)
end

-- The title.

class("Title", Object) {}

function Title:enter()
    self:add(Column { modal = true, anchor = "center", spacing = 12, size = vec(420, 0),
        Label { text = "Hill Hopper", font = "bold", font_size = 54, text_align = "center" },
        Label { text = "menus and scenes in a hundred lines", text_align = "center",
            text_color = interface.theme.muted },
        Button { name = "play", text = "Play", look = "accent", pressed = function()
            go_to_scene("Level", { transition = "iris", args = { number = 1 } })
        end },
        Button { name = "settings", text = "Settings", pressed = open_settings },
        Button { name = "leave", text = "Quit", look = "quiet", pressed = function() quit() end } }, "menu")
end

-- A level: a world of its own, so that it ends with its bodies.

class("Level", World) { number = 1, coins = 0 }

function Level:enter(args)
    self.number = args.number
    self.gravity = vec(0, -game.gravity)
    self:add(Body { type = "static", Box { width = 40, height = 1, color = color("#3c5491") },
        position = vec(0, -5) }, "ground")
    local hero = self:add(Body { Circle { radius = 0.5, color = color("#ffd23f"), orientation_mark = true }, position = vec(-6, -3) }, "hero")
    for i = 1, 3 + self.number do
        local coin = self:add(Body { type = "static", position = vec(-6 + 2.4 * i, -3 + 2 * math.sin(i * 2)),
            Circle { radius = 0.35, sensor = true, color = color("#e4572e") } }, "coin_" .. i)
        coin:on("contact_begin", function() self:collect(coin) end)
    end
    self:add(Row { offset = vec(20, 16), spacing = 16,
        ProgressBar { name = "coins", max = 3 + self.number, text = "coins" },
        Button { name = "pause", text = "Pause", focusable = false, pressed = function() self:pause() end } }, "display")
end

function Level:collect(coin)
    coin:delete()
    self.coins = self.coins + 1
    self.display.coins.value = self.coins
    if self.coins == 3 + self.number then
        go_to_scene("Level", { transition = "wipe", args = { number = self.number % 4 + 1 } })
    end
end

function Level:step()
    local hero = self.hero
    local way = (input.right.held and 1 or 0) - (input.left.held and 1 or 0)
    hero.velocity = vec(7 * way, hero.velocity.y)
    if input.jump.pressed and math.abs(hero.velocity.y) < 0.5 then hero.velocity = hero.velocity + vec(0, 10) end
    self.gravity = vec(0, -game.gravity)
end

function Level:pause()
    time.paused = true
    local function go_on()
        time.paused = false
        self.paused:delete()
    end
    self:add(Panel { modal = true, cancelled = go_on, Column { size = vec(260, 0),
        Label { text = "Level " .. self.number, font = "bold", font_size = 28, text_align = "center" },
        Button { name = "go_on", text = "Go on", look = "accent", pressed = go_on },
        Button { name = "settings", text = "Settings", pressed = open_settings },
        Button { name = "title", text = "Title", pressed = function()
            time.paused = false
            go_to_scene("Title", { transition = "fade" })
        end } } }, "paused")
end

function key_pressed(key)
    if key == "escape" and game.scene:is_a(Level) then game.scene:pause() end
end

function start() go_to_scene("Title") end
