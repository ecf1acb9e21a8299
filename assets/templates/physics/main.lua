-- Knock all crates off the table. Hold the left button, pull back and let go to throw a ball.

local throw_strength = 9      -- m/s for each meter of the pull
local longest_pull = 3        -- m
local hand = vec(-9, 2.5)     -- where balls are thrown from

-- What changes in the game is in the tree, so that saves and going back in time hold it.
game.round = Object { balls = 5, level = 1, pulling = false, done = false }

game.sounds = Object { throw = Synth.jump(), hit = Synth.hit { volume = 0.4 }, won = Synth.power_up() }

local colors = { color("#e5484d"), color("#ffb224"), color("#46a758"), color("#3e63dd"), color("#8e4ec6") }

Crate = class("Crate", Body) {}

function Crate:contact_hit(hit)
    if hit.speed > 3 then sounds.hit:play { volume = math.min(1, hit.speed / 15) } end
end

local function build_tower(level)
    world.crates = Object {}
    for row = 0, level + 1 do
        for column = 0, 1 do
            world.crates:add(Crate {
                position = vec(4.9 + column * 1.2, 1.51 + row),
                Box { width = 0.98, height = 0.98, rounding = 0.06, density = 0.6, color = colors[row % #colors + 1] },
            })
        end
    end
end

local function begin(level)
    round.balls, round.level, round.pulling, round.done = 5, level, false, false
    world.balls = Object {}
    build_tower(level)
end

local function crates_left()
    local count = 0
    world.crates:each("Body", function(crate)
        if crate.position.y > 0.9 then count = count + 1 end
    end)
    return count
end

local function pull()
    local back = hand - input.mouse.world
    local length = back:length()
    return length > longest_pull and back * (longest_pull / length) or back
end

-- What is made here, outside of functions, follows the file while the game runs.
view.background = color("#1b2130")
view.center = vec(0, 4)
view.height = 13
world.ground = Body { type = "static", position = vec(0, -5), Box { width = 60, height = 10, color = color("#2f3b2f") } }
world.table = Body { type = "static", position = vec(5.5, 0.5), Box { width = 4, height = 1, color = color("#6b4f3a") } }

function start()
    begin(1)
    store.best = store.best or 0
end

function reloaded()
    build_tower(round.level)
end

function step()
    if not round.done and crates_left() == 0 then
        round.done = true
        sounds.won:play()
        if round.level > store.best then store.best = round.level end
    end
end

function mouse_pressed(button)
    if button == "left" and round.balls > 0 and not round.done then round.pulling = true end
end

function mouse_released(button)
    if button ~= "left" or not round.pulling then return end
    round.pulling = false
    round.balls = round.balls - 1
    sounds.throw:play()
    world.balls:add(Body {
        position = hand, velocity = pull() * throw_strength, bullet = true,
        Circle { radius = 0.35, density = 3, restitution = 0.3, color = color("#e8e8e8") },
    })
end

function key_pressed(key)
    if key == "r" then begin(round.level) end
    if key == "space" and round.done then begin(round.level + 1) end
end

local function draw_path(pen)
    local place, velocity = hand, pull() * throw_strength
    for i = 1, 24 do
        velocity = velocity + world.gravity * 0.05
        place = place + velocity * 0.05
        pen.circle(place, 0.06, color(1, 1, 1, 1 - i / 24))
    end
end

function draw(pen)
    for i = 1, round.balls do pen.circle(vec(-10.4 + i * 0.5, 0.2), 0.2, "#e8e8e8") end
    if round.pulling then draw_path(pen) end
    pen.circle(hand, 0.35, "#e8e8e8")
    local message = "Level " .. round.level
    local hint = "Best level: " .. store.best
    if round.done then
        message = "All crates are down! Space: next level"
    elseif round.balls == 0 then
        message = "No ball is left. R: again"
    elseif round.balls == 5 and round.level == 1 then
        hint = "Hold the left button anywhere, pull back, and let go"
    end
    pen.text(vec(0, 9.4), message, 0.7, "white")
    pen.text(vec(0, 8.6), hint, 0.4, "#c0c8d8")
end
