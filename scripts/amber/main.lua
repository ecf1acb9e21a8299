-- Cut ropes and turn back time to bring a drop of amber home. Time turns back for everything but the drop.
local rewind, things, fx = require("rewind"), require("things"), require("fx")
local sound, screens = require("sound"), require("screens")

local run = screens.game                     -- the game as the screens see it
local amber_cuts = {}                        -- names of the cut ropes of amber, which no rewind mends
local clock, fade = 0, 1                     -- s of play; how dark the screen is
local pointer                                -- where the mouse is, while it is used

input.actions.cut = { "mouse.left", "enter", "gamepad.a" }
input.actions.rewind = { "space", "mouse.right", "left_shift", "gamepad.x", "gamepad.right_trigger" }
input.actions.restart = { "r", "gamepad.y" }
input.actions.pause = { "escape", "p", "gamepad.start" }
input.actions.choose = { { "a", "d", "s", "w" }, { "left", "right", "down", "up" }, "gamepad.left", "gamepad.pad" }

local function load_level(index, screen)
    run.level, run.sparks, run.still = index, 0, 0
    if world:has("level") then world.level:delete() end
    scene.load(string.format("levels/%02d.json", index), world, "level").number = index
    things.taken, things.chosen, amber_cuts, clock, fade = {}, nil, {}, 0, 1
    fx.clear()
    rewind.begin()
    screens.open(screen)
end

function run.play(index)
    run.tries = index == run.level and run.tries + 1 or 1
    load_level(index, "play")
end
function run.title() load_level(0, "title") end
local function playing() return screens.name == "play" end

local function cut(rope)
    if not rope or not playing() or not rope:holds() then return end
    rope.enabled = false
    if rope.of_amber then amber_cuts[rope.name] = true end
    sound.play("cut", 1, 0.9 + 0.2 * random())
    fx.burst(rope:middle(), 14, 4, rope.of_amber and things.gold or things.pale, 0.08)
end

local function finish(screen, noise, shake)
    screens.open(screen)
    sound.play(noise)
    view:shake(shake, 0.4)
end

-- The ball flies into its home. A rewind that ends at this moment undoes that, so `rewind.restored` calls it again.
local function fly_home()
    world.level.ball.type = "static"
    world.level.ball:tween("position", vec(world.level.goal.position), 0.25, "out_back")
end

local function win()
    local levels, sparks = store.levels or {}, run.sparks
    local old = levels[run.level] or { score = 0, sparks = 0 }
    local score = 1000 + 500 * sparks + 100 * math.ceil(math.max(0, world.level.par - clock))
    screens.result = { score = score, sparks = sparks, seconds = clock, record = score > old.score, best = old.score }
    levels[run.level] = { score = math.max(score, old.score), sparks = math.max(sparks, old.sparks) }
    store.levels = levels
    run.tries = 0
    store.unlocked = math.max(screens.reached(), math.min(run.count, run.level + 1))
    fly_home()
    finish("home", "home", 0.12)
    fx.burst(world.level.goal.position, 60, 7, things.gold, 0.12, 2)
    fx.pop(world.level.goal.position + vec(0, 1), "Home!")
end

function rewind.restored()
    sound.restored()
    run.level = world.level.number
    screens.restored()
    for name in pairs(amber_cuts) do world.level[name].enabled = false end
    if screens.name == "home" then fly_home() end
end
function reloaded() rewind.begin() rewind.restored() end     -- the level goes on, though variables have their first values again

function Ball:contact_hit(hit)
    if hit.speed < 1.5 or not playing() then return end
    sound.play("knock", math.min(1, hit.speed / 12), 0.8 + 0.5 * math.min(1, hit.speed / 14))
    fx.squash = math.min(0.35, hit.speed / 40)
    fx.burst(hit.point, math.floor(hit.speed), hit.speed * 0.35, things.cream, 0.05)
end

function Rope:broke()
    sound.play("snap")
    fx.burst(self:middle(), 12, 4, things.pale, 0.08)
end

function step(dt)
    rewind.step()
    if not playing() then return end
    clock = clock + dt
    run.still = world.level.ball.velocity:length() < 0.05 and run.still + dt or 0
    local at, home = world.level.ball.position, world.level.goal.position
    for _, spark in ipairs(world.level:children("Spark")) do
        if not things.taken[spark.name] and (spark.position - at):length() < 0.8 then
            things.taken[spark.name] = true
            sound.play("spark", 1, 1 + 0.12 * run.sparks)
            run.sparks = run.sparks + 1
            fx.burst(spark.position, 24, 5, things.cream, 0.07, 1)
            fx.pop(spark.position, "+500")
        end
    end
    if (home - at):length() < 0.62 then win() elseif at.y < -8.5 or math.abs(at.x) > 13.5 then finish("lost", "lost", 0.25) end
end

function update(dt, real_dt)
    rewind.update(playing() and input.rewind.held)
    sound.update(rewind.active)
    fade = math.max(0, fade - 2.5 * real_dt)
    screens.update(real_dt)
    fx.update(time.paused and 0 or real_dt, screens.in_level() and world.level.ball, rewind.active)
    if screens.name == "lost" and screens.age > 0.7 then run.play(run.level) end
    if screens.name == "home" and screens.age > 0.9 then screens.open("won") end
    local near = pointer and playing() and things.rope_at(pointer, 0.7)
    if pointer then things.chosen = near and near.name end
end

-- Dragging the mouse over ropes cuts them, as clicking does.
function mouse_moved(position)
    if input.mouse.left and playing() then cut(things.rope_at(position, 0.3)) end
    pointer = vec(position)
end

function action_pressed(action)
    if action == "restart" then run.play(run.level) end
    if not playing() then return end
    if action == "choose" then
        local rope = things.rope_towards(input.choose.direction)
        things.chosen, pointer = rope and rope.name, nil
        sound.play("tick")
    elseif action == "pause" then
        screens.open("pause")
        sound.play("press")
    elseif action == "cut" and input.mouse.left then
        cut(things.rope_at(input.mouse.world, 0.7))
    elseif action == "cut" and things.chosen then
        cut(world.level[things.chosen])
    end
end

function start()
    view.height, view.fit, view.background = 15, "letterbox", color("#130f2b")
    time.rewind_limit = 120
    scene.load("sky.json", world, "sky")
    sound.start()
    run.title()
end

function draw(pen)
    if screens.in_level() then fx.draw_trail(pen) end
    if screens.name ~= "lost" then things.draw_ball(pen, world.level.ball, fx.squash) end
    fx.draw(pen)
    if screens.in_level() then screens.draw_play(pen, rewind.past()) end
    if fade > 0 then pen.box(vec(0, 0), 40, 16, things.faded(view.background, fade)) end
end
