-- Ragdolls: they tumble down a board of pegs; take hold of one and throw it.

local doll = require("doll")

game.ragdoll = Object {
    scale = 1.9,         -- of the dolls that come
    tears = false,       -- their pins break
    strength = 260,      -- N that a pin bears then
    most = 14,           -- dolls at a time
}

local wardrobe = {
    { skin = color("#f1c27d"), shirt = color("#e5484d"), trousers = color("#3e63dd"), shoes = color("#2b2f36") },
    { skin = color("#c68642"), shirt = color("#ffb224"), trousers = color("#46464f"), shoes = color("#e8e8e8") },
    { skin = color("#8d5524"), shirt = color("#46a758"), trousers = color("#b8a47e"), shoes = color("#2b2f36") },
    { skin = color("#ffdbac"), shirt = color("#8e4ec6"), trousers = color("#3a5a78"), shoes = color("#7a3b2e") },
    { skin = color("#e0ac69"), shirt = color("#12a594"), trousers = color("#5b3a53"), shoes = color("#e8e8e8") },
}
local dolls, looking = {}, nil
local wood, wood_edge = color("#3a4252"), color("#5a657c")
local brass, brass_edge = color("#d8a657"), color("#8a6a34")

local function block(position, width, height, angle)
    world.board:add(Body {
        type = "static", position = position, angle = angle or 0,
        Box { width = width, height = height, rounding = math.min(0.12, math.min(width, height) * 0.3), color = wood, border = wood_edge },
    })
end

local function build_board()
    world.board = Object {}
    block(vec(0, -0.5), 26, 1)
    block(vec(-13.2, 6), 0.6, 14)
    block(vec(13.2, 6), 0.6, 14)
    for row = 1, 4 do
        for column = 1, 7 - row % 2 do
            world.board:add(Body {
                type = "static", position = vec((column - (8 - row % 2) / 2) * 3.1, 2.2 + row * 2.1),
                Circle { radius = 0.28, friction = 0.3, restitution = 0.3, color = brass, border = brass_edge },
            })
        end
    end
    block(vec(-9.5, 2.2), 4.5, 0.35, -0.45)
    block(vec(9.5, 2.2), 4.5, 0.35, 0.45)
    for step = 1, 4 do block(vec(-2.8 + step * 1.1, step * 0.3 - 0.15), 1.1, step * 0.6) end
    for i = 0, 8 do
        local layer = i < 4 and 0 or i < 7 and 1 or 2
        local place = i < 4 and i or i < 7 and i - 3.5 or i - 6
        world.board:add(Body {
            position = vec(4 + place * 0.8, 0.36 + layer * 0.72),
            Box { width = 0.7, height = 0.7, density = 0.4, rounding = 0.03, color = color("#a97142"), border = color("#6b4423") },
        })
    end
end

local function tear(self, pin)
    pin.break_force = ragdoll.tears and ragdoll.strength * ragdoll.scale or math.huge
end

local function new_doll(position)
    local self = doll.make(world.dolls, position, ragdoll.scale, wardrobe[#dolls % #wardrobe + 1])
    dolls[#dolls + 1] = self
    doll.each_pin(self, function(pin) tear(self, pin) end)
    local spin = random() * 4 - 2
    doll.each_bone(self, function(bone)
        bone.velocity = vec(spin * 0.5, -1)
        bone.angular_velocity = spin
    end)
    while #dolls > ragdoll.most do table.remove(dolls, 1):delete() end
end

local function set_tearing()
    for _, self in ipairs(dolls) do doll.each_pin(self, function(pin) tear(self, pin) end) end
end

function start()
    view.background = color("#161b26")
    view.center = vec(0, 6)
    view.height = 15.4
    build_board()
    world.dolls = Object {}
    ragdoll:watch("tears", set_tearing)
    ragdoll:watch("strength", set_tearing)
    for i = 1, 5 do new_doll(vec(-8 + i * 2.7, 11 + i % 2 * 2)) end
    every(3, function()
        if #dolls < 9 then new_doll(vec(random() * 16 - 8, 13)) end
    end)
end

-- --- What hands do ----------------------------------------------------------------------------------------------

local function let_go()
    if world:has("drag") then world.drag = nil end
end

local commands = {
    space = function() new_doll(input.mouse.world) end,
    t = function() ragdoll.tears = not ragdoll.tears end,
    e = function() world:explode(input.mouse.world, 5, 25 * ragdoll.scale) end,
    g = function() world.gravity = world.gravity.y == 0 and vec(0, -10) or vec(0, 0) end,
    p = function() time.paused = not time.paused end,
    j = function() view.show.joints = not view.show.joints end,
}

function key_pressed(key)
    local command = commands[key]
    if command then command() end
end

function mouse_pressed(button, position)
    if button ~= "left" then looking = input.mouse.screen return end
    local body = world:at(position)
    if body and body.type == "dynamic" then
        -- A bone carries the whole doll.
        world.drag = MouseJoint { body = body, target = position, frequency = 6, max_force = 900 * ragdoll.scale }
    end
end

function mouse_moved(position, pixels)
    if looking then
        local scale = view.height / view.screen.y
        view.center = view.center - vec((pixels.x - looking.x) * scale, (looking.y - pixels.y) * scale)
        looking = pixels
    elseif world:has("drag") then
        world.drag.target = position
    end
end

function mouse_released(button)
    if button ~= "left" then looking = nil return end
    let_go()
end

function wheel(notches, position)
    local height = math.min(60, math.max(3, view.height * 0.9 ^ notches))
    view.center = position + (view.center - position) * (height / view.height)
    view.height = height
end

-- --- What is seen ------------------------------------------------------------------------------------------------

local ink, dim, key_ink = color("#eceef0"), color("#9ba1a6"), color("#d8a657")
local panel, edge = color(0.05, 0.06, 0.09, 0.78), color(1, 1, 1, 0.12)
local rows = {
    { "Mouse", "take hold, drag, throw" },
    { "Space", "another doll" },
    { "E", "an explosion" },
    { "T", "pins tear, or hold" },
    { "G  P  J", "gravity, pause, joints" },
}

-- At the upper right, or at the lower edge of a narrow window.
local function draw_figures(screen)
    local figures = string.format("%d dolls    %d bodies    %d joints    %.2f ms a step", #dolls, world.step.bodies, world.step.joints,
        world.step.total_ms)
    if ragdoll.tears then figures = figures .. "    tearing" end
    local is_narrow = view.screen.x < 740
    local width = view.screen.x - (is_narrow and 48 or 320)
    local _, height = screen.text_size(figures, 14, nil, width)
    local middle = is_narrow and view.screen.y - 10 - height / 2 or 18 + height / 2
    screen.text(vec(view.screen.x - 24, middle), figures, 14, dim, "right", nil, width)
end

function draw(pen)
    for _, self in ipairs(dolls) do
        local head = self.head
        local turned = function(x, y) return head:to_drawn(vec(x, y) * ragdoll.scale) end
        pen.point(turned(0.04, 0.015), "#20242c", 6)
    end
    if world:has("drag") and world.drag.body then
        local grip = world.drag.body:to_drawn(world.drag.anchor)
        pen.line(grip, world.drag.target, "#ffd60a", 2)
        pen.point(world.drag.target, "#ffd60a", 7)
    end
    pen.screen(function(screen)
        screen.box(vec(150, 84), 268, 136, panel, edge, 1)
        screen.text(vec(32, 34), "Ragdoll", 20, ink, "left")
        for i, row in ipairs(rows) do
            screen.text(vec(86, 44 + i * 18), row[1], 12, key_ink, "right")
            screen.text(vec(98, 44 + i * 18), row[2], 12, ink, "left")
        end
        draw_figures(screen)
    end)
end
