-- A car over hills: arrow keys drive, and lean it in the air. Every number of it is live: try `world.car.torque = 60`,
-- or `world.car.back_axle.hertz = 1.5`, in the console (the grave key).

local terrain = require("terrain")
local car = require("car")

game.drive = Object {
    autopilot = false, show_help = true,
    on_roof = 0.0, stuck = 0.0,  -- for so many seconds
    farthest = 0.0,              -- m
}

local function place_coins()
    world.coins = Object {}
    for x = 14, terrain.length - 10, 9 do
        local lift = 1.1 + 0.5 * math.sin(x)
        local coin = world.coins:add(Body {
            type = "static", position = vec(x, terrain.height(x) + lift),
            Circle { radius = 0.3, sensor = true, visible = false },
        })
        coin:on("sensor_begin", function(event)
            if event.other ~= world.car.chassis then return end
            world.car.coins = world.car.coins + 1
            coin:delete()
        end)
    end
end

function start()
    view.background = color("#20283d")
    view.height = 13
    terrain.build(world)
    car.make(world, vec(0, terrain.height(0) + 1.1))
    place_coins()
    view.center = world.car.chassis.position + vec(2, 1.5)
end

local function put_upright(x)
    local coins = world.car.coins
    world.car = nil
    car.make(world, vec(x, terrain.height(x) + 1.6))
    world.car.coins = coins
end

-- Where it is, or at the beginning if it fell off the end of the world.
local function restart()
    local x = world.car.chassis.position.x
    if x >= -25 and x <= terrain.length then
        put_upright(x)
    else
        drive.farthest = 0.0
        put_upright(0)
    end
end

function key_pressed(key)
    if key == "r" then restart() end
    if key == "h" then drive.show_help = not drive.show_help end
    if key == "j" then view.show.joints = not view.show.joints end
    if key == "p" then time.paused = not time.paused end
end

-- Leaves off where the nose is high, backs off for a run-up where it gets no farther, and puts the car upright, as a
-- person would.
local patience, run_up = 3, 2  -- seconds

local function autopilot(dt)
    local chassis = world.car.chassis
    drive.on_roof = math.cos(chassis.angle) < 0 and drive.on_roof + dt or 0
    if drive.on_roof > 1.5 then
        restart()
        return 0
    end
    if chassis.position.x > drive.farthest + 0.5 then
        drive.farthest, drive.stuck = chassis.position.x, 0
    end
    drive.stuck = drive.stuck < patience + run_up and drive.stuck + dt or 0
    local speed = chassis.velocity.x
    if drive.stuck > patience then return speed > -4 and -1 or 1 end
    return (speed < 3 and math.sin(chassis.angle) < 0.8 or speed < 10 and math.sin(chassis.angle) < 0.5) and 1 or 0
end

function step(dt)
    local keys = input.keys
    local wanted = (keys.right and 1 or 0) - (keys.left and 1 or 0)
    if drive.autopilot then wanted = autopilot(dt) end
    world.car.throttle = wanted
    car.drive(world.car)
    if world.car.chassis.position.y < -2 * terrain.depth then restart() end
    -- The view runs ahead of the car, the farther the faster it is.
    local chassis = world.car.chassis
    local goal = chassis.position + vec(2 + chassis.velocity.x * 0.22, 0.8)
    view.center = view.center + (goal - view.center) * math.min(1, 4 * dt)
    local height = 12 + math.min(6, math.abs(chassis.velocity.x) * 0.25)
    view.height = view.height + (height - view.height) * math.min(1, 1.5 * dt)
end

-- --- What is seen ------------------------------------------------------------------------------------------------

local grass, blade = color("#7bc86c"), color("#4f9a4b")
local ink, dim, key_ink = color("#eceef0"), color("#aab2c5"), color("#ffcb47")
local panel, edge = color(0.06, 0.07, 0.11, 0.72), color(1, 1, 1, 0.12)

local function draw_grass(pen)
    local half = view.height * view.screen.x / view.screen.y / 2 + 3
    local x = math.floor((view.center.x - half + 30) / terrain.column) * terrain.column - 30
    while x < view.center.x + half do
        if terrain.solid(x) and x < terrain.length then
            local from, to = vec(x, terrain.height(x)), vec(x + terrain.column, terrain.height(x + terrain.column))
            pen.line(from - vec(0, 0.07), to - vec(0, 0.07), blade, 9)
            pen.line(from, to, grass, 5)
        end
        x = x + terrain.column
    end
end

local coin_face, coin_rim, coin_shine = color("#ffcb47"), color("#b57d12"), color("#fff3c4")

local function draw_coins(pen)
    for _, coin in ipairs(world.coins:children()) do
        local place = coin.position + vec(0, 0.08 * math.sin(time.now * 3 + coin.position.x))
        pen.circle(place, 0.3, coin_face, coin_rim, 2)
        pen.circle(place + vec(-0.08, 0.08), 0.07, coin_shine)
    end
end

local function draw_meter(screen, x, y, share, paint)
    screen.box(vec(x + 60, y), 120, 8, color(1, 1, 1, 0.15))
    if share > 0 then screen.box(vec(x + 60 * share, y), 120 * share, 8, paint) end
end

local help = "arrow keys: drive, and lean in the air    R: upright    J: joints    P: pause    H: no help"

-- Beside the meter, or at the lower edge of a narrow window.
local function draw_help(screen)
    local room = view.screen.x - 272
    local is_narrow = room < 280
    local width = is_narrow and view.screen.x - 48 or room
    local _, height = screen.text_size(help, 14, nil, width)
    local middle = is_narrow and view.screen.y - height / 2 - 18 or 20 + height / 2
    if is_narrow then screen.box(vec(view.screen.x / 2, middle), view.screen.x - 32, height + 16, panel, edge, 1) end
    screen.text(vec(is_narrow and 24 or view.screen.x - 24, middle), help, 14, dim, is_narrow and "left" or "right", nil, width)
end

function draw(pen)
    draw_grass(pen)
    draw_coins(pen)
    car.draw(pen, world.car)
    pen.screen(function(screen)
        local chassis = world.car.chassis
        local speed = chassis.velocity:length()
        screen.box(vec(120, 62), 208, 92, panel, edge, 1)
        screen.text(vec(32, 36), string.format("%.0f km/h", speed * 3.6), 24, ink, "left")
        draw_meter(screen, 32, 60, math.min(1, speed / world.car.top_speed), "#7bc86c")
        screen.text(vec(32, 84), string.format("%.0f m", math.max(0, chassis.position.x)), 14, dim, "left")
        screen.text(vec(208, 84), string.format("%d coins", world.car.coins), 14, key_ink, "right")
        if drive.show_help then draw_help(screen) end
    end)
end
