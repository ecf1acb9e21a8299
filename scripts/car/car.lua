-- The car: a chassis on two sprung wheels, each driven by a motor.

local car = {}

local paint, paint_edge = color("#e5484d"), color("#7a1f24")
local tire, tire_edge = color("#23252d"), color("#0e0f13")

local function add_wheel(self, name, x)
    local place = vec(x, -0.42)
    self[name] = Body {
        position = self.chassis:to_world(place), angular_damping = 0.2,
        Circle { radius = 0.44, density = 1.1, friction = 1.6, color = tire, border = tire_edge },
    }
    self[name .. "_axle"] = WheelJoint {
        body_a = self.chassis, body_b = self[name], anchor_a = place,
        hertz = 4.5, damping_ratio = 0.75, lower_translation = -0.28, upper_translation = 0.22,
    }
end

function car.make(parent, position)
    parent.car = Object {
        throttle = 0.0,        -- -1 … 1, what the pedals want
        top_speed = 18.0,      -- m/s
        torque = 16.0,         -- N m at each wheel
        brake = 34.0,          -- N m
        air_control = 9.0,     -- N m, leaning while no wheel touches
        balance = 14.0,        -- N m/rad, with which it rights itself in the air
        coins = 0,
    }
    local self = parent.car
    self.chassis = Body {
        position = position, bullet = true,
        Polygon {  -- body
            vertices = { vec(-1.55, -0.28), vec(1.5, -0.28), vec(1.62, 0.02), vec(1.35, 0.2), vec(-1.5, 0.26), vec(-1.62, 0) },
            density = 1.6, friction = 0.4, color = paint, border = paint_edge,
        },
        Polygon {  -- cabin
            vertices = { vec(-1.05, 0.22), vec(0.75, 0.2), vec(0.2, 0.68), vec(-0.72, 0.68) },
            density = 0.5, friction = 0.4, color = paint, border = paint_edge,
        },
    }
    self.chassis.center = vec(0, -0.12)
    add_wheel(self, "back", -1.02)
    add_wheel(self, "front", 1.02)
    return self
end

local function touches_ground(self)
    return #self.back.contacts > 0 or #self.front.contacts > 0
end

--- What the pedals do, each step.
function car.drive(self)
    local chassis, throttle = self.chassis, self.throttle
    local along = chassis.velocity:dot(vec(math.cos(chassis.angle), math.sin(chassis.angle)))
    local braking = throttle ~= 0 and along * throttle < -1
    for _, axle in ipairs({ self.back_axle, self.front_axle }) do
        axle.motor_speed = braking and 0 or -throttle * self.top_speed / 0.44
        axle.max_motor_torque = braking and self.brake or throttle ~= 0 and self.torque or 0.6
    end
    if not touches_ground(self) then
        local tilt = math.sin(chassis.angle)
        chassis:apply_torque(self.air_control * throttle - self.balance * tilt - 3 * chassis.angular_velocity)
    end
end

-- --- What is drawn over it ----------------------------------------------------------------------------------------

local glass, shine = color(0.75, 0.9, 1, 0.75), color(1, 1, 1, 0.35)
local rim, spoke, lamp = color("#b9bec9"), color("#6d7280"), color("#ffe9a8")

function car.draw(pen, self)
    local chassis = self.chassis
    local function at(x, y) return chassis:to_drawn(vec(x, y)) end
    pen.polygon({ at(-0.88, 0.27), at(-0.28, 0.27), at(-0.28, 0.6), at(-0.64, 0.6) }, glass)
    pen.polygon({ at(-0.18, 0.27), at(0.52, 0.26), at(0.13, 0.6), at(-0.18, 0.6) }, glass)
    pen.line(at(-1.5, 0.1), at(1.5, 0.06), shine, 2)
    pen.polygon({ at(1.44, 0.14), at(1.36, 0.02), at(1.6, -0.02) }, lamp)
    for _, name in ipairs({ "back", "front" }) do
        local wheel = self[name]
        local hub, turned = wheel:drawn_position(), wheel:drawn_angle()
        pen.circle(hub, 0.25, rim)
        for i = 0, 4 do
            local angle = turned + i * 2 * math.pi / 5
            pen.line(hub, hub + vec(0.23, 0):rotated(angle), spoke, 2.5)
        end
        pen.circle(hub, 0.07, spoke)
    end
end

return car
