-- Sprites, layers, texts and a view that follows. Left and right walk, space jumps.

view.background = color("#9fd3ea")
view.height = 12
view.window.title = "Meadow"
world.gravity = vec(0, -30)

-- Far away: layers that move slower than the world and repeat.
world.sky = Layer { parallax = vec(0, 0), z = -30,
    Sprite { image = "art/sun.png", position = vec(6, 3.5), size = vec(5, 5), blend = "add" } }
world.far = Layer { parallax = vec(0.2, 0.9), repeat_x = 16, z = -20,
    Sprite { image = "art/far.png", position = vec(0, 0.6), smooth = false } }
world.near = Layer { parallax = vec(0.5, 1), repeat_x = 16, z = -10,
    Sprite { image = "art/near.png", position = vec(0, -0.5), smooth = false } }

world.ground = Body { type = "static", position = vec(0, -5), z = 5,
    Box { width = 120, height = 4, color = color("#5b8a4a"), border = color("#3d6433") } }
for _, block in ipairs { { 6, -1.5, 3 }, { 11, 0, 3 }, { 17, 1.2, 4 }, { 25, -0.5, 5 } } do
    world:add(Body { type = "static", position = vec(block[1], block[2]),
        Box { width = block[3], height = 0.6, color = color("#8a6a4a"), border = color("#5d4631") } })
end
for n = 0, 13 do
    world:add(Sprite { image = "art/tree.png", origin = vec(0.5, 0), position = vec(-30 + 5.3 * n, -3),
        scale = 1.4 + 0.6 * random(), flip_x = n % 2 == 0, smooth = false, z = -1 })
end

-- A body with a sprite below it, which is drawn where the body is drawn.
world.hero = Body { position = vec(0, -2), locked_rotation = true, z = 1,
    Box { width = 0.7, height = 1.4, friction = 0, visible = false },
    look = Sprite { image = "art/hero.png", columns = 5, position = vec(0, 0.08), pixels_per_unit = 15,
        smooth = false, animation = "1" },
}

Coin = class("Coin", Sprite) {
    image = "art/coin.png", columns = 6, frames_per_second = 9, pixels_per_unit = 18, smooth = false,
}
for n, place in ipairs { vec(3, -1.5), vec(6, 0), vec(11, 1.5), vec(13, 1.5), vec(17, 3), vec(21, 2), vec(25, 1) } do
    world["coin_" .. n] = Coin { position = place, frame = n % 6 + 1 }
end

world.sign = Text { text = "Seven coins lie to the right.\nArrow keys walk, space jumps.", position = vec(-4, 0.5), size = 0.55,
    outline = color("#31424f") }
world.rope = Line { points = { vec(-6.2, -0.4), vec(-5.2, -0.6), vec(-4, -0.66), vec(-2.8, -0.6), vec(-1.8, -0.4) },
    width = 0.07, color = color("#6b4a2e"), dashed = 0.2 }

game.score = Layer { space = "screen", z = 100,
    coin = Sprite { image = "art/coin.png", columns = 6, scale = 2, position = vec(40, 40), smooth = false },
    count = Text { text = "0 of 7", font = "bold", size = 28, anchor = vec(0, 0.5), position = vec(70, 40),
        outline = color("#31424f") } }

view.follow = world.hero
view.follow_damping = 0.15
view.dead_zone = vec(2, 2)
view.limits = { vec(-40, -7), vec(40, 20) }

local found = 0

local function on_ground()
    local from = world.hero.position
    for _, hit in ipairs(world:raycast_all(from, from - vec(0, 0.85))) do
        if hit.body ~= world.hero then return true end
    end
    return false
end

function step()
    local hero, look = world.hero, world.hero.look
    local way = (input.keys.right and 1 or 0) - (input.keys.left and 1 or 0)
    hero.velocity = vec(6 * way, hero.velocity.y)
    if way ~= 0 then look.flip_x = way < 0 end
    local animation = way == 0 and "1" or "2-5"
    if look.animation ~= animation then
        look.animation = animation
        look.frames_per_second = way == 0 and 0 or 10
    end
    if input.keys.space and hero.velocity.y < 0.1 and on_ground() then hero.velocity = vec(hero.velocity.x, 13) end
    for _, coin in ipairs(world:find("Coin")) do
        if (coin.position - hero.position):length() < 1 then
            coin:delete()
            found = found + 1
            game.score.count.text = found < 7 and found .. " of 7" or "All seven!"
            view:shake(0.08, 0.2)
        end
    end
end
