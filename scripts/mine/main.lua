-- A map of the Tiled editor: slopes, planks that one can jump through, water, and cells that can be
-- dug away. Arrows walk, space jumps, the mouse digs.

view.background = color("#8ec6e6")
view.height = 13
view.window.title = "Mine"
world.gravity = vec(0, -30)

Coin = class("Coin", Sprite) {
    image = "art/coin.png", columns = 6, frames_per_second = 10, pixels_per_unit = 18, smooth = false,
    worth = 1,
}

Crate = class("Crate", Body) { size = vec(1, 1) }

function Crate:ready()
    self:add(Box { width = self.size.x, height = self.size.y, density = 0.4, friction = 0.5,
        color = color("#b98550"), border = color("#6d4a2a") })
end

-- The map makes coins, crates, the sign and the point `start` from its object layer.
world.level = Tilemap { map = "level.tmj", pixels_per_unit = 16 }
local level = world.level

world.hero = Body { position = level.things.start.position, locked_rotation = true, z = 1, bullet = true,
    Capsule { from = vec(0, -0.3), to = vec(0, 0.3), radius = 0.32, friction = 0, color = color("#d4503c"),
        border = color("#6e2018") },
    Circle { center = vec(0.12, 0.32), radius = 0.07, sensor = true, density = 0, color = color("white") },
}

view.follow = world.hero
view.follow_damping = 0.12
view.limits = { vec(0, 0), level.size + vec(0, 6) }

-- All of the map, small, in a corner.
game.overview = Camera { viewport = { vec(0.02, 0.03), vec(0.3, 0.2) }, center = level.size / 2,
    height = level.size.y + 1, background = color("#6ea9cc") }

state("gold", 0)
game.score = Layer { space = "screen", anchor = "top_right", z = 100,
    count = Text { text = formula(function() return "gold " .. gold end), font = "bold", size = 26, anchor = vec(1, 0.5),
        position = vec(-24, 34), outline = color("#2a3540") } }

-- A short burst of particles that ends by itself.
local function puff(position, colors, more)
    local made = Emitter { position = position, rate = 0, burst = 14, speed = 3, damping = 2, lifetime = 0.5,
        gravity = vec(0, -12), size = { 0.22, 0.1 }, color = colors, z = 20 }
    for name, value in pairs(more or {}) do made[name] = value end
    world:add(made):on("finished", function(event) event.instance:delete() end)
end

-- Each torch of the map gets smoke and sparks.
for y = 0, level.rows - 1 do
    for x = 0, level.columns - 1 do
        local tile = level:tile(x, y, "decoration")
        if tile > 0 and level:tile_property(tile, "light") then
            world:add(Emitter { position = level:cell_center(x, y) + vec(0, 0.2), angle = math.pi / 2, spread = 0.9,
                rate = 12, speed = 1, lifetime = 1.1, size = { 0.3, 0.1 }, blend = "add", seed = x, z = -0.5,
                color = { color("#ffb04090"), color("#c0401040"), color("#00000000") } })
        end
    end
end

input.actions.jump = { "space", "up", "gamepad.a" }

local function on_ground()
    local from = world.hero.position
    for _, hit in ipairs(world:raycast_all(from, from - vec(0, 0.75))) do
        if hit.body ~= world.hero then return true end
    end
    return false
end

function step(dt)
    local hero, way = world.hero, 0
    if input.keys.left then way = -1 elseif input.keys.right then way = 1 end
    local v = hero.velocity
    hero.velocity = vec(v.x + (way * 6 - v.x) * 0.2, v.y)
    if input.jump.pressed and on_ground() then hero.velocity = vec(v.x, 12.5) end
    for _, coin in ipairs(level.things:children()) do
        if coin:is_a(Coin) and (coin.position - hero.position):length() < 0.8 then
            gold = gold + coin.worth
            puff(coin.position, { color("gold"), color("#fff0a000") }, { gravity = vec(0, 0), blend = "add" })
            coin:delete()
        end
    end
    if hero.position.y < -3 then hero.position, hero.velocity = level.things.start.position, vec(0, 0) end
end

-- Earth is dug away, and crystals are worth something; stone is too hard.
function dig(point)
    local cell = level:cell_at(point)
    local tile = level:tile(cell.x, cell.y, "ground")
    if tile == 0 or level:tile_property(tile, "hard") then return false end
    local worth = level:tile_property(tile, "gold")
    gold = gold + (worth or 0)
    puff(level:cell_center(cell.x, cell.y),
        { worth and color("aquamarine") or color("#8c5c3e"), color(worth and "#a0ffe000" or "#8c5c3e00") },
        { shape = "box", area = vec(0.8, 0.8) })
    level:set_tile(cell.x, cell.y, 0, "ground")
    return true
end

function mouse_pressed(button, position) dig(position) end
