-- A miner in a quarry: slopes, stairs, a low tunnel, a lift, a crate, a ladder and planks. Arrow keys walk, crouch and
-- climb, space jumps, down and space drops through a plank. Try `world.hero.step_height = 1` in the console.

local LEDGE = 2
local stone, moss = color("#6d6a75"), color("#8fae5d")
local wood, wood_edge = color("#a8743f"), color("#5f3f1f")

view.background = color("#f2c38f")
view.height = 11
world.gravity = vec(0, -20)

game.quarry = Object { found = 0, falls = 0, safe = vec(-4, 0.1) }

local tops = {}  -- where moss grows

local function solid(shape, from, to)
    shape.color, shape.border = stone, stone
    tops[#tops + 1] = { from, to }
    world:add(Body { type = "static", shape })
end
local function block(left, right, top, bottom)
    solid(Box { width = right - left, height = top - bottom, center = vec(left + right, top + bottom) / 2 },
        vec(left, top), vec(right, top))
end

-- The ground, from left to right.
block(-12, 6, 0, -8)
solid(Polygon { vertices = { vec(6, -8), vec(10, -8), vec(10, 2), vec(6, 0) } }, vec(6, 0), vec(10, 2))
block(10, 14, 2, -8)
for n = 1, 5 do block(13.5 + 0.5 * n, 14 + 0.5 * n, 2 + 0.25 * n, -8) end
block(16.5, 27, 3.25, -8)
block(20, 24, 8, 4.4)                       -- the tunnel is below it
block(35, 43, 3.25, -8)
block(43, 49, 5.25, -8)
block(49, 64, 9.25, -8)
block(-14, -12, 12, -8)
block(64, 66, 16, -8)

world.lift = Body { type = "kinematic", position = vec(28.4, 3.05), velocity = vec(2, 0),
    Box { width = 2.4, height = 0.4, color = wood, border = wood_edge } }
world.crate = Body { position = vec(39, 3.76), Box { density = 40, friction = 0.5, color = wood, border = wood_edge } }
for n = 0, 2 do
    world:add(Body { type = "static", position = vec(54 + 2.4 * n, 10.25 + n),
        Box { width = 2.2, height = 0.2, category = LEDGE, color = wood, border = wood_edge } })
end

local ladder = { x = 48.4, bottom = 5.25, top = 9.25 }

Gem = class("Gem", Body) { type = "static" }
for n, place in ipairs { vec(8, 2.1), vec(15.4, 3.8), vec(22, 3.9), vec(31, 4.4), vec(42.4, 6.1), vec(48.4, 8), vec(58.8, 13.4) } do
    world["gem_" .. n] = Gem { position = place, Circle { radius = 0.35, sensor = true, visible = false } }
    world["gem_" .. n]:on("sensor_begin", function(event)
        if event.other ~= world.hero then return end
        quarry.found = quarry.found + 1
        world["gem_" .. n]:delete()
    end)
end

world.hero = Mover { position = vec(-4, 0.1), height = 1.6, radius = 0.35, crouch_height = 0.9, ledges = LEDGE, visible = false }
world.hero:on("landed", function(event) if event.speed > 6 then view:shake(0.06, 0.15) end end)
view.follow = world.hero
view.follow_damping = 0.15
view.limits = { vec(-12, -6), vec(64, 18) }

local function on_ladder(hero)
    local at = hero.position
    return math.abs(at.x - ladder.x) < 0.5 and at.y > ladder.bottom - 0.1 and at.y < ladder.top
end

function key_pressed(key)
    local hero = world.hero
    if key == "space" then
        if input.keys.down and hero:drop() then return end
        if hero.on_ground or hero.climbing then hero:jump(7) end
    elseif key == "up" and on_ladder(hero) then
        hero.climbing = true
    end
end

function step()
    local hero, keys = world.hero, input.keys
    hero.walk = ((keys.right and 1 or 0) - (keys.left and 1 or 0)) * (hero.crouched and 2 or 5)
    hero.climb = ((keys.up and 1 or 0) - (keys.down and 1 or 0)) * 3
    hero.crouch = keys.down and hero.on_ground
    if keys.up and (hero.on_ground or hero.velocity.y < 0) and on_ladder(hero) then hero.climbing = true end
    if hero.climbing then
        hero.walk = hero.walk * 0.3
        if not on_ladder(hero) then
            hero:jump(keys.up and 4 or 0)   -- a little hop from its end
        end
    end
    local lift = world.lift
    if lift.position.x > 33.6 then lift.velocity = vec(-2, 0) elseif lift.position.x < 28.4 then lift.velocity = vec(2, 0) end
    if hero.on_ground and hero.ground and hero.ground:is_a(Body) and hero.ground.type == "static" then
        quarry.safe = hero.position
    elseif hero.position.y < -7 then
        quarry.falls = quarry.falls + 1
        hero.position, hero.velocity = quarry.safe, vec(0, 0)
    end
end

-- --- What is seen ------------------------------------------------------------------------------------------------

local far, near = color("#e3a873"), color("#c98a5b")

local function hills(pen, paint, share, height, width)
    local shift = view.center.x * share
    local first = math.floor((view.center.x - shift - 20) / width)
    for n = first, first + math.ceil(40 / width) + 1 do
        local x, top = shift + n * width, height + 1.4 * math.sin(n * 2.1)
        pen.polygon({ vec(x - width, -9), vec(x - 0.3 * width, top), vec(x + 0.3 * width, top), vec(x + width, -9) }, paint)
    end
end

function draw_behind(pen)
    pen.circle(vec(view.center.x * 0.95 + 4, 9), 1.6, "#fff0cf")
    hills(pen, far, 0.8, 6, 7)
    hills(pen, near, 0.55, 3.5, 5)
    for _, side in ipairs { -0.3, 0.3 } do
        pen.line(vec(ladder.x + side, ladder.bottom), vec(ladder.x + side, ladder.top + 0.5), wood_edge, 5)
    end
    for y = ladder.bottom + 0.3, ladder.top + 0.3, 0.4 do
        pen.line(vec(ladder.x - 0.3, y), vec(ladder.x + 0.3, y), wood, 4)
    end
end

local coat, skin, helmet, dark = color("#3f6fb5"), color("#f1c9a5"), color("#ffc53d"), color("#23252d")

local function draw_hero(pen)
    local hero = world.hero
    local at, tall = hero:drawn_position(), hero.crouched and 0.9 or 1.6
    local look = hero.walk < 0 and -1 or 1
    local stride = hero.on_ground and 0.2 * math.sin(at.x * 5) or 0.16
    for _, foot in ipairs { -stride, stride } do
        pen.line(at + vec(0.5 * foot, 0.4), at + vec(foot, 0.1), dark, 9)
    end
    pen.box(at + vec(0, 0.25 + (tall - 0.65) / 2), 0.52, tall - 0.75, coat, dark, 2)
    pen.circle(at + vec(0.03 * look, tall - 0.35), 0.3, skin, dark, 2)
    pen.box(at + vec(0, tall - 0.2), 0.62, 0.2, helmet, dark, 2)
    pen.circle(at + vec(0.28 * look, tall - 0.14), 0.09, "#fffbe0", dark, 2)
    pen.circle(at + vec(0.14 * look, tall - 0.4), 0.045, dark)
end

local help = "arrow keys: walk, crouch, climb    space: jump    down and space: drop"

function draw(pen)
    for _, gem in ipairs(world:children(Gem)) do
        local at = gem.position + vec(0, 0.08 * math.sin(3 * time.now + gem.position.x))
        pen.polygon({ at + vec(-0.25, 0.05), at + vec(-0.12, 0.25), at + vec(0.12, 0.25), at + vec(0.25, 0.05), at + vec(0, -0.3) },
            "#4cd3c2", "#176b62", 2)
    end
    for _, top in ipairs(tops) do pen.line(top[1] - vec(0, 0.06), top[2] - vec(0, 0.06), moss, 7) end
    draw_hero(pen)
    pen.screen(function()
        local done = quarry.found == 7
        local width = view.screen.x - 48
        local across, height = pen.text_size(help, 14, nil, width)
        pen.box(vec(24 + across / 2, 34 + height / 2), across + 24, height + 48, "#fff0cfd0")  -- for texts before stone
        pen.text(vec(24, 30), done and "All seven gems" or quarry.found .. " of 7 gems", 22, dark, "left")
        pen.text(vec(24, 48 + height / 2), help, 14, dark, "left", nil, width)
    end)
end
