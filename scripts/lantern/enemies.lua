-- Enemies walk to the hero, push each other, and drop gems. Bosses rush, and shoot in rings.
local bodies, effects, arenas = require "bodies", require "effects", require "arenas"
local enemies, tau = {}, 2 * math.pi
local kinds = {
    shade = { hp = 2, speed = 2.3, damage = 8, worth = 1, radius = 0.36, size = 1.15, frames = "1-4", color = color("#9a7cf0") },
    moth = { hp = 1, speed = 4.1, damage = 5, worth = 1, radius = 0.27, size = 1, frames = "5-8", color = color("#ff8cc8") },
    brute = { hp = 14, speed = 1.7, damage = 16, worth = 5, radius = 0.62, size = 1.9, frames = "9-12", color = color("#ff7a70") },
    spitter = { hp = 4, speed = 2.4, damage = 6, worth = 2, radius = 0.36, size = 1.15, frames = "13-16", color = color("#7af0be") },
}
local gem_colors = { color("#5ef2c4"), color("#5ab8ff"), color("#ff9f5a"), color("#ff6fa8") }

Enemy = class("Enemy", Body) { kind = "", hp = 1.0, speed = 2.0, damage = 5, worth = 1, turn = 0, charge = 0.0, locked_rotation = true }
Boss = class("Boss", Enemy) { kind = "brute", max_hp = 1.0, speed = 2.2, way = vec(0, 0) }
Gem = class("Gem", Body) { type = "static", worth = 1, flying = false, z = -50 }
Orb = class("Orb", Body) { type = "kinematic", z = 5 }

local function hidden_place()                    -- in the arena, and out of sight
    for _ = 1, 30 do
        local at = bodies.hero_at + bodies.toward(random() * tau, view.width * (0.56 + 0.12 * random()))
        if math.abs(at.x) < bodies.half.x - 1 and math.abs(at.y) < bodies.half.y - 1 then return at end
    end
    return bodies.hero_at * -0.9
end

function enemies.spawn(name, at)
    local kind = kinds[name]
    night.crowd = night.crowd + 1
    local enemy = world.swarm:add(Enemy {
        kind = name, hp = kind.hp * arenas[night.arena].toughness, speed = kind.speed * (0.9 + 0.2 * random()), damage = kind.damage,
        worth = kind.worth, turn = random(0, 7), position = at or hidden_place(), charge = 1 + 2 * random(),
        bodies.disc(kind.radius, bodies.ENEMY, bodies.SOLID), look = bodies.look(kind.frames, kind.size, 0.16 * kind.size) })
    enemy.look.frame = random(4)
end

function enemies.spawn_due(dt)                   -- those whose waves say that they come in this step
    for _, wave in ipairs(arenas[night.arena]:children()) do
        local part = (night.clock - wave.from) / (wave.to - wave.from)
        local due = (wave.first + (wave.last - wave.first) * part) * dt
        for _ = 1, part >= 0 and part < 1 and math.floor(due + random()) or 0 do
            if night.crowd < arenas[night.arena].cap then enemies.spawn(wave.kind) end
        end
    end
end

function Enemy:step(dt)
    local at, to = self.position, bodies.hero_at - self.position
    local far = to:length() + 0.01
    local want = to * (self.speed / far)
    if not night.running then                    -- they dance round the light
        want = (vec(-to.y, to.x) * 0.8 + to * (far > 9 and 0.5 or -0.6)) * (self.speed / far)
    elseif self.kind == "moth" then
        want = want + vec(-want.y, want.x) * (0.9 * math.sin(bodies.now * 3 + self.turn))
    elseif self.kind == "spitter" then
        want = far < 6.5 and want * -0.6 or far < 8 and vec(-want.y, want.x) or want
        self.charge = self.charge - dt
        if self.charge < 0 and far < 11 then
            self.charge = 2.6
            enemies.shoot(at, to * (4.5 / far))
        end
    end
    self.velocity = self.velocity:lerp(want, 0.12)
    if (bodies.count + self.turn) % 8 ~= 0 then return end
    self.look.flip_x, self.z = to.x < 0, -0.01 * at.y
    if far > 24 and night.running then self.position = hidden_place() end
end

function Enemy:hurt(damage, push)
    if not night.running then return end
    self.hp = self.hp - damage
    effects.number(self.position, damage)
    if self.hp <= 0 then return self:die() end
    self.velocity, self.look.scale = self.velocity + push * (0.36 / self.circle.radius) ^ 2, 1.3
    self.look:tween("scale", 1, 0.15)
    sounds.hit:play { pitch = 0.9 + 0.2 * random() }
end

function Enemy:die()
    night.crowd, night.kills, night.score = night.crowd - 1, night.kills + 1, night.score + 10 * self.worth * night.arena
    effects.burst(self.position, kinds[self.kind].color, 4 + self.worth)
    sounds.pop:play { pitch = 0.8 + 0.4 * random() }
    enemies.drop(self.position, random() < 0.02 and world.hero.hp < 0.7 * world.hero.max_hp and 0 or self.worth)
    self:delete()
end

-- Worth 0 is a heart. When many gems lie there, one of them takes up the new one.
function enemies.drop(at, worth)
    local gems = world.gems:children()
    local old = worth > 0 and #gems > 300 and gems[random(#gems)]
    if old and old.worth > 0 then old.worth = old.worth + worth return end
    local gem = world.gems:add(Gem { position = at, worth = worth, bodies.disc(0.3, bodies.GEM, bodies.HERO, true),
        look = bodies.look(worth == 0 and "28" or "25", worth == 0 and 0.8 or 0.55 + 0.05 * math.min(worth, 6)) })
    if worth > 0 then gem.look.tint = gem_colors[worth < 2 and 1 or worth < 5 and 2 or worth < 20 and 3 or 4] end
end

function Gem:fly() self.type, self.flying = "kinematic", true end
function Gem:step()
    if not self.flying then return end
    local to = bodies.hero_at - self.position
    self.velocity = self.velocity:lerp(to:normalized() * 16, 0.2)
    if to:length() > 0.6 then return end
    world.hero:take(self.worth)
    self:delete()
end

function enemies.shoot(at, velocity)
    world.shots:add(Orb { position = at, velocity = velocity, bodies.disc(0.24, bodies.SHOT, bodies.HERO, true), look = bodies.look("27", 1) })
end
function Orb:ready() self:after(6, function(orb) orb:delete() end) end
function Orb:sensor_begin(event) return event.other == world.hero and event.other:hurt(10) and self:delete() end

function enemies.boss()
    local arena = arenas[night.arena]
    night.boss, night.crowd = true, night.crowd + 1
    world.swarm:add(Boss { hp = arena.boss_hp, max_hp = arena.boss_hp, damage = 10 + 5 * night.arena, position = hidden_place(),
        bodies.disc(1.3, bodies.ENEMY, bodies.SOLID - bodies.STONE, false, 8),
        look = bodies.look(tostring(night.arena), 3.8, 0.3, "bosses", 3, 1) }, "boss")
    sounds.roar:play()
    effects.banner(arena.boss, "appears")
end

-- It hunts, aims, rushes, and then shoots a ring; `charge` is the time since it began to hunt.
function Boss:step(dt)
    local at, now, hunt, to = self.position, self.charge + dt, self.hp < 0.5 * self.max_hp and 1.6 or 2.4, bodies.hero_at - self.position
    self.charge, self.z = now, -0.01 * at.y
    if now < hunt then
        self.velocity = self.velocity:lerp(to:normalized() * self.speed, 0.08)
        for i = 1, night.arena == 3 and bodies.count % 14 == 0 and 3 or 0 do
            enemies.shoot(at, bodies.toward(bodies.now * 1.7 + i * tau / 3, 4.2))
        end
    elseif now < hunt + 0.65 then
        self.way, self.velocity, self.look.tint = to:normalized(), self.velocity * 0.85, color("#ff9d8a")
    elseif now < hunt + 1.35 then
        if now - dt < hunt + 0.65 then sounds.roar:play() end
        self.velocity = self.way * (11 + 2 * night.arena)
    else
        self.charge, self.look.tint = 0, color("white")
        for i = 1, 8 + 4 * night.arena do enemies.shoot(at, bodies.toward(i * tau / (8 + 4 * night.arena), 4)) end
        for i = 1, night.arena == 2 and 8 or 0 do enemies.spawn("shade", at + bodies.toward(i * tau / 8, 2.5)) end
    end
end

function Boss:die()
    night.score = night.score + 2000 * night.arena
    for _ = 1, 24 do enemies.drop(self.position + bodies.toward(random() * tau, 2.5 * random()), 3 * night.arena) end
    effects.burst(self.position, color("#ffd166"), 60)
    effects.ring(self.position, 9, color("#ffd166"))
    if settings.shake then view:shake(0.6, 1) end
    sounds.boom:play()
    self:delete()
    after(0.01, enemies.cleared)                 -- not while others are still being hurt
end

return enemies
