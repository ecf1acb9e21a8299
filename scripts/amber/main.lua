-- Cut ropes and turn back time to bring a drop of amber home. Time turns back for everything but the drop.

local rewind, things, fx = require("rewind"), require("things"), require("fx")
local sound, screens = require("sound"), require("screens")

local run = { count = 12, level = 0 }        -- the game as the screens see it
screens.game = run
local amber_cuts = {}                        -- names of the cut ropes of amber, which no rewind mends
local clock, ended, fade, tide = 0, 0, 1, 0  -- s of play; s since won or lost; how black the screen is; how much veil
local pointer = nil

input.actions.cut = { "mouse.left", "enter", "gamepad.a" }
input.actions.rewind = { "space", "mouse.right", "left_shift", "gamepad.x", "gamepad.right_trigger" }
input.actions.restart = { "r", "gamepad.y" }
input.actions.pause = { "escape", "p", "gamepad.start" }
input.actions.confirm = { "enter", "space", "gamepad.a" }
input.actions.back = { "escape", "backspace", "gamepad.b" }

function run.sparks()
    local n = 0
    for _ in pairs(things.taken) do n = n + 1 end
    return n
end

local function load_level(file)
    if world:has("level") then world.level:delete() end
    scene.load(file, world, "level")
    things.taken, things.chosen, amber_cuts, clock, ended, fade, tide = {}, nil, {}, 0, 0, 1, 0
    fx.clear()
    rewind.begin()
    time.paused = false
end

function run.play(index)
    run.level = index
    load_level(string.format("levels/%02d.json", index))
    screens.open("play")
end

function run.title()
    load_level("levels/00.json")
    screens.open("title")
end

local function cut(rope)
    if not rope or screens.name ~= "play" or not rope:holds() then return end
    local middle = rope:middle()
    rope.enabled = false
    if rope.of_amber then amber_cuts[rope.name] = true end
    things.chosen = nil
    sound.play("cut", 1, 0.9 + 0.2 * math.random())
    fx.burst(middle, 14, 4, rope.of_amber and things.gold or things.pale, 0.12)
end

local function lose()
    screens.open("lost")
    ended = 0
    sound.play("lost")
    view:shake(0.25, 0.4)
end

-- The ball flies into its home. A rewind that ends in this moment takes it back, so it is called again then.
local function fly_home()
    local ball = world.level.ball
    ball.type = "static"
    ball:tween("position", vec(world.level.goal.position), 0.25, "out_back")
end

local function win()
    local level = world.level
    local sparks = run.sparks()
    local points = 1000 + 500 * sparks + 10 * math.floor(math.max(0, level.par - clock) * 10)
    local levels = store.levels or {}
    local old = levels[run.level]
    local best = old and old.score or 0
    screens.result = { score = points, sparks = sparks, seconds = clock, record = points > best, best = best }
    if points > best then
        levels[run.level] = { score = points, sparks = math.max(sparks, old and old.sparks or 0), seconds = clock }
        store.levels = levels
    end
    store.unlocked = math.max(store.unlocked or 1, math.min(run.count, run.level + 1))
    fly_home()
    ended = 0
    screens.open("home")
    sound.play("home")
    view:shake(0.12, 0.4)
    fx.burst(level.goal.position, 60, 7, things.gold, 0.16, 2)
    fx.pop(level.goal.position + vec(0, 1), "Home!")
end

function rewind.restored()
    sound.restored()
    for name in pairs(amber_cuts) do world.level[name].enabled = false end
    if screens.name == "home" then fly_home() end
end

function Ball:contact_hit(hit)
    if hit.speed < 1.5 or screens.name ~= "play" then return end
    sound.play("knock", math.min(1, hit.speed / 12), 0.8 + 0.5 * math.min(1, hit.speed / 14))
    fx.squash = math.min(0.35, hit.speed / 40)
    fx.burst(hit.point, math.floor(hit.speed), hit.speed * 0.35, things.cream, 0.07)
end

function step(dt)
    rewind.step(dt)
    if screens.name ~= "play" then return end
    clock = clock + dt
    local ball, goal = world.level.ball, world.level.goal
    for _, spark in ipairs(world.level:children("Spark")) do
        if not things.taken[spark.name] and (spark.position - ball.position):length() < 0.8 then
            things.taken[spark.name] = true
            sound.play("spark", 1, 1 + 0.12 * (run.sparks() - 1))
            fx.burst(spark.position, 24, 5, things.cream, 0.1, 1)
            fx.pop(spark.position, "+500")
        end
    end
    if (goal.position - ball.position):length() < 0.62 then win() end
    if ball.position.y < -8.5 or math.abs(ball.position.x) > 13.5 then lose() end
end

local function playing(name) return name == "play" or name == "lost" or name == "home" end

function update(dt, real_dt)
    time.paused = screens.name == "pause" or screens.name == "settings" and screens.back == "pause"
    rewind.update(screens.name == "play" and input.rewind.held and not time.paused)
    sound.hum(rewind.active)
    sound.update()
    tide = tide + ((rewind.active and 1 or 0) - tide) * math.min(1, 10 * real_dt)
    fade = math.max(0, fade - 2.5 * real_dt)
    screens.update(real_dt)
    fx.update(time.paused and 0 or real_dt, world:has("level") and playing(screens.name) and world.level:has("ball") and world.level.ball)
    ended = ended + real_dt
    if screens.name == "lost" and ended > 0.7 then run.play(run.level) end
    if screens.name == "home" and ended > 0.9 then screens.open("won") end
    if pointer and screens.name == "play" then
        local near = things.rope_at(pointer, 0.7)
        things.chosen = near and near.name
    end
end

-- Whether two lines between points cross.
local function cross(a, b, c, d)
    local u, v = b - a, d - c
    return u:cross(c - a) * u:cross(d - a) < 0 and v:cross(a - c) * v:cross(b - c) < 0
end

function mouse_moved(position)
    if input.mouse.left and pointer and screens.name == "play" then
        for _, rope in ipairs(world.level:find("Rope")) do
            if rope:holds() and cross(pointer, position, rope:ends()) then cut(rope) end
        end
    end
    pointer = vec(position)
    screens.point(position)
end

function mouse_pressed(button, position)
    pointer = vec(position)
    if button == "left" and screens.in_menu() and screens.age > 0.15 then screens.click(position) end
    if button == "left" and screens.name == "play" then cut(things.rope_at(position, 0.7)) end
end

local function move(x, y)
    if screens.in_menu() then
        screens.move(x, y)
    elseif screens.name == "play" then
        pointer = nil
        local rope = things.rope_towards(vec(x, y))
        things.chosen = rope and rope.name
        sound.play("tick")
    end
end

local arrows = {
    left = { -1, 0 }, right = { 1, 0 }, up = { 0, 1 }, down = { 0, -1 }, a = { -1, 0 }, d = { 1, 0 }, w = { 0, 1 }, s = { 0, -1 },
    dpad_left = { -1, 0 }, dpad_right = { 1, 0 }, dpad_up = { 0, 1 }, dpad_down = { 0, -1 },
}

function key_pressed(key)
    if arrows[key] then move(arrows[key][1], arrows[key][2]) end
end

function gamepad_pressed(_, button)
    if #button > 1 and arrows[button] then move(arrows[button][1], arrows[button][2]) end
end

local tilted = false
function gamepad_axis(_, axis, value)
    if axis ~= "left_x" and axis ~= "left_y" then return end
    if math.abs(value) < 0.3 then tilted = false end
    if math.abs(value) > 0.6 and not tilted then
        tilted = true
        local way = value > 0 and 1 or -1
        move(axis == "left_x" and way or 0, axis == "left_y" and way or 0)
    end
end

function action_pressed(action)
    if screens.in_menu() then
        if action == "confirm" then screens.confirm()
        elseif action == "back" then screens.leave() end
    elseif action == "pause" and screens.name == "play" then
        screens.open("pause")
        sound.play("press")
    elseif action == "restart" and playing(screens.name) then
        run.play(run.level)
    elseif action == "cut" and not input.mouse.left and screens.name == "play" then
        local name = things.chosen
        cut(name and world.level[name])
    end
end

function start()
    view.height, view.fit, view.design = 15, "letterbox", vec(1280, 800)
    view.background = color("#17122f")
    time.rewind_limit = 120
    sound.apply_volumes()
    sound.start_music()
    run.title()
end

function draw_behind(pen) fx.draw_sky(pen, time.now) end

function draw(pen)
    local level = world.level
    things.draw_details(pen, level)
    local ball = level:has("ball") and level.ball
    if ball then
        fx.draw_trail(pen)
        if screens.name ~= "lost" then things.draw_ball(pen, ball:drawn_position(), ball:drawn_angle(), ball.circle.radius, fx.squash) end
    end
    fx.draw(pen)
    fx.draw_tide(pen, tide)
    if playing(screens.name) then screens.draw_play(pen, rewind.past(), tide) end
    screens.draw(pen)
    if fade > 0 then pen.box(vec(0, 0), 40, 16, things.faded(color("#17122f"), fade)) end
end
