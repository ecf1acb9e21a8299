-- Keep your lantern burning while a thousand creatures of the night come for it. Three arenas, three bosses, ten gifts that grow.
-- main.lua makes the world and leads through a run: menus.lua shows it, enemies.lua, hero.lua and weapons.lua play it.

local common = require "common"
local effects = require "effects"
local arenas = require "arenas"
local enemies = require "enemies"
local new_hero = require "hero"
require "weapons"
local play_music = require "sounds"
local menu = require "menus"

local actions = input.actions
actions.dash = { "space", "left_shift", "mouse.right", "gamepad.a", "gamepad.right_trigger" }
actions.accept = { "enter", "space", "gamepad.a" }
actions.back = { "escape", "backspace", "gamepad.b" }
actions.pause = { "escape", "p", "gamepad.start" }
actions.menu_up = { "up", "w", "gamepad.dpad_up", "gamepad.left_y+" }
actions.menu_down = { "down", "s", "gamepad.dpad_down", "gamepad.left_y-" }
actions.menu_left = { "left", "a", "gamepad.dpad_left", "gamepad.left_x-" }
actions.menu_right = { "right", "d", "gamepad.dpad_right", "gamepad.left_x+" }

game.night = Object {
    running = false, menu = "title", pick = 1, arena = 1, first = 1, clock = 0.0, score = 0, kills = 0, crowd = 0, boss = false, cleared = 0.0,
    streak = 0, streak_at = 0.0, rank = 0, curtain = 0.0, began = 0.0, choices = { "" },
}
game.settings = Object { effects = 0.8, music = 0.5, shake = true }

world.gravity = vec(0, 0)
world.bounds = { vec(-common.half.x, -common.half.y), vec(common.half.x, common.half.y) }
world.ground = Layer { z = -100, repeat_x = 8, repeat_y = 8, Sprite { image = arenas[1].ground, size = vec(8, 8) } }
for _, name in ipairs { "stones", "gems", "swarm", "lights", "shots", "arms" } do world[name] = Object {} end
for _, name in ipairs(arms.order) do world.arms[name] = Arm {} end
world.hero = new_hero()

view.height = 18
view.background = color("#05030c")
view.follow, view.follow_damping = world.hero, 0.12
view.limits = { vec(-common.half.x - 2, -common.half.y - 2), vec(common.half.x + 2, common.half.y + 2) }

local function clear(...)
    for _, name in ipairs { ... } do world[name]:children():delete() end
end

local function enter_arena(index)
    local arena = arenas[index]
    clear("stones", "gems", "swarm", "shots", "lights")
    night.arena, night.clock, night.crowd, night.boss, night.cleared = index, 0.0, 0, false, 0.0
    world.ground.sprite.image = arena.ground
    world.hero.position, world.hero.velocity = vec(0, 0), vec(0, 0)
    world.hero.light.tint = color(arena.glow.r, arena.glow.g, arena.glow.b, 0.2)
    view.center = vec(0, 0)
    common.refresh(time.dt)
    for _ = 1, 44 do
        local at = vec(random(-1.0, 1.0) * common.half.x * 0.95, random(-1.0, 1.0) * common.half.y * 0.95)
        if at:length() > 5 then
            local size = random(1.8, 3.0)
            world.stones:add(Body { type = "static", position = at, z = -0.01 * at.y,
                Circle { radius = size * 0.2, friction = 0, category = common.STONE, visible = false },
                look = Sprite { image = "art/props.png", columns = 3, animation = tostring(arena.prop), size = vec(size, size),
                    position = vec(0, size * 0.3), flip_x = random() < 0.5 } })
        end
    end
    night.curtain = 1.0
    night:tween("curtain", 0, 0.7)
end

function menu.begin()
    clear("arms")
    for _, name in ipairs(arms.order) do world.arms[name] = Arm {} end
    world.hero:delete()
    world.hero = new_hero()
    view.follow = world.hero
    night.score, night.kills, night.rank, night.began = 0, 0, 0, time.now
    enter_arena(night.first)
    world.arms.sparks.level = 1
    for _ = 1, 3 * (night.first - 1) do                    -- who begins later begins with gifts
        local offer = arms.offer()
        arms.take(offer[random(#offer)])
    end
    night.running, night.menu = true, ""
    effects.banner(arenas[night.first].name, arenas[night.first].goal)
end

function common.level_up()
    local offer = arms.offer()
    if #offer == 0 then return end
    night.choices, night.menu, night.pick = offer, "choose", 1
end

local function keep_score(won)
    local rows = {}
    for i, row in ipairs(store.scores or {}) do rows[i] = { score = row.score, arena = row.arena, kills = row.kills, won = row.won } end
    local own = { score = night.score, arena = night.arena, kills = night.kills, won = won }
    local rank = #rows + 1
    while rank > 1 and rows[rank - 1].score < own.score do rank = rank - 1 end
    table.insert(rows, rank, own)
    rows[9] = nil
    night.rank = rank
    store.scores = rows
end

-- The run is over: "over" or "win".
function common.ended(how)
    if not night.running then return end
    night.running = false
    keep_score(how == "win")
    after(how == "win" and 0.5 or 1.6, function() menu.open(how) end)
end

-- The boss is beaten: its swarm goes, and all gems come.
function common.cleared()
    for _, enemy in ipairs(world.swarm:children()) do
        effects.burst(enemy.position, color("#ffd98a"), 2)
        if random() < 0.3 then enemies.drop(enemy.position, enemy.worth) end
        enemy:delete()
    end
    night.crowd, night.cleared = 0, 4.5
    clear("shots")
    world.gems:each("Gem", Gem.fly)
    store.unlocked = math.max(store.unlocked or 1, math.min(#arenas, night.arena + 1))
    effects.banner(night.arena < #arenas and "The way is clear" or "The sky turns bright", "+" .. 2000 * night.arena)
end

local function go_on(dt)
    if night.cleared > 0 then
        night.cleared = night.cleared - dt
        if night.cleared > 0 then return end
        if night.arena == #arenas then
            night.score = night.score + 50 * math.floor(world.hero.hp)
            return common.ended("win")
        end
        world.hero.hp = math.min(world.hero.max_hp, world.hero.hp + 40)
        enter_arena(night.arena + 1)
        return effects.banner(arenas[night.arena].name, arenas[night.arena].goal)
    end
    night.clock = night.clock + dt
    enemies.come(dt)
    if night.clock >= arenas[night.arena].length and not night.boss then
        night.boss = true
        enemies.boss()
    end
end

function start()
    for name, value in pairs(store.settings or {}) do settings[name] = value end
    settings:watch(function() store.settings = { effects = settings.effects, music = settings.music, shake = settings.shake } end)
    night.first = math.min(store.unlocked or 1, #arenas)
    enter_arena(night.first)
    for i = 1, 46 do
        local angle = i * 2.4
        enemies.spawn(({ "shade", "shade", "moth", "spitter", "brute" })[i % 5 + 1], vec(math.cos(angle), math.sin(angle)) * (6 + i % 7))
    end
end

function step(dt)
    common.refresh(dt)
    play_music(common.count)
    if night.running then go_on(dt) end
end

function update(dt, real_dt)
    audio.buses.effects.volume, audio.buses.music.volume = settings.effects, settings.music
    menu.update(real_dt)
    effects.update(dt, real_dt)
    while common.comets[1] and (common.now - common.comets[1].from > 0.6 or common.comets[1].from > common.now) do table.remove(common.comets, 1) end
end

function draw_behind(pen)
    -- Beyond the bounds it is dark; the ground is drawn later, so the edge is a part of draw().
end

function draw(pen)
    local edge, half = arenas[night.arena].edge, common.half
    pen.box(vec(0, 0), 2 * half.x, 2 * half.y, false, edge, 4)
    for _, comet in ipairs(common.comets) do
        local t = math.max(0, 0.55 - (time.now - comet.from)) / 0.55
        pen.push()
        pen.blend("add")
        local size = 1.2 + t
        pen.image("art/glow.png", comet.at, 2.4, 2.4, 0, "#5a8cff50")
        pen.image("art/glow.png", comet.at + vec(5, 9) * t, size, size, 0, "#bfe4ff")
        pen.line(comet.at + vec(5, 9) * t, comet.at + vec(5, 9) * math.min(1, t + 0.25), "#8ad0ff80", 4)
        pen.pop()
    end
    effects.draw(pen)
    menu.draw(pen)
end
