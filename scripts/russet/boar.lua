-- The last enemy: it charges, runs against a wall, and can be stomped on while it is dizzy.
local fx = require("fx")
class("Rock", Thing) { image = "art/rock.png", reach = vec(0.3, 0.3), speed = 0.0 }
function Rock:touch() game.scene:hit(self.position) end
function Rock:step(dt)
    self.speed = self.speed - 16 * dt
    self.position, self.angle = self.position + vec(0, self.speed * dt), self.angle + 3 * dt
    if self.position.y > 4.3 then return end
    fx.puff(self.position, { color("#b3a6ba"), color("#86798f00") }, 10)
    self:delete()
end
class("Boar", Thing) { image = "art/boar.png", columns = 7, animation = "1-4", frames_per_second = 6, flip_x = true, reach = vec(1.1, 0.75),
    origin = vec(0.5, 0.45), hp = 5, way = -1, left = 0.0, z = 2, current_state = "rest",
    states = {
        rest = { enter = function(self) self:pose("1-4", 3, 0.6 + 0.12 * self.hp) end, step = function(self, dt)
            local hero = game.scene.hero
            if math.abs(hero.position.x - self.position.x) > 0.5 then self.way = hero.position.x < self.position.x and -1 or 1 end
            self.flip_x = self.way < 0
            if hero.position.x > 9.5 and self:waited(dt) then self:state("brace") end
        end },
        brace = { enter = function(self) self:pose("5-6", 14, 0.45 + 0.06 * self.hp) sounds.growl:play() end, step = function(self, dt)
            view:shake(0.03, 0.1)
            if self:waited(dt) then self:state("charge") end
        end },
        charge = { enter = function(self) self:pose("1-4", 18, 0) end, step = function(self, dt)
            self.position = self.position + vec(self.way * (15 - 1.1 * self.hp) * dt, 0)
            if time.step % 4 == 0 then fx.puff(self.position - vec(self.way, 0.8), { color("#fff1d690"), color("#fff1d600") }, 4, { speed = 2 }) end
            if game.scene:solid(self.position + vec(self.way * 1.5, 0)) then self:state("stun") end
        end },
        stun = { enter = function(self)
            self:pose("7-7", 0, 2.2 + 0.15 * self.hp)
            view:shake(0.4, 0.5)
            sounds.crash:play()
            for n = 1, 7 - self.hp do
                self:after(0.3 * n, function(boar)
                    boar.parent:add(Rock { position = vec(game.scene.hero.position.x + random(-4.0, 4.0), 16) })
                end)
            end
        end, step = function(self, dt)
            if time.step % 12 == 0 then fx.puff(self.position + vec(self.way * 0.8, 1.2), { color("#ffcf4a"), color("#ffcf4a00") }, 3) end
            if self:waited(dt) then self:state("rest") end
        end },
        dead = { step = function(self, dt) self.position, self.angle = self.position - vec(0, 4 * dt), self.angle + 2 * dt end },
    } }
function Boar:draw(pen) for i = 1, self.hp do pen.image("art/heart.png", self:drawn_position() + vec(0.55 * i - 1.65, 1.75), 0.45) end end
function Boar:pose(animation, speed, seconds) self.animation, self.frames_per_second, self.left = animation, speed, seconds end
function Boar:waited(dt)
    self.left = self.left - dt
    return self.left <= 0
end
function Boar:touch(hero)
    if self:state() == "dead" then return end
    local stunned = self:state() == "stun"
    if hero.velocity.y > -0.5 or hero.position.y < self.position.y + 0.5 then return not stunned and game.scene:hit(self.position) end
    hero:jump(11, true)
    hero.velocity = vec(self.position.x > 21 and -6 or 6, 11)
    if not stunned then sounds.clang:play() return end
    self.hp = self.hp - 1
    game.scene:score(300, self.position + vec(0, 1))
    sounds.stomp:play { pitch = 0.7 }
    view:shake(0.25, 0.3)
    fx.puff(self.position, { color("#ffe9a0"), color("#d8434e00") }, 30, { speed = 8 })
    if self.hp > 0 then self:state("rest") return end
    self:state("dead")
    sounds.crash:play { pitch = 0.7 }
    self:tween("tint", color("#ffffff00"), 2)
    game.scene:after(2.5, function(level) level:win() end)
end
