-- Run with the arrow keys or a stick, jump with space or A, and collect all coins on the way to the flag.

local run_speed, jump_speed = 7, 11      -- m/s
local ground_grip, air_grip = 12, 4      -- how fast the hero reaches its speed, 1/s
local late_jump = 0.1                    -- s after leaving the ground in which a jump still works

local grass, rock = color("#3f7d4e"), color("#4a5568")
local platforms = {  -- left, top, width, height
    { -20, 0, 34, 4 }, { 3, 2, 4, 0.6 }, { 9, 4, 4, 0.6 }, { 17, 0, 10, 4 }, { 22, 2, 3, 0.6 },
    { 29.5, 1, 3, 5 }, { 35, 2.5, 3, 6.5 }, { 41, 0, 16, 4 },
}
local coins = { vec(5, 3), vec(11, 5), vec(20, 1), vec(23.5, 3), vec(31, 2.2), vec(36.5, 3.8), vec(44, 1) }

-- Values that change are in the tree, not in local variables, so that saved games and `rewind` include them.
-- A child of `game` can be used by its name alone: `course`, `world`, `sounds`.
game.course = Object { coins = 0, falls = 0, won = false, seconds = 0 }

-- `input.move` has the arrow keys, WASD and the stick of a gamepad from the beginning.
input.actions.jump = { "space", "up", "w", "gamepad.a" }
input.actions.again = { "r", "gamepad.start" }

game.sounds = Object { jump = Synth.jump { volume = 0.5 }, coin = Synth.coin(), fall = Synth.hit(), won = Synth.power_up() }

Hero = class("Hero", Body) { air_time = 0.0, facing = 1 }

-- Whether the hero stands on something: one of its contacts points downwards.
function Hero:stands()
    for _, normal in ipairs(self.contact_normals) do
        if normal.y < -0.7 then return true end
    end
    return false
end

function Hero:step(dt)
    self.air_time = self:stands() and 0.0 or self.air_time + dt
    local direction = input.move.x
    if direction ~= 0 then self.facing = direction > 0 and 1 or -1 end
    local grip = self.air_time == 0 and ground_grip or air_grip
    local speed = self.velocity.x
    self.velocity.x = speed + (direction * run_speed - speed) * math.min(1, grip * dt)
    if self.position.y < -8 then
        course.falls = course.falls + 1
        sounds.fall:play()
        self.position, self.velocity = vec(-4, 1), vec(0, 0)
    end
end

function Hero:jump()
    if self.air_time > late_jump then return end
    self.velocity.y = jump_speed
    self.air_time = late_jump + 1 -- no second jump in the air
    sounds.jump:play()
end

function Hero:draw(pen)
    local eye = self:drawn_position() + vec(0.18 * self.facing, 0.3)
    pen.circle(eye, 0.11, "white")
    pen.circle(eye + vec(0.04 * self.facing, 0), 0.05, "black")
end

Coin = class("Coin", Body) {}

function Coin:sensor_begin(event)
    if event.other ~= world.hero then return end
    course.coins = course.coins + 1
    sounds.coin:play { pitch = 1 + 0.06 * course.coins }
    self:delete()
end

function Coin:draw(pen)
    local place = self.position + vec(0, 0.08 * math.sin(3 * time.now + self.position.x))
    pen.circle(place, 0.3, "#ffd43b", "#b8860b", 3)
    pen.circle(place, 0.14, "#fff3bf")
end

-- Puts the hero at the beginning and the coins where they were.
local function begin()
    course.coins, course.falls, course.won, course.seconds = 0, 0, false, 0
    world.coins = Object {}
    for _, position in ipairs(coins) do
        world.coins:add(Coin { type = "static", position = position, Circle { radius = 0.3, sensor = true, visible = false } })
    end
    world.hero.position, world.hero.velocity = vec(-4, 1), vec(0, 0)
end

-- When this file is saved, the code outside of functions runs again in the running game.
view.background = color("#8ecae6")
view.height = 12
world.gravity = vec(0, -25)
world.platforms = Object {}
for _, place in ipairs(platforms) do
    local left, top, width, height = table.unpack(place)
    world.platforms:add(Body {
        type = "static", position = vec(left + width / 2, top - height / 2),
        Box { width = width, height = height, color = height > 1 and rock or grass, friction = 0.2 },
    })
end
world.hero = Hero {
    position = vec(-4, 1), locked_rotation = true, can_sleep = false,
    Capsule { from = vec(0, -0.25), to = vec(0, 0.3), radius = 0.35, friction = 0, color = color("#e5484d"), z = -1 },  -- below its eye
}

function start()
    begin()
end

function step(dt)
    if course.won then return end
    course.seconds = course.seconds + dt
    if course.coins == #coins and world.hero.position.x > 53 then
        course.won = true
        sounds.won:play()
        if not store.best or course.seconds < store.best then store.best = course.seconds end
    end
end

function update(dt)
    local ahead = world.hero.position + vec(2, 2)
    view.center = view.center:lerp(vec(ahead.x, math.max(2, ahead.y)), math.min(1, 4 * dt))
end

function action_pressed(action)
    if action == "jump" then world.hero:jump() end
    if action == "again" then begin() end
end

function draw(pen)
    pen.line(vec(54, 0), vec(54, 3), "#5a4632", 6)
    pen.polygon({ vec(54, 3), vec(54, 2), vec(55.6, 2.5) }, course.coins == #coins and "#46a758" or "#a0a8b8")
    pen.screen(function()
        pen.text(vec(20, 26), "Coins " .. course.coins .. " of " .. #coins, 22, "white", "left")
        pen.text(vec(20, 54), string.format("%.1f s", course.seconds), 22, "white", "left")
    end)
    pen.text(vec(-4, 4.5), "Arrow keys: run\nSpace: jump", 0.6, "white")
    if course.won then
        pen.text(view.center + vec(0, 3), string.format("Done in %.1f s. Best: %.1f s\nR: again", course.seconds, store.best), 0.8, "white")
    elseif world.hero.position.x > 50 then
        pen.text(vec(53, 4.5), "Bring all coins to the flag", 0.6, "white")
    end
end
