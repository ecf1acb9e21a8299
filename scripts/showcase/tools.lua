-- What the mouse does: drag and throw, draw circles, build polygons vertex by vertex, look around.

local stage = require("stage")

local tools = {}
local tints = { "#5b8def", "#46a758", "#ffb224", "#8e4ec6", "#12a594", "#f76b15", "#d6409f", "#7c66dc" }
local mode = "drag"      -- "drag", "circle" or "polygon"
local center             -- of the circle being drawn
local points = {}        -- of the polygon being built, before it is one
local building           -- the thing whose polygon is being built
local looking            -- pixels where the view was taken hold of

local function new_tint()
    return color(tints[random(#tints)])
end

local function moving_thing_at(position)
    local body = world:at(position)
    if body and body.type == "dynamic" then return body end
end

-- --- Dragging ---------------------------------------------------------------------------------------------------

local function grab(position)
    local body = moving_thing_at(position)
    if not body then return end
    local force = 500 * math.max(body.mass, 0.1)
    world.drag = MouseJoint { body = body, target = position, max_force = force }
end

local function let_go()
    if world:has("drag") then world.drag = nil end
end

function tools.delete()
    local body = world:at(input.mouse.world)
    if body and body ~= building then body:delete() end
end

-- --- Circles ----------------------------------------------------------------------------------------------------

function tools.circle()
    tools.cancel()
    mode = "circle"
end

local function circle_radius()
    return math.max(0.1, (input.mouse.world - center):length())
end

local function make_circle()
    stage.place():add(Thing { position = center, tint = new_tint(), Circle { radius = circle_radius(), orientation_mark = true } })
    center = nil
end

-- --- Polygons ---------------------------------------------------------------------------------------------------

function tools.polygon()
    tools.cancel()
    mode = "polygon"
end

local function on_a_line(a, b, c)
    return math.abs((b - a):cross(c - a)) < 0.01
end

-- The first three vertices make a polygon; each further one is added to the living thing, whose hull follows.
local function add_vertex(position)
    if building then
        local shape = building.polygon
        shape.vertices[#shape.vertices + 1] = building:to_local(position)
        return
    end
    points[#points + 1] = position
    if #points < 3 or on_a_line(points[1], points[2], points[#points]) then return end
    local origin = points[1]
    local vertices = {}
    for i, point in ipairs(points) do vertices[i] = point - origin end
    building = stage.place():add(Thing {
        type = "static", position = origin, tint = new_tint(),
        polygon = Polygon { vertices = vertices },
    })
    points = {}
end

function tools.finish()
    if building then building.type = "dynamic" end
    building, points = nil, {}
end

function tools.cancel()
    let_go()
    if building then building:delete() end
    building, points, center, mode = nil, {}, nil, "drag"
end

-- --- Events -----------------------------------------------------------------------------------------------------

function tools.pressed(button, position)
    if button == "right" and mode == "polygon" then tools.finish() return end
    if button ~= "left" then looking = input.mouse.screen return end
    if mode == "circle" then
        center = position
    elseif mode == "polygon" then
        add_vertex(position)
    else
        grab(position)
    end
end

function tools.moved(position, pixels)
    if looking then
        local scale = view.height / view.screen.y
        view.center = view.center - vec((pixels.x - looking.x) * scale, (looking.y - pixels.y) * scale)
        looking = pixels
    elseif world:has("drag") then
        world.drag.target = position
    end
end

function tools.released(button)
    if button ~= "left" then looking = nil return end
    if mode == "circle" and center then make_circle() end
    let_go()
end

function tools.zoom(notches, position)
    local height = math.min(200, math.max(2, view.height * 0.9 ^ notches))
    local closer = height / view.height
    view.center = position + (view.center - position) * closer
    view.height = height
end

-- --- What is seen of it -----------------------------------------------------------------------------------------

local pale, faint = color("#ffffff"), color(1, 1, 1, 0.15)

function tools.draw(pen)
    if center then
        pen.circle(center, circle_radius(), faint, pale, 1.5)
        pen.line(center, input.mouse.world, pale, 1)
    end
    for i, point in ipairs(points) do
        pen.point(point, pale, 7)
        pen.line(point, points[i + 1] or input.mouse.world, color(1, 1, 1, 0.5), 1)
    end
    if building then
        for _, vertex in ipairs(building.polygon.world_vertices) do pen.point(vertex, pale, 6) end
    end
    if world:has("drag") and world.drag.body then
        local joint = world.drag
        pen.line(joint.body:to_drawn(joint.anchor), joint.target, color("#ffd60a"), 2)
        pen.point(joint.target, color("#ffd60a"), 7)
    end
end

function tools.hint()
    if mode == "circle" then return "press, pull and let go: a circle    Esc: done" end
    if mode == "polygon" then return "click: a vertex    Enter or right click: let it fall    Esc: give up" end
    return "drag and throw with the mouse    wheel: zoom    right button: look around"
end

return tools
