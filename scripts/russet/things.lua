-- What a map has in its object layer. A method `touch` is called while the cub overlaps the thing; `reach` is half of its size.
local fx = require("fx")
class("Start", Object) { position = vec(0, 0) }
class("Thing", Sprite) { smooth = false, pixels_per_unit = 16, reach = vec(0.45, 0.45) }
function Thing:overlaps(hero)
    local d, r = self.position - hero.position, self.reach
    return math.abs(d.x) < r.x + 0.33 and math.abs(d.y) < r.y + 0.5
end
class("Coin", Thing) { image = "art/coin.png", columns = 6, frames_per_second = 10 }
function Coin:touch()
    coins, game.scene.coins = coins + 1, game.scene.coins + 1
    game.scene:score(10)
    sounds.coin:play { pitch = 1 + 0.05 * (coins % 4) }
    fx.puff(self.position, { color("#ffe9a0"), color("#ffcf4a00") }, 8, { gravity = vec(0, 0), blend = "add" })
    if coins % 50 == 0 then
        lives = lives + 1 fx.pop(self.position, "1 UP", "power", color("#8ef0a0"))
    end
    self:delete()
end
class("Heart", Thing) { image = "art/heart.png" }
function Heart:touch()
    hearts, points = math.min(3, hearts + 1), points + 50
    fx.pop(self.position, "+1", "power", color("#ff9a8a"))
    self:delete()
end
class("Key", Thing) { image = "art/key.png", taken = false }
function Key:touch(hero)
    if self.taken then return end
    self.taken, hero.key = true, true
    fx.pop(self.position, "Key!", "power", color("#ffcf4a"))
end
function Key:step()
    local hero = game.scene.hero
    if self.taken then self.position = self.position + (hero.position + vec(-0.8 * hero.facing, 0.7) - self.position) * 0.12 end
end
-- What is solid: bodies with a picture of the same size.
local function solid(self, name, density)
    self.home = vec(self.position)
    self:add(Box { width = self.size.x - 0.02, height = self.size.y - 0.02, density = density, friction = 0.4, visible = false }, "box")
    self:add(Sprite { image = "art/" .. name .. ".png", smooth = false, size = self.size }, "look")
end
class("Door", Body) { type = "static", size = vec(1, 3), home = vec(0, 0) }
function Door:ready() solid(self, "door", 1) end
function Door:step()
    local hero = game.scene.hero
    if self.box.sensor or not hero.key or (hero.position - self.position):length() > 2.2 then return end
    self.box.sensor, hero.key = true, false
    for _, key in ipairs(self.parent:children("Key")) do if key.taken then key:delete() end end
    self.look:tween("position", vec(0, 3), 0.6, "in_quad")
    self.look:tween("tint", color("#ffffff00"), 0.6)
    game.scene:score(200, self.position)
    sounds.door:play() view:shake(0.1, 0.3)
end
-- A platform that goes to (dx, dy) and back in `period` seconds.
class("Lift", Body) { type = "kinematic", size = vec(2, 0.5), dx = 0.0, dy = 0.0, period = 4.0, home = vec(0, 0) }
function Lift:ready() solid(self, "lift", 1) end
function Lift:step(dt)
    local part = 0.5 - 0.5 * math.cos((game.scene.clock + dt) * 2 * math.pi / self.period)
    self.velocity = (self.home + vec(self.dx, self.dy) * part - self.position) / dt
end
class("Crate", Body) { size = vec(1, 1), home = vec(0, 0), locked_rotation = true }
function Crate:ready() solid(self, "crate", 0.5) end
function Crate:back() self.position, self.velocity = self.home, vec(0, 0) end
function Crate:step() if self.position.y < -3 then self:back() end end
class("Spring", Thing) { image = "art/spring.png", columns = 3, reach = vec(0.45, 0.4) }
function Spring:touch(hero)
    if hero.velocity.y > 1 or hero.position.y < self.position.y then return end
    hero:jump(20.5, true)
    sounds.spring:play()
    self.frame = 2
    self:after(0.12, function(spring) spring.frame = 3 end)
    self:after(0.3, function(spring) spring.frame = 1 end)
end
class("Checkpoint", Thing) { image = "art/flag.png", columns = 5, animation = "1-1", frames_per_second = 8, origin = vec(0.5, 0.25),
    reach = vec(0.4, 1) }
function Checkpoint:touch()
    if self.animation ~= "1-1" then return end
    self.animation, game.scene.respawn = "2-5", self.position + vec(0, 0.3)
    game.scene:score(100)
    fx.pop(self.position, "100", "power")
    fx.puff(self.position + vec(0, 1), { color("#ee8434"), color("#ffcf4a00") }, 20, { speed = 5 })
end
class("Goal", Thing) { image = "art/den.png", columns = 4, frames_per_second = 5, origin = vec(0.5, 1 / 6), reach = vec(0.5, 1), z = -0.5 }
function Goal:touch() game.scene:win() end
-- Enemies. One that is stomped on is gone; from the side it hurts.
class("Enemy", Thing) { reach = vec(0.42, 0.36), way = -1, worth = 50, home = vec(0, 0), age = 0.0, dead = false, z = 1 }
function Enemy:ready() self.home = vec(self.position) end
function Enemy:step(dt) if not self.dead then self:act(dt) end end
function Enemy:touch(hero)
    if self.dead then return end
    if hero.velocity.y > -0.5 or hero.position.y - 0.3 < self.position.y then game.scene:hit(self.position) return end
    self.dead, self.frames_per_second = true, 0
    hero:jump(input.jump.held and 14 or 9, true)
    game.scene:stomp(self)
    self:tween("size", vec(self.image_width / self.columns / 16 * 1.3, 0.2), 0.08)
    self:tween("tint", color("#ffffff00"), 0.35)
    self:after(0.4, self.delete)
end
class("Beetle", Enemy) { image = "art/beetle.png", columns = 4, frames_per_second = 8, flip_x = true, origin = vec(0.5, 0.53) }
function Beetle:act(dt)
    local level, by = game.scene, vec(self.way * 1.7 * dt, 0)
    local ahead = self.position + by + vec(self.way * 0.5, 0)
    if level:solid(ahead) or not level:solid(ahead - vec(0, 0.8)) then by, self.way = vec(0, 0), -self.way end
    self.position, self.flip_x = self.position + by, self.way < 0
end
class("Bat", Enemy) { image = "art/bat.png", columns = 4, frames_per_second = 11, worth = 80 }
function Bat:act(dt)
    self.age = self.age + dt
    self.position = self.home + vec(2.6 * math.sin(self.age * 1.15), 0.75 * math.sin(self.age * 2.6))
    self.flip_x = math.cos(self.age * 1.15) < 0
end
class("Hopper", Enemy) { image = "art/hopper.png", columns = 3, worth = 80, up = 0.0, rest = 1.0, origin = vec(0.5, 0.45) }
function Hopper:act(dt)
    local at, home = vec(self.position), self.home
    self.rest = self.rest - dt
    if self.up == 0 and at.y <= home.y then
        self.frame = self.rest < 0.3 and 2 or 1
        if self.rest > 0 then return end
        self.way = at.x > home.x + 0.3 and -1 or at.x < home.x - 0.3 and 1 or -self.way
        self.up = 9.5
    end
    self.frame, self.up = 3, self.up - 24 * dt
    at = at + vec(self.way * 2.2 * dt, self.up * dt)
    if game.scene:solid(at + vec(self.way * 0.45, 0)) then at.x = self.position.x end
    if at.y <= home.y then at.y, self.up, self.rest = home.y, 0.0, 0.9 end
    self.position = at
end
