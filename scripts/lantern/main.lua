-- Keep your lantern burning while a thousand creatures of the night come for it. Three arenas, three bosses, ten gifts that grow.
Night = class("Night", Object) {
    running = false, menu = "", choices = { "sparks" }, arena = 1, first = 1, clock = 0.0, score = 0, kills = 0, crowd = 0, boss = false,
    rest = 0.0, streak = 0, streak_at = 0.0, won = false, rank = 0, open = 0.0, curtain = 0.0,
    slowed = false, title = "", subtitle = "", said = -9.0, lost = 0,
}
game.night, game.settings = Night {}, Object { shake = true }
audio.buses.effects.volume, audio.buses.music.volume = 0.8, 0.5      -- until the player moves the sliders, which are bound to them
local bodies, effects, arenas, enemies = require "bodies", require "effects", require "arenas", require "enemies"
require "hero"
require "weapons"
local play_music, menu = require "music", require "menus"
input.actions.dash = { "space", "left_shift", "mouse.right", "gamepad.a", "gamepad.right_trigger" }
input.actions.pause = { "escape", "p", "gamepad.start" }

world.gravity, world.bounds = vec(0, 0), { -bodies.half, bodies.half }
local corner = vec(bodies.half.x, -bodies.half.y)
world.edge = Line { width = 0.09, closed = true, points = { -bodies.half, corner, bodies.half, -corner } }
world.ground = Layer { z = -100, repeat_x = 8, repeat_y = 8, Sprite { size = vec(8, 8) } }
for _, name in ipairs { "stones", "gems", "swarm", "lights", "shots", "effects" } do world[name] = Object {} end
world.effects.z = 10
view.height, view.background, view.follow_damping = 18, color("#05030c"), 0.12
view.limits = { -bodies.half - vec(2, 2), bodies.half + vec(2, 2) }

function Night:enter(index)
    local arena = arenas[index]
    for _, name in ipairs { "stones", "gems", "swarm", "shots", "lights" } do world[name]:children():delete() end
    self.arena, self.clock, self.crowd, self.boss, self.rest, self.curtain = index, 0, 0, false, 0, 1
    self:tween("curtain", 0, 0.7)
    world.ground.sprite.image, world.hero.light.tint, world.edge.color = arena.ground, arena.glow, arena.edge
    world.hero.position, view.center = vec(0, 0), vec(0, 0)
    bodies.refresh()
    for _ = 1, 44 do
        local at, size = vec(random(-1.0, 1.0) * bodies.half.x, random(-1.0, 1.0) * bodies.half.y) * 0.95, random(1.8, 3.0)
        if at:length() > 5 then
            world.stones:add(Body { type = "static", position = at, z = -0.01 * at.y, bodies.disc(size * 0.2, bodies.STONE, bodies.SOLID),
                bodies.look(tostring(index), size, size * 0.3, "props", 3, 1) })
        end
    end
    effects.banner(arena.title, arena.goal)
end

world.hero = Hero { bodies.disc(0.36, bodies.HERO, bodies.SOLID, false, 30), look = bodies.look("17-20", 1.35, 0.2),
    light = Sprite { image = "art/glow.png", size = vec(17, 17), blend = "add", z = -40 } }
view.follow = world.hero

local function reset()
    local hero = world.hero
    hero.hp, hero.max_hp, hero.mercy, hero.dash, hero.wait, hero.xp, hero.level = 100, 100, 0, 0, 0, 0, 1
    world.arms:each("Arm", function(arm) arm.level, arm.wait = 0, 0.5 end)
    night:enter(night.first)
end

function Night:begin()
    reset()
    self.score, self.kills, self.rank, self.running, self.menu, world.arms.sparks.level = 0, 0, 0, true, "", 1
    local gifts = 8 * (self.first - 1) + math.min(self.lost, 6)            -- who begins later, or has lost, begins with gifts
    for _ = 1, gifts do arms.take(arms.offer()[1]) end
    if gifts > 0 then effects.banner(arenas[self.first].title, gifts .. (gifts > 1 and " gifts" or " gift") .. " to begin with") end
end

function Night:finish(won)                       -- keeps the eight best scores
    local rows, mine = store.scores or {}, { score = self.score, arena = self.arena, kills = self.kills, won = won }
    self.running, self.won, self.rank, self.menu, self.lost = false, won, 1, "", won and 0 or self.lost + 1
    while rows[self.rank] and rows[self.rank].score >= self.score do self.rank = self.rank + 1 end
    table.insert(rows, self.rank, mine)
    store.scores = table.move(rows, 1, 8, 1, {})
    after(1.4, function() night.menu = "over" end)
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
        enemies.spawn_due(dt)
        if self.clock >= arenas[self.arena].length and not self.boss then enemies.boss() end
    elseif self.rest > dt then
        self.rest = self.rest - dt
    elseif self.arena < #arenas then
        world.hero.hp = math.min(world.hero.max_hp, world.hero.hp + 40)
        self:enter(self.arena + 1)
    else
        self.score = self.score + 50 * math.floor(world.hero.hp)
        self:finish(true)
    end
end

function start()
    night.first = store.unlocked or 1
    reset()
    game:add(scene.load("display.json"), "display")
    night:watch("menu", menu.opened)
    night.menu, night.said = "title", -9.0
    for i = 1, 50 do enemies.spawn(({ "shade", "shade", "moth", "spitter", "brute" })[i % 5 + 1], bodies.toward(i * 2.4, 9 + i % 5)) end
end

function step()
    bodies.refresh()
    play_music(bodies.count)
end

update, draw = menu.update, menu.draw
