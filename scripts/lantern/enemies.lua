-- Enemies walk to the hero, push each other, and drop gems. Bosses do more.

local effects = require "effects"
local arenas = require "arenas"
local common = require "common"

local tau = 2 * math.pi
local enemies = {}

-- Frames are those of art/sheet.png.
local kinds = {
    shade = { hp = 2, speed = 2.3, damage = 8, worth = 1, radius = 0.36, size = 1.15, frames = "1-4", color = color("#9a7cf0") },
    moth = { hp = 1, speed = 4.1, damage = 5, worth = 1, radius = 0.27, size = 1, frames = "5-8", color = color("#ff8cc8") },
    brute = { hp = 14, speed = 1.7, damage = 16, worth = 5, radius = 0.62, size = 1.9, frames = "9-12", color = color("#ff7a70") },
    spitter = { hp = 4, speed = 2.4, damage = 6, worth = 2, radius = 0.36, size = 1.15, frames = "13-16", color = color("#7af0be") },
}

Enemy = class("Enemy", Body) {
    kind = "shade", hp = 1.0, speed = 2.0, damage = 5, worth = 1, turn = 0, charge = 3.0, locked_rotation = true,
}

-- A place in the arena that is out of sight.
local function hidden_place()
    local at
    for _ = 1, 30 do
        local angle, far = random() * tau, view.width * (0.56 + 0.12 * random())
        at = common.hero_at + vec(math.cos(angle) * far, math.sin(angle) * far)
        if math.abs(at.x) < common.half.x - 1 and math.abs(at.y) < common.half.y - 1 then return at end
    end
    return vec(-common.hero_at.x, -common.hero_at.y) * 0.9
end

function enemies.spawn(name, at)
    local kind = kinds[name]
    night.crowd = night.crowd + 1
    world.swarm:add(Enemy {
        kind = name, hp = kind.hp * arenas[night.arena].toughness, speed = kind.speed * (0.9 + 0.2 * random()), damage = kind.damage,
        worth = kind.worth, turn = random(0, 7), position = at or hidden_place(), charge = 1 + 2 * random(),
        Circle { radius = kind.radius, category = common.ENEMY, mask = common.SOLID, friction = 0, visible = false },
        look = Sprite { image = "art/sheet.png", columns = 8, rows = 4, animation = kind.frames, frame = random(4), frames_per_second = 7,
            size = vec(kind.size, kind.size), position = vec(0, kind.size * 0.16) },
    })
end

-- Spawns what is due in this step.
function enemies.come(dt)
    local arena = arenas[night.arena]
    for _, wave in ipairs(arena.waves) do
        local kind, from, to, first, last = table.unpack(wave)
        if night.clock >= from and night.clock < to then
            local due = (first + (last - first) * (night.clock - from) / (to - from)) * dt
            while random() < due and night.crowd < arena.cap do
                enemies.spawn(kind)
                due = due - 1
            end
        end
    end
end

function Enemy:step()
    local at = self.position
    local to = common.hero_at - at
    local far = to:length()
    local want = to * (self.speed / (far + 0.01))
    if not night.running then                    -- they dance round the light
        want = (vec(-to.y, to.x) * 0.8 + to * (far > 7 and 0.5 or -0.6)) * (self.speed / (far + 0.01))
    elseif self.kind == "moth" then
        want = want + vec(-want.y, want.x) * (0.9 * math.sin(common.now * 3 + self.turn))
    elseif self.kind == "spitter" then
        if far < 6.5 then want = want * -0.6 elseif far < 8 then want = vec(-want.y, want.x) end
        self.charge = self.charge - common.dt
        if self.charge < 0 and far < 11 then
            self.charge = 2.6
            enemies.shoot(at, to * (4.5 / far))
        end
    end
    self.velocity = self.velocity:lerp(want, 0.12)
    if (common.count + self.turn) % 8 == 0 then
        local look = self.look
        local left = to.x < 0
        if look.flip_x ~= left then look.flip_x = left end
        self.z = -0.01 * at.y
        if far > 24 and night.running then self.position = hidden_place() end
    end
end

function Enemy:hurt(damage, push)
    if not night.running then return end
    self.hp = self.hp - damage
    effects.number(self.position, damage)
    if push then self.velocity = self.velocity + push * (0.36 / self.circle.radius) end
    if self.hp <= 0 then return self:die() end
    self.look.scale = 1.3
    self.look:tween("scale", 1, 0.15)
    sounds.hit:play { pitch = 0.9 + 0.2 * random() }
end

function Enemy:die()
    local kind, at = kinds[self.kind], self.position
    night.crowd = night.crowd - 1
    night.kills = night.kills + 1
    night.score = night.score + 10 * self.worth * night.arena
    effects.burst(at, kind.color, 4 + self.worth)
    sounds.pop:play { pitch = 0.8 + 0.4 * random() }
    if random() < 0.012 and world.hero.hp < 0.7 * world.hero.max_hp then
        enemies.drop(at, 0)
    else
        enemies.drop(at, self.worth)
    end
    self:delete()
end

-- Gems -------------------------------------------------------------------------------------------------------------------------

Gem = class("Gem", Body) { type = "static", worth = 1, flying = false, z = -50 }

local gem_colors = { color("#5ef2c4"), color("#5ab8ff"), color("#ff9f5a"), color("#ff6fa8") }

-- Worth 0 is a heart. When many lie there, an old gem takes up the new one.
function enemies.drop(at, worth)
    local gems = world.gems:children()
    if worth > 0 and #gems > 300 then
        local old = gems[random(#gems)]
        if old.worth > 0 then old.worth = old.worth + worth return end
    end
    local frame, tint = "25", gem_colors[worth < 2 and 1 or worth < 5 and 2 or worth < 20 and 3 or 4]
    if worth == 0 then frame, tint = "28", color("white") end
    local size = worth == 0 and 0.8 or 0.42 + 0.05 * math.min(worth, 6)
    world.gems:add(Gem { position = at, worth = worth,
        Circle { radius = 0.3, sensor = true, category = common.GEM, mask = common.HERO, visible = false },
        look = Sprite { image = "art/sheet.png", columns = 8, rows = 4, animation = frame, size = vec(size, size), tint = tint } })
end

function Gem:step()
    if not self.flying then return end
    local to = common.hero_at - self.position
    local far = to:length()
    if far < 0.6 then
        world.hero:take(self.worth)
        self:delete()
    else
        self.velocity = self.velocity:lerp(to * (16 / far), 0.2)
    end
end

function Gem:fly()
    if self.flying then return end
    self.flying, self.type = true, "kinematic"
    self.velocity = (self.position - common.hero_at) * 4
end

-- Shots of enemies -------------------------------------------------------------------------------------------------------------

Orb = class("Orb", Body) { type = "kinematic", z = 5 }

function enemies.shoot(at, velocity)
    world.shots:add(Orb { position = at, velocity = velocity,
        Circle { radius = 0.24, sensor = true, category = common.SHOT, mask = common.HERO, visible = false },
        look = Sprite { image = "art/sheet.png", columns = 8, rows = 4, animation = "27", size = vec(1, 1) } })
end

function Orb:ready() self:after(6, function(orb) orb:delete() end) end

function Orb:sensor_begin(event)
    if event.other == world.hero and event.other:hurt(10) then self:delete() end
end

local function ring(at, count, speed, turn)
    for i = 1, count do
        local angle = turn + tau * i / count
        enemies.shoot(at, vec(math.cos(angle), math.sin(angle)) * speed)
    end
    sounds.zap:play { pitch = 0.6 }
end

-- Bosses -----------------------------------------------------------------------------------------------------------------------

Boss = class("Boss", Enemy) {
    max_hp = 1.0, way = vec(0, 0), current_state = "hunt",
    states = {
        hunt = {
            enter = function(self) self:after(self.hp < 0.5 * self.max_hp and 1.6 or 2.4, function(b) b:state("aim") end) end,
            step = function(self)
                local to = common.hero_at - self.position
                self.velocity = self.velocity:lerp(to * (self.speed / (to:length() + 0.1)), 0.08)
                if night.arena == 3 and common.count % 14 == 0 then
                    local angle = common.now * 1.7
                    for _, turn in ipairs { 0, tau / 3, 2 * tau / 3 } do
                        enemies.shoot(self.position, vec(math.cos(angle + turn), math.sin(angle + turn)) * 4.2)
                    end
                end
            end,
        },
        aim = {
            enter = function(self)
                self.way = (common.hero_at - self.position):normalized()
                self.look.tint = color("#ff9d8a")
                self:after(0.65, function(b) b:state("rush") end)
            end,
            step = function(self) self.velocity = self.velocity * 0.85 end,
            leave = function(self) self.look.tint = color("white") end,
        },
        rush = {
            enter = function(self)
                sounds.roar:play()
                self:after(0.7, function(b) b:state("hunt") end)
            end,
            step = function(self) self.velocity = self.way * (11 + 2 * night.arena) end,
            leave = function(self)
                ring(self.position, 8 + 4 * night.arena, 4, random() * tau)
                if night.arena == 2 then
                    for i = 1, 8 do
                        local angle = tau * i / 8
                        enemies.spawn("shade", self.position + vec(math.cos(angle), math.sin(angle)) * 2.5)
                    end
                end
            end,
        },
    },
}

function enemies.boss()
    local arena = arenas[night.arena]
    local boss = Boss {
        kind = "brute", hp = arena.boss_hp + 0.0, max_hp = arena.boss_hp + 0.0, speed = 2.2, damage = 22, worth = 200, position = hidden_place(),
        Circle { radius = 1.3, density = 8, category = common.ENEMY, mask = common.SOLID, friction = 0, visible = false },
        look = Sprite { image = "art/bosses.png", columns = 3, animation = tostring(night.arena), size = vec(3.8, 3.8), position = vec(0, 0.3) },
    }
    night.crowd = night.crowd + 1
    world.swarm:add(boss, "boss")
    sounds.roar:play()
    view:shake(0.3, 0.8)
    effects.banner(arena.boss, "appears")
end

function Boss:step() self.z = -0.01 * self.position.y end

function Boss:die()
    local at = self.position
    night.crowd = night.crowd - 1
    night.score = night.score + 2000 * night.arena
    for _ = 1, 24 do
        local angle, far = random() * tau, 2.5 * random()
        enemies.drop(at + vec(math.cos(angle), math.sin(angle)) * far, 3 * night.arena)
    end
    effects.burst(at, color("#ffd166"), 60)
    effects.ring(at, 9, color("#ffd166"))
    view:shake(0.6, 1)
    sounds.boom:play()
    self:delete()
    common.cleared()
end

return enemies
