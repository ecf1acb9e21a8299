-- The keeper of the lantern: walks, dashes, collects, is hurt.
local bodies, effects = require "bodies", require "effects"
Hero = class("Hero", Body) { hp = 100.0, max_hp = 100.0, mercy = 0.0, dash = 0.0, wait = 0.0, xp = 0, level = 1, way = vec(1, 0),
    locked_rotation = true }

function Hero:need() return 4 + 3 * self.level + self.level * self.level // 6 end

local function wanted()                          -- keys or a stick, or to the pointer while its left button is held
    local way, to = input.move, input.mouse.world - bodies.hero_at
    return way:length() > 0.05 and way or input.mouse.left and to:length() > 0.3 and to:normalized() or vec(0, 0)
end

function Hero:step(dt)
    local at, way, look = self.position, night.running and wanted() or vec(0, 0), self.look
    local walks = way:length() > 0.05
    self.mercy, self.dash, self.wait = math.max(0, self.mercy - dt), math.max(0, self.dash - dt), math.max(0, self.wait - dt)
    self.z, look.animation = -0.01 * at.y, walks and "21-24" or "17-20"
    look.visible = self.hp > 0 or night.menu == "title"
    self.light.visible = look.visible
    if walks then self.way, look.flip_x = way:normalized(), way.x < 0 end
    if input.dash.pressed and self.wait == 0 and night.running then
        self.dash, self.wait, self.mercy = 0.18, 1.4, math.max(self.mercy, 0.3)
        sounds.dash:play()
        effects.ring(at, 1.2, color("#ffd98a"))
    end
    self.velocity = self.dash > 0 and self.way * 19 or self.velocity:lerp(way * 5.2 * (1 + 0.08 * arms.level("swift")), 0.3)
    if self.dash > 0 then effects.burst(at, color("#ff9f4a"), 1) end
    look.tint = self.mercy > 0 and self.dash == 0 and bodies.count % 8 < 4 and color("#ff8080") or color("white")
    self.hp = math.min(self.max_hp, self.hp + dt * 0.3 * arms.level("heart"))
    for _, gem in ipairs(bodies.around(at, 1.9 * (1 + 0.4 * arms.level("magnet")), bodies.GEM)) do gem:fly() end
    local enemy = self.mercy == 0 and bodies.around(at, 0.44, bodies.ENEMY)[1]
    if enemy then self:hurt(enemy.damage) end
end

function Hero:hurt(damage)                       -- returns whether it was hurt
    if self.mercy > 0 or not night.running or night.menu ~= "" then return false end
    self.hp, self.mercy = math.max(0, self.hp - damage), 0.55
    effects.burst(self.position, color("#ff5a6e"), self.hp > 0 and 14 or 70)
    sounds[self.hp > 0 and "hurt" or "boom"]:play()
    if settings.shake then view:shake(0.25, 0.3) end
    if self.hp == 0 then night:finish(false) end
    return true
end

function Hero:take(worth)                        -- a gem, or a heart, which is worth 0
    if worth == 0 then self.hp = math.min(self.max_hp, self.hp + 25) return sounds.heal:play() end
    night.streak = bodies.now - night.streak_at < 0.5 and math.min(night.streak + 1, 14) or 0
    night.streak_at, night.score, self.xp = bodies.now, night.score + 2 * worth, self.xp + worth
    sounds.gem:play { pitch = 2 ^ (night.streak / 12) }
    local over = night.rest > 0 and night.arena == 3    -- the last boss is beaten: there is nothing left to choose for
    local offer = self.xp >= self:need() and night.menu == "" and night.running and not over and arms.offer() or {}
    if #offer == 0 then return end
    self.xp, self.level = self.xp - self:need(), self.level + 1
    night.choices, night.menu = offer, "choose"
    sounds.level:play()
    effects.ring(self.position, 4, color("#5ef2c4"))
end
