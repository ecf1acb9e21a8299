-- Weapons and gifts. A weapon fires by itself; its function returns the seconds until it fires again.
local bodies, effects = require "bodies", require "effects"
arms = {}
function arms.level(name) return world.arms[name].level end
local function hurt(enemy, damage, from, push)
    enemy:hurt(damage * (1 + 0.16 * arms.level("might")), (enemy.position - from):normalized() * push)
end
local function hurt_all(at, radius, damage, push)
    for _, enemy in ipairs(bodies.around(at, radius, bodies.ENEMY)) do hurt(enemy, damage, at, push) end
end
local function random_enemies(radius, count)     -- up to so many enemies nearby, chosen by chance
    local near, chosen = bodies.around(bodies.hero_at, radius, bodies.ENEMY), {}
    for i = 1, math.min(count, #near) do chosen[i] = table.remove(near, random(#near)) end
    return chosen
end

-- A spark, or a firefly, which hurts any number of enemies.
Spark = class("Spark", Body) { type = "kinematic", damage = 1.0, pierce = 0, z = 4 }

function Spark:sensor_begin(event)
    if not self:alive() or not event.other:alive() then return end
    hurt(event.other, self.damage, bodies.hero_at, 4)
    if self.pierce == 0 then self:delete() else self.pierce = self.pierce - 1 end
end

local function sparks(level)
    local near, count = world:closest(bodies.hero_at, 11, bodies.ENEMY), 1 + level // 2
    if not near then return 0.1 end
    for i = 1, count do
        local way = (near.body.position - bodies.hero_at):normalized():rotated(0.16 * (i - (count + 1) / 2))
        world.shots:add(Spark { position = bodies.hero_at, velocity = way * 15, angle = way:angle(), pierce = level // 2, damage = 1 + 0.45 * level,
            bodies.disc(0.26, bodies.SHOT, bodies.ENEMY, true), look = bodies.look("26", 1) }):after(0.9, function(spark) spark:delete() end)
    end
    sounds.shot:play { pitch = 0.95 + 0.1 * random() }
    return 0.62 - 0.06 * level
end

local function orbit(level)
    for _ = #world.lights:children(), level do
        world.lights:add(Spark { position = bodies.hero_at, pierce = 1000000000, bodies.disc(0.42, bodies.SHOT, bodies.ENEMY, true),
            look = bodies.look("", 1.3, 0, "flame", 4, 1) }).look.blend = "add"
    end
    for i, fly in ipairs(world.lights:children()) do
        local at = bodies.hero_at + bodies.toward(bodies.now * 3.4 + 2 * math.pi * i / (level + 1), 2 + 0.2 * level)
        fly.velocity, fly.damage = (at - fly.position) / time.dt, 0.8 + 0.6 * level
    end
    return 0
end

local function nova(level)
    hurt_all(bodies.hero_at, 2.8 + 0.45 * level, 1.2 + 0.9 * level, 10)
    effects.ring(bodies.hero_at, 2.8 + 0.45 * level, color("#ffd98a"))
    sounds.nova:play()
    return 3 - 0.25 * level
end

local function storm(level)
    local from, struck = bodies.hero_at, random_enemies(8.5, 1 + 2 * level)
    for _, enemy in ipairs(struck) do
        local at = vec(enemy.position)
        effects.lightning(from, at)
        hurt(enemy, 2 + level, from, 1)
        from = at
    end
    if #struck > 0 then sounds.zap:play { pitch = 0.9 + 0.2 * random() } end
    return #struck > 0 and 1.7 - 0.17 * level or 0.1
end

local function comet(level)
    for _, enemy in ipairs(random_enemies(10, 1 + level // 2)) do
        local at, radius = vec(enemy.position), 1.7 + 0.25 * level
        effects.comet(at)
        after(0.55, function()
            hurt_all(at, radius, 3 + 2 * level, 7)
            effects.ring(at, radius, color("#8ad0ff"))
            sounds.boom:play { volume = 0.5, pitch = 1.3 }
        end)
    end
    return 2.5 - 0.22 * level
end

local fire = { sparks = sparks, orbit = orbit, nova = nova, storm = storm, comet = comet }

-- A weapon or a gift: its level from 0 to 5, and the seconds until it fires again. Their names and texts are in arms.json.
Arm = class("Arm", Object) { title = "", text = "", level = 0, wait = 0.5 }
world:add(scene.load("arms.json"), "arms")

function Arm:step(dt)
    if self.level == 0 or not night.running or not fire[self.name] then return end
    self.wait = self.wait - dt
    if self.wait <= 0 then self.wait = fire[self.name](self.level) * (1 - 0.09 * arms.level("haste")) end
end

function arms.offer()                            -- up to three names of what can still grow, by chance
    local can = {}
    for _, arm in ipairs(world.arms:children()) do can[#can + 1] = arm.level < 5 and arm.name or nil end
    while #can > 3 do table.remove(can, random(#can)) end
    return can
end

function arms.take(name)
    world.arms[name].level = arms.level(name) + 1
    if name == "heart" then world.hero.max_hp, world.hero.hp = world.hero.max_hp + 20, world.hero.hp + 20 end
end
