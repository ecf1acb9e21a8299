-- What a map has in its object layer. A class with `touch` is told when the cub overlaps it; `reach` is half of its size.

local fx = require("fx")

class("Start", Object) { position = vec(0, 0) }

class("Thing", Sprite) { smooth = false, pixels_per_unit = 16, reach = vec(0.45, 0.45) }
function Thing:overlaps(hero)
    local d, r = self.position - hero.position, self.reach
    return math.abs(d.x) < r.x + 0.33 and math.abs(d.y) < r.y + 0.5
end

class("Coin", Thing) { image = "art/coin.png", columns = 6, frames_per_second = 10 }
function Coin:touch()
    coins = coins + 1
    game.scene.coins = game.scene.coins + 1
    game.scene:score(10)
    sounds.coin:play { pitch = 1 + 0.05 * (coins % 4) }
    fx.puff(self.position, { color("#ffe9a0"), color("#ffcf4a00") }, 8, { gravity = vec(0, 0), blend = "add" })
    if coins % 50 == 0 then
        lives = lives + 1
        fx.pop(self.position, "1 UP", color("#8ef0a0"))
        sounds.power:play()
    end
    self:delete()
end

class("Heart", Thing) { image = "art/heart.png" }
function Heart:touch()
    hearts = math.min(3, hearts + 1)
    game.scene:score(50)
    fx.pop(self.position, "+1", color("#ff9a8a"))
    sounds.power:play()
    self:delete()
end

class("Key", Thing) { image = "art/key.png", taken = false }
function Key:touch(hero)
    if self.taken then return end
    self.taken, hero.key = true, true
    sounds.power:play { pitch = 1.3 }
    fx.pop(self.position, "Key!", color("#ffcf4a"))
end
function Key:step()
    local hero = game.scene.hero
    if not self.taken or not hero then return end
    self.position = self.position + (hero.position + vec(-0.8 * hero.facing, 0.7) - self.position) * 0.12
end

class("Door", Body) { type = "static", size = vec(1, 3), open = false }
function Door:ready()
    self:add(Box { width = 1, height = 3, visible = false }, "box")
    self:add(Sprite { image = "art/door.png", smooth = false, size = vec(1, 3) }, "look")
end
function Door:step()
    local hero = game.scene.hero
    if self.open or not hero or (hero.position - self.position):length() > 2.2 then return end
    if not hero.key then return end
    self.open, hero.key = true, false
    for _, key in ipairs(self.parent:children("Key")) do if key.taken then key:delete() end end
    self.box.sensor = true
    self.look:tween("position", vec(0, 3), 0.6, "in_quad")
    self.look:tween("tint", color("#ffffff00"), 0.6)
    game.scene:score(200, self.position)
    sounds.door:play()
    view:shake(0.1, 0.3)
end

class("Spring", Thing) { image = "art/spring.png", columns = 3, reach = vec(0.45, 0.4), frame = 1 }
function Spring:touch(hero)
    if hero.velocity.y > 1 or hero.position.y < self.position.y then return end
    hero:jump(20.5, true)
    sounds.spring:play()
    self.frame = 2
    self:after(0.12, function(spring) spring.frame = 3 end)
    self:after(0.3, function(spring) spring.frame = 1 end)
end

-- A platform that goes to (dx, dy) and back in `period` seconds.
class("Lift", Body) { type = "kinematic", size = vec(2, 0.5), dx = 0.0, dy = 0.0, period = 4.0, home = vec(0, 0) }
function Lift:ready()
    self.home = vec(self.position)
    self:add(Box { width = 2, height = 0.5, friction = 0.9, visible = false })
    self:add(Sprite { image = "art/lift.png", smooth = false, size = vec(2, 0.5) })
end
function Lift:step(dt)
    local part = 0.5 - 0.5 * math.cos((game.scene.clock + dt) * 2 * math.pi / self.period)
    self.velocity = (self.home + vec(self.dx, self.dy) * part - self.position) / dt
end

class("Crate", Body) { size = vec(1, 1), home = vec(0, 0), locked_rotation = true }
function Crate:ready()
    self.home = vec(self.position)
    self:add(Box { width = 0.98, height = 0.98, density = 0.5, friction = 0.3, rounding = 0.0, visible = false })
    self:add(Sprite { image = "art/crate.png", smooth = false, size = vec(1, 1) })
end
function Crate:back() self.position, self.velocity = self.home, vec(0, 0) end
function Crate:step() if self.position.y < -3 then self:back() end end

class("Checkpoint", Thing) { image = "art/flag.png", columns = 5, animation = "1-1", frames_per_second = 8, origin = vec(0.5, 0.25),
    reach = vec(0.4, 1), reached = false }
function Checkpoint:touch()
    if self.reached then return end
    self.reached, self.animation, game.scene.respawn = true, "2-5", self.position + vec(0, 0.3)
    game.scene:score(100, self.position)
    sounds.power:play { pitch = 0.8 }
    fx.puff(self.position + vec(0, 1), { color("#ee8434"), color("#ffcf4a00") }, 20, { speed = 5 })
end

class("Goal", Thing) { image = "art/den.png", columns = 4, frames_per_second = 5, origin = vec(0.5, 1 / 6), reach = vec(0.5, 1), z = -0.5 }
function Goal:touch() game.scene:win() end

-- Enemies. One that is stomped on is gone; from the side it hurts.
class("Enemy", Thing) { reach = vec(0.42, 0.36), way = -1, worth = 50, home = vec(0, 0), age = 0.0, dead = false, z = 1 }
function Enemy:ready() self.home = vec(self.position) end
function Enemy:touch(hero)
    if self.dead then return end
    if hero.velocity.y < -0.5 and hero.position.y - 0.3 > self.position.y then self:stomped(hero)
    else game.scene:hit(self.position) end
end
function Enemy:stomped(hero)
    self.dead, self.frames_per_second = true, 0
    hero:jump(input.jump.held and 14 or 9, true)
    game.scene:stomp(self)
    self:tween("size", vec(self.image_width / self.columns / 16 * 1.3, 0.2), 0.08)
    self:tween("tint", color("#ffffff00"), 0.35)
    self:after(0.4, self.delete)
end
-- Whether the way is free: no wall ahead and ground below.
function Enemy:may_walk(by)
    local level, at = game.scene, self.position + vec(self.way * 0.5 + by, 0)
    return not level:solid(at) and level:solid(at - vec(0, 0.8))
end

class("Beetle", Enemy) { image = "art/beetle.png", columns = 4, frames_per_second = 8, flip_x = true, origin = vec(0.5, 0.53) }
function Beetle:step(dt)
    if self.dead then return end
    local by = self.way * 1.7 * dt
    if not self:may_walk(by) then self.way = -self.way self.flip_x = self.way < 0 return end
    self.position = self.position + vec(by, 0)
end

class("Bat", Enemy) { image = "art/bat.png", columns = 4, frames_per_second = 11, worth = 80 }
function Bat:step(dt)
    if self.dead then return end
    self.age = self.age + dt
    local old = self.position.x
    self.position = self.home + vec(2.6 * math.sin(self.age * 1.15), 0.75 * math.sin(self.age * 2.6))
    self.flip_x = self.position.x < old
end

class("Hopper", Enemy) { image = "art/hopper.png", columns = 3, worth = 80, up = 0.0, rest = 1.0, origin = vec(0.5, 0.45) }
function Hopper:step(dt)
    if self.dead then return end
    local at, level = vec(self.position), game.scene
    self.rest = self.rest - dt
    if self.up == 0 and self.position.y <= self.home.y then
        self.frame = self.rest < 0.3 and 2 or 1
        if self.rest > 0 then return end
        self.way = at.x > self.home.x + 0.3 and -1 or at.x < self.home.x - 0.3 and 1 or -self.way
        self.up = 9.5
    end
    self.frame, self.up = 3, self.up - 24 * dt
    at = at + vec(self.way * 2.2 * dt, self.up * dt)
    if level:solid(at + vec(self.way * 0.45, 0)) then at.x = self.position.x end
    if at.y <= self.home.y then at.y, self.up, self.rest = self.home.y, 0.0, 0.9 end
    self.position = at
end
