-- The cub: how it runs and jumps. Numbers are meters and seconds.
local fx = require("fx")
local run_speed, jump_speed, fall_limit = 7.2, 14.2, 17
local coyote_time, buffer_time = 0.1, 0.13       -- s: how late after a ledge, and how early before landing, a press still jumps
local probe = Circle { radius = 0.3 }            -- what is moved downwards to find the ground
Hero = class("Hero", Body) {
    locked_rotation = true, can_sleep = false, z = 5, bullet = true,
    facing = 1, grounded = false, coyote = 0.0, buffer = 0.0, rising = false, hurt = 0.0, key = false, stretch = 0.0, steps = 0.0,
    doc = { hurt = "Seconds for which nothing hurts it.", rising = "Whether the jump ends when the button is let go.",
        stretch = "How thin it is: above 0 thin, below 0 flat.", key = "Whether it carries a key." },
}
function Hero:ready()
    self:add(Capsule { from = vec(0, -0.2), to = vec(0, 0.2), radius = 0.35, friction = 0, visible = false }, "shape")
    self:add(Sprite { image = "art/fox.png", columns = 11, smooth = false, origin = vec(0.5, 0), position = vec(0, -0.6),
        size = vec(1.5, 1.5), animation = "1-2", frames_per_second = 3 }, "look")
end
-- What it stands on: a record with normal and body, or nil.
function Hero:ground()
    probe.center = self.position - vec(0, 0.1)
    local hit = self.parent:shapecast(probe, vec(0, -0.5), nil, nil, function(shape)
        return not shape or shape.parent ~= self and not shape.sensor
    end)
    if not hit or hit.fraction == 0 or hit.normal.y < 0.5 then return end
    local reach = self.grounded and 0.5 or 0.2
    return hit.fraction * 0.5 < reach and hit or nil
end
function Hero:jump(speed, free)
    self.velocity = vec(self.velocity.x, speed)
    self.grounded, self.coyote, self.buffer, self.rising, self.gravity_scale = false, 0.0, 0.0, not free, 1
    self.stretch = 0.35
    fx.puff(self.position - vec(0, 0.5), { color("#fff1d6c0"), color("#fff1d600") }, 6, { speed = 1.6, gravity = vec(0, 2) })
end
function Hero:step(dt)
    if self.type == "static" then return end     -- at home, or lost
    local v, way = vec(self.velocity), input.move.x
    if math.abs(way) < 0.3 then way = 0 else way = way > 0 and 1 or -1 end
    if self.hurt > 1.1 then way = 0 end          -- thrown back by a hit
    self.hurt, self.coyote, self.buffer = math.max(0, self.hurt - dt), self.coyote - dt, self.buffer - dt
    if input.jump.pressed then self.buffer = buffer_time end
    local ground = self:ground()
    local base = ground and ground.body.type ~= "static" and ground.body.velocity or vec(0, 0)
    if ground and (v.y - base.y > 3 and not self.grounded or self.rising and v.y > 0.5) then ground = nil end
    if ground and not self.grounded and v.y < -6 then
        self.stretch = math.max(-0.4, v.y / 40)
        fx.puff(self.position - vec(0, 0.5), { color("#fff1d6c0"), color("#fff1d600") }, 8, { speed = 2 })
        sounds.land:play { volume = math.min(1, -v.y / 15) }
    end
    self.grounded = ground ~= nil
    local grip = self.hurt > 1.1 and 0.02 or self.parent.number == 4 and (ground and 0.09 or 0.11) or ground and 0.25 or 0.14
    local x = v.x - base.x
    x = x + (way * run_speed - x) * grip
    if math.abs(x) < 0.05 then x = 0 end
    if ground then
        self.coyote, self.rising = coyote_time, false
        local n = ground.normal
        local far = ground.fraction * 0.5 - 0.15     -- how far it is above the ground
        self.gravity_scale = 0
        self.velocity = base + vec(x, -x * n.x / n.y * 0.98) - n * math.max(0.2, math.min(6, far / dt))
    else
        self.gravity_scale = v.y < 0 and 1.15 or 1
        self.velocity = vec(x + base.x, math.max(-fall_limit, v.y))
        if self.rising and not input.jump.held and v.y > 0 then
            self.velocity, self.rising = vec(self.velocity.x, v.y * 0.5), false
        end
    end
    if self.buffer > 0 and self.coyote > 0 then
        self:jump(jump_speed + math.max(0, base.y))
        sounds.jump:play { pitch = 0.95 + 0.1 * random() }
    end
    if way ~= 0 then self.facing = way end
    self:show(way, x, dt)
end
function Hero:show(way, x, dt)
    local look = self.look
    local name, speed = "1-2", 3
    if self.hurt > 1.1 then name = "11-11"
    elseif not self.grounded then name = self.velocity.y > 0 and "9-9" or "10-10"
    elseif math.abs(x) > 0.6 then name, speed = "3-8", 4 + math.abs(x) * 1.6 end
    if look.animation ~= name then look.animation = name end
    look.frames_per_second = speed
    look.flip_x = self.facing < 0
    look.visible = self.hurt == 0 or self.hurt > 1.1 or time.step % 8 < 5
    self.stretch = self.stretch * math.exp(-9 * dt)
    look.size = vec(1.5 * (1 - self.stretch * 0.6), 1.5 * (1 + self.stretch))
    self.steps = self.steps + math.abs(x) * dt
    if self.grounded and self.steps > 1.3 then
        self.steps = 0.0
        fx.puff(self.position - vec(0.3 * self.facing, 0.5), { color("#fff1d690"), color("#fff1d600") }, 2, { speed = 0.8 })
    end
end
