-- Hills as a row of convex columns, and what stands on them.

local terrain = { length = 320, column = 1.1, depth = 14 }

local soil, soil_edge = color("#3b2f3f"), color("#3b2f3f")
local plank, plank_edge = color("#b07d4f"), color("#5f4027")
local gaps = { { 66, 79 } }  -- from, to: a bridge spans each

--- How high the ground is, m: gentle where the car begins, wilder as it goes on.
function terrain.height(x)
    local wild = math.min(1, math.max(0, (x - 8) / 90))
    local hills = 1.5 * math.sin(x * 0.11) + 0.9 * math.sin(x * 0.23 + 1.3) + 0.45 * math.sin(x * 0.57 + 0.4)
    return hills * (0.15 + 1.25 * wild)
end

local function in_gap(x)
    for _, gap in ipairs(gaps) do
        if x >= gap[1] and x < gap[2] then return true end
    end
    return false
end

local function add_column(ground, from, to)
    ground:add(Polygon {
        vertices = {
            vec(from, terrain.height(from)), vec(from, -terrain.depth), vec(to, -terrain.depth),
            vec(to, terrain.height(to)),
        },
        friction = 0.9, color = soil, border = soil_edge,
    })
end

local function add_bridge(parent, from, to)
    local planks, before = 13, nil
    local bridge = parent:add(Object {})
    local a, b = vec(from, terrain.height(from) - 0.12), vec(to, terrain.height(to) - 0.12)
    local span = (b - a):length() / planks
    local along = (b - a):normalized()
    local angle = math.asin(along.y)
    for i = 1, planks do
        local this = bridge:add(Body {
            position = a + along * ((i - 0.5) * span), angle = angle,
            Box { width = span * 1.02, height = 0.22, rounding = 0.05, density = 1.6, friction = 0.8,
                color = plank, border = plank_edge },
        })
        bridge:add(RevoluteJoint {
            body_a = before, body_b = this, anchor_a = before and vec(span / 2, 0) or a, anchor_b = vec(-span / 2, 0),
        })
        before = this
    end
    bridge:add(RevoluteJoint { body_a = before, anchor_a = vec(span / 2, 0), anchor_b = b })
end

local function add_seesaw(parent, x)
    local y = terrain.height(x)
    parent:add(Body {
        type = "static", position = vec(x, y),
        Polygon { vertices = { vec(-0.6, -0.6), vec(0.6, -0.6), vec(0, 0.75) }, color = soil },
    })
    local board = parent:add(Body {
        position = vec(x, y + 0.85), angle = 0.12,
        Box { width = 6.5, height = 0.2, rounding = 0.05, friction = 0.9, color = plank, border = plank_edge },
    })
    parent:add(RevoluteJoint { body_b = board, anchor_a = vec(x, y + 0.85), lower_angle = -0.4, upper_angle = 0.3 })
end

local function add_wall(parent, x)
    local tints = { "#e5484d", "#ffb224", "#5b8def", "#46a758" }
    local base = terrain.height(x)
    for row = 0, 4 do
        for column = 0, 2 do
            parent:add(Body {
                position = vec(x + column * 0.72 + (row % 2) * 0.2, base + 0.5 + row * 0.71),
                Box { width = 0.7, height = 0.7, density = 0.25, rounding = 0.04,
                    color = color(tints[(row + column) % #tints + 1]), border = color("#1d1822") },
            })
        end
    end
end

function terrain.build(parent)
    parent.ground = Body { type = "static" }
    parent.scenery = Object {}
    for x = -30, terrain.length, terrain.column do
        if not in_gap(x) and not in_gap(x + terrain.column) then
            add_column(parent.ground, x, x + terrain.column)
        end
    end
    for _, gap in ipairs(gaps) do
        -- The edges of the ground are where the columns end.
        local from, to = -30, -30
        while from + terrain.column <= gap[1] do from = from + terrain.column end
        to = from
        while in_gap(to) or in_gap(to + terrain.column) or to < gap[1] do to = to + terrain.column end
        add_bridge(parent.scenery, from, to)
    end
    add_seesaw(parent.scenery, 40)
    add_wall(parent.scenery, 24)
    add_wall(parent.scenery, 112)
    add_wall(parent.scenery, 170)
    add_seesaw(parent.scenery, 140)
end

--- Whether there is ground from x on.
function terrain.solid(x)
    return not in_gap(x) and not in_gap(x + terrain.column)
end

return terrain
