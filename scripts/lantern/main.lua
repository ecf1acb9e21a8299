-- Keep your lantern burning while a thousand creatures of the night come for it. Three arenas, three bosses, ten gifts that grow.
Night = class("Night", Object) {
    running = false, menu = "title", pick = 1, arena = 1, first = 1, clock = 0.0, score = 0, kills = 0, crowd = 0, boss = false, rest = 0.0,
    streak = 0, streak_at = 0.0, rank = 0, curtain = 0.0, choices = { "" },
}
game.night, game.settings = Night {}, Object { effects = 0.8, music = 0.5, shake = true }
for name, value in pairs(store.settings or {}) do settings[name] = value end

local bodies, effects, arenas, enemies = require "bodies", require "effects", require "arenas", require "enemies"
require "hero"
require "weapons"
local play_music, menu = require "music", require "menus"

for name, keys in pairs {
    dash = { "space", "left_shift", "mouse.right", "gamepad.a", "gamepad.right_trigger" }, accept = { "enter", "space", "gamepad.a" },
    back = { "escape", "backspace", "gamepad.b" }, pause = { "escape", "p", "gamepad.start" },
    menu_up = { "up", "w", "gamepad.dpad_up", "gamepad.left_y+" }, menu_down = { "down", "s", "gamepad.dpad_down", "gamepad.left_y-" },
    menu_left = { "left", "a", "gamepad.dpad_left", "gamepad.left_x-" }, menu_right = { "right", "d", "gamepad.dpad_right", "gamepad.left_x+" },
} do input.actions[name] = keys end

world.gravity, world.bounds = vec(0, 0), { -bodies.half, bodies.half }
world.ground = Layer { z = -100, repeat_x = 8, repeat_y = 8, Sprite { size = vec(8, 8) } }
for _, name in ipairs { "stones", "gems", "swarm", "lights", "shots", "arms" } do world[name] = Object {} end
view.height, view.background, view.follow_damping = 18, color("#05030c"), 0.12
view.limits = { -bodies.half - vec(2, 2), bodies.half + vec(2, 2) }

function Night:enter(index)
    local arena = arenas[index]
    for _, name in ipairs { "stones", "gems", "swarm", "shots", "lights" } do world[name]:children():delete() end
    self.arena, self.clock, self.crowd, self.boss, self.rest, self.curtain = index, 0, 0, false, 0, 1
    self:tween("curtain", 0, 0.7)
    world.ground.sprite.image, world.hero.light.tint, world.hero.position, view.center = arena.ground, arena.glow, vec(0, 0), vec(0, 0)
    bodies.refresh()
    for _ = 1, 44 do
        local at, size = vec(random(-1.0, 1.0) * bodies.half.x, random(-1.0, 1.0) * bodies.half.y) * 0.95, random(1.8, 3.0)
        if at:length() > 5 then
            world.stones:add(Body { type = "static", position = at, z = -0.01 * at.y, bodies.disc(size * 0.2, bodies.STONE, bodies.SOLID),
                bodies.look(tostring(index), size, size * 0.3, "props", 3, 1) })
        end
    end
    effects.banner(arena.name, arena.goal)
end

local function reset()
    world.arms:children():delete()
    for _, name in ipairs(arms.order) do world.arms[name] = Arm {} end
    if world:has("hero") then world.hero:delete() end
    world.hero = Hero { bodies.disc(0.36, bodies.HERO, bodies.SOLID, false, 30), look = bodies.look("17-20", 1.35, 0.2),
        light = Sprite { image = "art/glow.png", size = vec(17, 17), blend = "add", z = -40 } }
    view.follow = world.hero
    night:enter(night.first)
end

function Night:begin()
    reset()
    self.score, self.kills, self.rank, self.running, self.menu, world.arms.sparks.level = 0, 0, 0, true, "", 1
    for _ = 1, 8 * (self.first - 1) do arms.take(arms.offer()[1]) end      -- who begins later begins with gifts
end

function Night:finish(how)                       -- "over" or "win"; keeps the eight best scores
    local rows = {}
    self.running, self.rank, self.menu = false, 1, ""
    for i, row in ipairs(store.scores or {}) do
        rows[i] = { score = row.score, arena = row.arena, kills = row.kills, won = row.won }
        if row.score >= self.score then self.rank = i + 1 end
    end
    table.insert(rows, self.rank, { score = self.score, arena = self.arena, kills = self.kills, won = how == "win" })
    rows[9] = nil
    store.scores = rows
    after(1.4, function() menu.open(how) end)
end

function enemies.cleared()                       -- the boss is beaten: its swarm goes, and all gems come
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

function Night:step(dt)
    if not self.running then return end
    if self.rest == 0 then
        self.clock = self.clock + dt
        enemies.come(dt)
        if self.clock >= arenas[self.arena].length and not self.boss then enemies.boss() end
    elseif self.rest > dt then
        self.rest = self.rest - dt
    elseif self.arena < #arenas then
        world.hero.hp = math.min(world.hero.max_hp, world.hero.hp + 40)
        self:enter(self.arena + 1)
    else
        self.score = self.score + 50 * math.floor(world.hero.hp)
        self:finish("win")
    end
end

function start()
    night.first = store.unlocked or 1
    reset()
    effects.banner("", "")
    for i = 1, 50 do enemies.spawn(({ "shade", "shade", "moth", "spitter", "brute" })[i % 5 + 1], bodies.toward(i * 2.4, 9 + i % 5)) end
end

function step()
    bodies.refresh()
    play_music(bodies.count)
end

function update(dt, real_dt)
    audio.buses.effects.volume, audio.buses.music.volume = settings.effects, settings.music
    menu.update(real_dt)
    effects.update(dt)
end

function draw(pen)
    pen.box(vec(0, 0), 2 * bodies.half.x, 2 * bodies.half.y, false, arenas[night.arena].edge, 4)
    effects.draw(pen, 1)
    effects.draw(pen, 2)
    menu.draw(pen)
end
