-- The keeper of the lantern: walks, dashes, collects, is hurt.

local common = require "common"
local effects = require "effects"

Hero = class("Hero", Body) {
    hp = 100.0, max_hp = 100.0, mercy = 0.0, dash = 0.0, dash_wait = 0.0, xp = 0, level = 1, way = vec(1, 0),
    locked_rotation = true,
}

local function new_hero()
    return Hero {
        Circle { radius = 0.36, density = 30, friction = 0, category = common.HERO, mask = common.SOLID, visible = false },
        light = Sprite { image = "art/glow.png", size = vec(17, 17), blend = "add", tint = color("#ffb35a30"), z = -40 },
        look = Sprite { image = "art/sheet.png", columns = 8, rows = 4, animation = "17-20", frames_per_second = 6, size = vec(1.35, 1.35),
            position = vec(0, 0.2) },
    }
end

function Hero:need() return 4 + 3 * self.level + self.level * self.level // 6 end

-- Where the player wants to go: keys or a stick, or the pointer while its left button is held.
local function wanted()
    local way = input.move
    if way:length() > 0.05 then return way end
    if input.mouse.left then
        local to = input.mouse.world - common.hero_at
        if to:length() > 0.3 then return to:normalized() end
    end
    return vec(0, 0)
end

function Hero:step(dt)
    self.mercy, self.dash, self.dash_wait = math.max(0, self.mercy - dt), math.max(0, self.dash - dt), math.max(0, self.dash_wait - dt)
    self.z = -0.01 * self.position.y
    local look = self.look
    if not night.running then
        self.velocity = vec(0, 0)
        return
    end
    local way = wanted()
    if way:length() > 0.05 then self.way = way:normalized() end
    if input.dash.pressed and self.dash_wait == 0 then
        self.dash, self.dash_wait, self.mercy = 0.18, 1.4, math.max(self.mercy, 0.3)
        sounds.dash:play()
        effects.ring(self.position, 1.2, color("#ffd98a"))
    end
    if self.dash > 0 then
        self.velocity = self.way * 19
        if common.count % 2 == 0 then effects.burst(self.position, color("#ff9f4a"), 2) end
    else
        self.velocity = self.velocity:lerp(way * 5.2 * (1 + 0.08 * arms.level("swift")), 0.3)
    end
    local frames = way:length() > 0.05 and "21-24" or "17-20"
    if look.animation ~= frames then look.animation = frames end
    if math.abs(way.x) > 0.1 then look.flip_x = way.x < 0 end
    look.tint = (self.mercy > 0 and self.dash == 0 and common.count % 8 < 4) and color("#ff8080") or color("white")
    self.hp = math.min(self.max_hp, self.hp + dt * 0.3 * arms.level("heart"))

    for _, gem in ipairs(common.around(self.position, 1.9 * (1 + 0.4 * arms.level("magnet")), common.GEM)) do gem:fly() end
    if self.mercy == 0 then
        for _, other in ipairs(common.around(self.position, 0.44, common.ENEMY)) do
            if self:hurt(other.damage) then break end
        end
    end
end

-- Whether it was hurt.
function Hero:hurt(damage)
    if self.mercy > 0 or not night.running or night.menu ~= "" then return false end
    self.hp, self.mercy = self.hp - damage, 0.55
    effects.burst(self.position, color("#ff5a6e"), 14)
    sounds.hurt:play()
    if settings.shake then view:shake(0.25, 0.3) end
    if self.hp <= 0 then
        self.hp = 0
        effects.burst(self.position, color("#ffd166"), 60)
        sounds.boom:play()
        common.ended("over")
    end
    return true
end

function Hero:take(worth)
    if worth == 0 then
        self.hp = math.min(self.max_hp, self.hp + 25)
        sounds.heal:play()
        effects.ring(self.position, 2, color("#ff8aa0"))
        return
    end
    night.score = night.score + 2 * worth
    night.streak = time.now - night.streak_at < 0.5 and math.min(night.streak + 1, 14) or 0
    night.streak_at = time.now
    sounds.gem:play { pitch = 2 ^ (night.streak / 12) }
    self.xp = self.xp + worth
    if self.xp >= self:need() and night.menu == "" and night.running then
        self.xp, self.level = self.xp - self:need(), self.level + 1
        sounds.level:play()
        effects.ring(self.position, 4, color("#5ef2c4"))
        for _, enemy in ipairs(common.around(self.position, 3, common.ENEMY)) do
            enemy.velocity = (enemy.position - self.position):normalized() * 9
        end
        common.level_up()
    end
end

return new_hero
