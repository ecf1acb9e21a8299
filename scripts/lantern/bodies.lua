-- What the parts of the game share: categories of shapes, the size of an arena, and values that are read often, once a step.
local bodies = { HERO = 1, ENEMY = 2, STONE = 4, GEM = 8, SHOT = 16, SOLID = 23, half = vec(36, 27),
    hero_at = vec(0, 0), now = 0, count = 0 }
local probe = Circle {}

function bodies.refresh() bodies.hero_at, bodies.now, bodies.count = vec(world.hero.position), time.now, time.step end
function bodies.toward(angle, length) return vec(length, 0):rotated(angle) end
function bodies.around(point, radius, mask)      -- the bodies of these categories that are not farther from a point
    probe.center, probe.radius = point, radius
    return world:overlap(probe, mask)
end
function bodies.disc(radius, category, mask, sensor, density)
    return Circle { radius = radius, category = category, mask = mask, sensor = sensor or false, density = density or 1, friction = 0,
        visible = false }
end
function bodies.look(frames, size, lift, file, columns, rows)
    return Sprite { image = "art/" .. (file or "sheet") .. ".png", columns = columns or 8, rows = rows or 4, animation = frames,
        frames_per_second = 7, size = vec(size, size), position = vec(0, lift or 0) }
end

return bodies
