-- Keep your lantern burning while a thousand creatures of the night come for it. Three arenas, three bosses, ten gifts that grow.
game.night = Object {
    running = false, menu = "title", pick = 1, arena = 1, first = 1, clock = 0.0, score = 0, kills = 0, crowd = 0, boss = false, rest = 0.0,
    streak = 0, streak_at = 0.0, rank = 0, curtain = 0.0, choices = { "" },
}
game.settings = Object { effects = 0.8, music = 0.5, shake = true }
for name, value in pairs(store.settings or {}) do settings[name] = value end

local common, effects, arenas = require "common", require "effects", require "arenas"
local enemies, new_hero = require "enemies", require "hero"
require "weapons"
local play_music, menu = require "sounds", require "menus"

for name, keys in pairs {
    dash = { "space", "left_shift", "mouse.right", "gamepad.a", "gamepad.right_trigger" }, accept = { "enter", "space", "gamepad.a" },
    back = { "escape", "backspace", "gamepad.b" }, pause = { "escape", "p", "gamepad.start" },
    menu_up = { "up", "w", "gamepad.dpad_up", "gamepad.left_y+" }, menu_down = { "down", "s", "gamepad.dpad_down", "gamepad.left_y-" },
    menu_left = { "left", "a", "gamepad.dpad_left", "gamepad.left_x-" }, menu_right = { "right", "d", "gamepad.dpad_right", "gamepad.left_x+" },
} do input.actions[name] = keys end

world.gravity = vec(0, 0)
world.bounds = { -common.half, common.half }
world.ground = Layer { z = -100, repeat_x = 8, repeat_y = 8, Sprite { size = vec(8, 8) } }
for _, name in ipairs { "stones", "gems", "swarm", "lights", "shots", "arms" } do world[name] = Object {} end
view.height, view.background, view.follow_damping = 18, color("#05030c"), 0.12
view.limits = { -common.half - vec(2, 2), common.half + vec(2, 2) }

local function enter_arena(index)
    local arena = arenas[index]
    for _, name in ipairs { "stones", "gems", "swarm", "shots", "lights" } do world[name]:children():delete() end
    night.arena, night.clock, night.crowd, night.boss, night.rest, night.curtain = index, 0.0, 0, false, 0.0, 1.0
    night:tween("curtain", 0, 0.7)
    world.ground.sprite.image, world.hero.light.tint = arena.ground, arena.glow
    world.hero.position, view.center = vec(0, 0), vec(0, 0)
    common.refresh(time.dt)
    for _ = 1, 44 do
        local at, size = vec(random(-1.0, 1.0) * common.half.x, random(-1.0, 1.0) * common.half.y) * 0.95, random(1.8, 3.0)
        if at:length() > 5 then
            world.stones:add(Body { type = "static", position = at, z = -0.01 * at.y, common.disc(size * 0.2, common.STONE, common.SOLID),
                Sprite { image = "art/props.png", columns = 3, animation = tostring(index), size = vec(size, size), position = vec(0, size * 0.3) } })
        end
    end
    effects.banner(arena.name, arena.goal)
end

local function reset()
    world.arms:children():delete()
    for _, name in ipairs(arms.order) do world.arms[name] = Arm {} end
    if world:has("hero") then world.hero:delete() end
    world.hero = new_hero()
    view.follow = world.hero
    enter_arena(night.first)
end

function menu.begin()
    reset()
    night.score, night.kills, night.rank = 0, 0, 0
    world.arms.sparks.level = 1
    for _ = 1, 8 * (night.first - 1) do                    -- who begins later begins with gifts
        local offer = arms.offer()
        arms.take(offer[random(#offer)])
    end
    night.running, night.menu = true, ""
end

function common.level_up()
    local offer = arms.offer()
    if #offer > 0 then night.choices, night.menu, night.pick = offer, "choose", 1 end
end

-- The run is over: "over" or "win". Keeps the eight best scores.
function common.ended(how)
    night.running, night.rank = false, 1
    local rows = {}
    for i, row in ipairs(store.scores or {}) do
        rows[i] = { score = row.score, arena = row.arena, kills = row.kills, won = row.won }
        if row.score >= night.score then night.rank = i + 1 end
    end
    table.insert(rows, night.rank, { score = night.score, arena = night.arena, kills = night.kills, won = how == "win" })
    rows[9] = nil
    store.scores = rows
    after(how == "win" and 0.3 or 1.4, function() menu.open(how) end)
end

-- The boss is beaten: its swarm goes, and all gems come.
function common.cleared()
    for _, enemy in ipairs(world.swarm:children()) do
        effects.burst(enemy.position, color("#ffd98a"), 1)
        if random() < 0.3 then enemies.drop(enemy.position, enemy.worth) end
    end
    world.swarm:children():delete()
    world.shots:children():delete()
    world.gems:each("Gem", Gem.fly)
    night.crowd, night.rest, store.unlocked = 0, 4.5, math.max(store.unlocked or 1, math.min(#arenas, night.arena + 1))
    effects.banner(night.arena < #arenas and "The way is clear" or "The sky turns bright", "+" .. 2000 * night.arena)
end

local function go_on(dt)
    if night.rest > dt then
        night.rest = night.rest - dt
    elseif night.rest > 0 and night.arena == #arenas then
        night.score = night.score + 50 * math.floor(world.hero.hp)
        common.ended("win")
    elseif night.rest > 0 then
        world.hero.hp = math.min(world.hero.max_hp, world.hero.hp + 40)
        enter_arena(night.arena + 1)
    else
        night.clock = night.clock + dt
        enemies.come(dt)
        if night.clock >= arenas[night.arena].length and not night.boss then enemies.boss() end
    end
end

function start()
    night.first = store.unlocked or 1
    reset()
    effects.banner("", "")
    for i = 1, 50 do enemies.spawn(({ "shade", "shade", "moth", "spitter", "brute" })[i % 5 + 1], common.toward(i * 2.4, 9 + i % 5)) end
    settings:watch(function() store.settings = { effects = settings.effects, music = settings.music, shake = settings.shake } end)
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
end

function draw(pen)
    pen.box(vec(0, 0), 2 * common.half.x, 2 * common.half.y, false, arenas[night.arena].edge, 4)
    effects.draw(pen)
    menu.draw(pen)
end
