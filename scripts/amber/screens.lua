-- The menus, which are widgets, and what is written during play. While a menu is open, the game gets neither keys nor clicks.
local things, sound = require("things"), require("sound")
local screens = { name = "title", back = "title", age = 0, pauses = false, game = { count = 12, level = 0, sparks = 0, tries = 0, still = 0 } }
local ink, gold, cream, dim, faded = things.ink, things.gold, things.cream, color("#a99bc9"), things.faded
local full, missing = color("white"), color("#564880")      -- the tints of sparks
local menus, left = {}, {}                                  -- by name: functions that make them, and what led out of them

local looks = { accent = gold, on_accent = ink, text = cream, focus = cream, control = color("#3a2f5c"), panel = faded(ink, 0.97),
    border = faded(gold, 0.6), shade = faded(ink, 0.6), font = "bold", font_size = 28, radius = 6, spacing = 12, padding = 40 }
for name, value in pairs(looks) do interface.theme[name] = value end

function screens.reached() return math.min(screens.game.count, store.unlocked or 1) end     -- the last level that can be played
function screens.in_level() return not menus[screens.name] end                              -- whether no menu is open

function screens.open(name, back)
    if game:has("menu") then game.menu:delete() end
    screens.name, screens.back, screens.age = name, back or screens.back, 0
    local pauses = name == "pause" or screens.back == "pause" and (name == "settings" or name == "levels")
    if pauses ~= screens.pauses then screens.pauses, time.paused = pauses, pauses end     -- a pause from elsewhere stays
    if screens.in_level() then return end
    local menu, first = menus[name](screens.game)
    game:add(menu, "menu")
    if name == screens.back then first = menu:find("Item", function(each) return each.text == left[name] end)[1] or first end
    if first then first:focus() end
end

-- What was restored may be of another screen: a moment that was shared, or the title before this level.
function screens.restored()
    if screens.in_level() == game:has("menu") then screens.open(game:has("menu") and "title" or "play") end
end

local function opens(name) return function() screens.open(name, screens.name) end end
local function back() screens.open(screens.back) end
local function plays(level) return function() screens.game.play(level) end end

Item = class("Item", Button) { look = "quiet", min_size = vec(340, 0) }
local function item(text, action)
    return Item { text = text, pressed = function(event)
        sound.play("press")
        left[screens.name] = text
        action(event.instance)
    end }
end

local function paint(item, look) if item and item:alive() and item:is_a(Item) then item.look = look end end

-- The item that has the keyboard is golden.
interface:watch("focus", function(now, before)
    paint(before, "quiet")
    paint(now, "accent")
    if now and screens.age > 0.1 then sound.play("tick") end
end)

local function words(text, size, tint, font)
    return Label { text = text, font_size = size, text_color = tint, font = font or "sans", text_align = "center" }
end
local function headline(text, size) return words(text, size, gold, "bold") end

local function spark_row(size, count)
    local row = Row { name = "sparks", justify = "center", spacing = size / 4 }
    for k = 1, 3 do row:add(Image { image = "art/spark.png", size = vec(size, size), tint = k <= count and full or missing }) end
    return row
end

local function total()
    local points, sparks = 0, 0
    for _, best in pairs(store.levels or {}) do points, sparks = points + best.score, sparks + best.sparks end
    return string.format("%d points, %d of %d sparks", points, sparks, 3 * screens.game.count)
end

function menus.title(game)
    local reached, scores = screens.reached(), store.levels
    return Column { modal = true, anchor = "center", align = "center", spacing = 8,
        headline("AMBER", 160), words("Time touches everything but you.\n ", 30, cream),
        item(reached > 1 and "Continue" or "Play", plays(reached)), item("Levels", opens("levels")),
        item("Settings", opens("settings")), item("Quit", function() quit() end),
        words(scores and total() or "Mouse, keyboard or gamepad", 20, scores and gold or dim) }
end

function menus.pause(game)
    return Panel { modal = true, cancelled = opens("play"), Column { headline("Paused", 46),
        item("Resume", opens("play")), item("Restart", plays(game.level)), item("Levels", opens("levels")),
        item("Settings", opens("settings")), item("Title", game.title) } }
end

-- What is set with a bound slider is kept, and no rewind changes it.
local function volume(text, bus)
    return Row { Label { text = text, grow = 1 },
        Slider { size = vec(190, 0), step = 0.1, bind = "audio.buses." .. bus .. ".volume", changed = function() sound.play("tick") end } }
end

local function erase(button)
    if button.text ~= "Really erase?" then button.text = "Really erase?" return end
    store:clear()
    screens.open("settings")
end

function menus.settings()
    return Panel { modal = true, cancelled = back, Column { headline("Settings", 46),
        volume("Music", "music"), volume("Effects", "effects"), Row { Label { text = "Turn back", grow = 1 },
            Button { size = vec(340, 0), font_size = 17, overflow = "wrap", bind = "input.actions.rewind" } }, Toggle { text = "Full screen", bind = "view.window.fullscreen" },
        item("Erase scores", erase), item("Back", back) } }
end

local function card(level)
    local best, open = (store.levels or {})[level], level <= screens.reached()
    return Panel { size = vec(150, 112), padding = 0,
        Button { text = level .. "\n ", font_size = 30, overflow = "wrap", fill = "both", disabled = not open, pressed = plays(level) },
        Column { anchor = "bottom", offset = vec(0, -10), spacing = 4, opacity = open and 1 or 0.3,
            spark_row(20, best and best.sparks or 0), words(best and tostring(best.score) or " ", 17, dim) } }
end

function menus.levels(game)
    local cards = {}
    for i = 1, game.count do cards[i] = card(i) end
    return Panel { modal = true, cancelled = back, Column { headline("Levels", 46),
        Column { columns = 4, table.unpack(cards) }, item("Back", back) } }, cards[screens.reached()].button
end

function menus.won(game)
    local result, last = screens.result, game.level == game.count
    local best = result.record and "New best!" or "Best: " .. result.best
    return Panel { modal = true, cancelled = game.title, Column {
        words(world.level.title, 38, cream, "bold"), spark_row(46, 0),
        Label { name = "score", font_size = 56, text_color = gold, text_align = "center" },
        words(string.format("%.1f s     %s", result.seconds, best), 24, dim),
        item(last and "The end" or "Next level", last and opens("finale") or plays(game.level + 1)),
        item("Again", plays(game.level)), item("Levels", opens("levels")) } }
end

function menus.finale(game)
    return Panel { modal = true, cancelled = game.title, Column { headline("All are home", 96),
        words("The last drop has come home.\nThe wheels turn on without you.", 32, cream), headline(total(), 40), item("Title", game.title) } }
end

-- A menu comes in; when a level is won, its sparks and points are counted up.
function screens.update(dt)
    screens.age = screens.age + dt
    if screens.in_level() then return end
    local left = 1 - math.min(1, 4 * screens.age)
    game.menu.opacity, game.menu.offset = 1 - left, vec(0, 50 * left ^ 2)
    if screens.name ~= "won" then return end
    local counted, column = math.max(0, screens.age - 0.4), game.menu.column
    column.score.text = tostring(math.min(screens.result.score, math.floor(2600 * counted)))
    for k = 1, math.min(screens.result.sparks, math.floor(counted * 3)) do column.sparks:children()[k].tint = full end
end

-- From the fourth try on, and when the drop lies still, or hangs, for long.
function screens.tip() return (screens.game.tries > 3 or screens.game.still > 12) and world.level.tip or "" end

function screens.draw_play(pen, past)
    pen.text(vec(0, 6.6), screens.tip(), 0.46, gold)
    pen.text(vec(-11.6, 6.9), screens.game.level .. "  " .. world.level.title, 0.62, cream, "left", "bold")
    for k = 1, 3 do pen.image("art/spark.png", vec(9.6 + k * 0.65, 6.85), 0.4, nil, nil, k <= screens.game.sparks and full or missing) end
    pen.text(vec(11.6, -7.05), input.gamepad_1.connected and "Y again    Start pause" or "R again    P pause", 0.42, color("#cfc4ec"), "right")
    local long = math.min(10, past / 2)
    pen.box(vec(0, -7.15), 10.2, 0.22, faded(ink, 0.6))
    pen.box(vec(-5 + long / 2, -7.15), long, 0.12, things.pale)
    pen.circle(vec(-5 + long, -7.15), 0.15, things.pale)
end

return screens
