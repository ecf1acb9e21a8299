-- A doll of eleven bones and ten pins. Its measures are meters of a doll 1.6 m tall, standing at the origin.

local doll = {}

-- name, parent, y of the body, ends of its capsule, radius, y of the pin, limits (of half a turn), friction of the pin
local bones = {
    { "hip", nil, 0.95, -0.02, 0.02, 0.095 },
    { "torso", "hip", 1.2, -0.135, 0.135, 0.09, 1.0, -0.25, 0, 0.5 },
    { "head", "torso", 1.475, -0.038, 0.039, 0.075, 1.4, -0.3, 0.1, 0.25, air = 0.1 },
    { "left_thigh", "hip", 0.775, -0.125, 0.125, 0.06, 0.9, -0.05, 0.4, 1 },
    { "left_shin", "left_thigh", 0.475, -0.155, 0.125, 0.045, 0.625, -0.5, -0.02, 0.5, foot = true },
    { "right_thigh", "hip", 0.775, -0.125, 0.125, 0.06, 0.9, -0.05, 0.4, 1 },
    { "right_shin", "right_thigh", 0.475, -0.155, 0.125, 0.045, 0.625, -0.5, -0.02, 0.5, foot = true },
    { "left_upper_arm", "torso", 1.225, -0.125, 0.125, 0.035, 1.35, -0.1, 0.8, 0.5 },
    { "left_forearm", "left_upper_arm", 0.975, -0.125, 0.125, 0.03, 1.1, -0.2, 0.3, 0.1, turned = 0.25, air = 0.1 },
    { "right_upper_arm", "torso", 1.225, -0.125, 0.125, 0.035, 1.35, -0.1, 0.8, 0.5 },
    { "right_forearm", "right_upper_arm", 0.975, -0.125, 0.125, 0.03, 1.1, -0.2, 0.3, 0.1, turned = 0.25, air = 0.1 },
}

local foot = { vec(-0.03, -0.185), vec(0.11, -0.185), vec(0.11, -0.16), vec(-0.03, -0.14) }
local made = 0

-- What is nearer to the eye is lighter; the far arm and leg are darker.
local function shade(paint, amount)
    return color(paint.r * amount, paint.g * amount, paint.b * amount)
end

local function paint_of(name, colors)
    if name == "head" or name:find("forearm") then
        return shade(colors.skin, name:find("right") and 0.8 or 1)
    end
    local cloth = (name:find("thigh") or name:find("shin") or name == "hip") and colors.trousers or colors.shirt
    return shade(cloth, name:find("right") and 0.72 or 1)
end

local function add_bone(self, bone, position, scale, colors)
    local name, _, y, low, high, radius = table.unpack(bone, 1, 6)
    local paint = paint_of(name, colors)
    local surface = { friction = 0.2, group = -made, category = 2, mask = 3 }
    local body = Body {
        position = position + vec(0, y * scale),
        linear_damping = bone.air or 0,
        flesh = Capsule {
            from = vec(0, low * scale), to = vec(0, high * scale), radius = radius * scale,
            friction = surface.friction, group = surface.group, category = surface.category, mask = surface.mask,
            color = paint, border = shade(paint, 0.55),
        },
    }
    if bone.foot then
        local vertices = {}
        for i, vertex in ipairs(foot) do vertices[i] = vertex * scale end
        body.foot = Polygon {
            vertices = vertices, rounding = 0.015 * scale, friction = 0.05, group = surface.group, category = 2,
            mask = 1, color = shade(colors.shoes, 1), border = shade(colors.shoes, 0.55),
        }
    end
    self[name] = body
end

local function add_pin(self, bone, scale)
    local name, parent, y = bone[1], bone[2], bone[3]
    if not parent then return end
    local pivot, lower, upper, friction = table.unpack(bone, 7, 10)
    local parent_y
    for _, other in ipairs(bones) do
        if other[1] == parent then parent_y = other[3] end
    end
    self[name .. "_pin"] = RevoluteJoint {
        body_a = self[parent], body_b = self[name],
        anchor_a = vec(0, (pivot - parent_y) * scale), anchor_b = vec(0, (pivot - y) * scale),
        reference_angle = (bone.turned or 0) * math.pi,
        lower_angle = lower * math.pi, upper_angle = upper * math.pi,
        hertz = 5, damping_ratio = 0.5, max_motor_torque = 0.05 * friction * scale,
    }
end

--- A doll whose feet would stand at `position`, in `colors` (skin, shirt, trousers, shoes).
function doll.make(parent, position, scale, colors)
    made = made + 1
    local self = parent:add(Object {})
    -- Far limbs first: what is added later is drawn over what is there.
    local order = {
        "right_upper_arm", "right_forearm", "right_thigh", "right_shin", "left_thigh", "left_shin", "hip", "torso",
        "head", "left_upper_arm", "left_forearm",
    }
    local by_name = {}
    for _, bone in ipairs(bones) do by_name[bone[1]] = bone end
    for _, name in ipairs(order) do add_bone(self, by_name[name], position, scale, colors) end
    for _, bone in ipairs(bones) do add_pin(self, bone, scale) end
    return self
end

--- Calls `visit` with each bone, or each pin.
function doll.each_bone(self, visit)
    for _, bone in ipairs(bones) do visit(self[bone[1]]) end
end
function doll.each_pin(self, visit)
    for _, bone in ipairs(bones) do
        if bone[2] then visit(self[bone[1] .. "_pin"]) end
    end
end

return doll
