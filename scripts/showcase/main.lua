-- The showcase: a simulation viewer. Bodies to throw, to build and to take apart, and every value of them one key away
-- (the grave key, left of 1, opens the console).

require("thing")
local stage = require("stage")
local tools = require("tools")
local help = require("help")

game.showcase = Object {
    red_touch = true,      -- bodies turn red while they touch
    show_help = true,
    scene = "pyramid",
}

function start()
    view.background = color("#12161c")
    stage.show(showcase.scene)
    showcase:watch("scene", function(name) stage.show(name) end)
    showcase:watch("red_touch", function() world:each("Thing", function(thing) thing:repaint() end) end)
end

local commands = {
    space = function() time.paused = not time.paused end,
    period = function() time.paused = true time.step_once = true end,
    r = function() stage.show(showcase.scene) end,
    h = function() showcase.show_help = not showcase.show_help end,
    k = function() view.show.contacts = not view.show.contacts end,
    v = function() view.show.velocities = not view.show.velocities end,
    m = function() view.show.centers = not view.show.centers end,
    j = function() view.show.joints = not view.show.joints end,
    g = function() world.gravity = world.gravity.y == 0 and vec(0, -10) or vec(0, 0) end,
    t = function() showcase.red_touch = not showcase.red_touch end,
    c = tools.circle,
    p = tools.polygon,
    enter = tools.finish,
    escape = tools.cancel,
    x = tools.delete,
    delete = tools.delete,
}

for number, name in ipairs(stage.names) do
    commands[tostring(number)] = function() showcase.scene = name end
end

function key_pressed(key)
    local command = commands[key]
    if command then command() end
end

function mouse_pressed(button, position) tools.pressed(button, position) end
function mouse_moved(position, pixels) tools.moved(position, pixels) end
function mouse_released(button, position) tools.released(button, position) end
function wheel(notches, position) tools.zoom(notches, position) end

function draw(pen)
    tools.draw(pen)
    -- The console and its time bar would cover a part of it.
    local is_covered = game:has("console") and console.open
    if showcase.show_help and not is_covered then help.draw(pen, tools.hint()) end
end
