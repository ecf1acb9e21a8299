-- Particles, texts that pop up, and the places: sky, clouds, hills, what floats in the air.
local fx = {}
-- A burst of particles that ends by itself.
function fx.puff(at, colors, count, more)
    local made = Emitter { position = at, rate = 0, burst = count, speed = 4, damping = 2, lifetime = 0.45, gravity = vec(0, -6),
        size = { 0.28, 0.08 }, color = colors, z = 20, seed = time.step }
    for name, value in pairs(more or {}) do made[name] = value end
    game.scene:add(made):on("finished", function(event) event.instance:delete() end)
end
function fx.pop(at, text, sound, tint)
    if sound then sounds[sound]:play() end
    local label = game.scene:add(Text { position = at, text = text, size = 0.2, font = "bold", color = tint or color("#fff1d6"),
        outline = color("#2b1d2e"), outline_width = 0.12, z = 30 })
    label:tween("size", 0.62, 0.25, "out_back")
    label:tween("position", at + vec(0, 1.3), 0.9, "out_quad")
    label:after(0.9, label.delete)
end
function fx.tune(music, pitch)
    music.pitch = pitch
    if #music:children("Voice") == 0 then music:play() end
end
fx.places = {
    { name = "Morning Meadow", air = { "#fff6c0", "#ffffff00" }, rate = 5, fall = 0.3, pitch = 1 },
    { name = "Rust Wood", air = { "#ffb347", "#d8692e" }, rate = 6, fall = 1.4, pitch = 0.94 },
    { name = "Glow Caves", air = { "#6ff0dd", "#6ff0dd00" }, rate = 8, fall = -0.5, pitch = 0.84 },
    { name = "Frost Ridge", air = { "#ffffff", "#ffffffa0" }, rate = 34, fall = 2.2, pitch = 1.06 },
    { name = "Dusk Keep", air = { "#ffc46b", "#ff8a5b00" }, rate = 9, fall = -0.8, pitch = 0.9 },
    { name = "The Boar King", air = { "#ff7a3d", "#ff3d2e00" }, rate = 16, fall = -1.6, pitch = 1 },
}
-- Everything behind the level. Layers stand still, or move at a part of the speed of the view.
function fx.backdrop(scene, number)
    local function layer(name, speed, z, sprite, wide)
        scene:add(Layer { parallax = vec(speed, speed * 0.35), z = z, repeat_x = wide or 0, sprite }, name)
    end
    local function picture(name, y, size, origin)
        return Sprite { image = "art/" .. name .. ".png", smooth = false, position = vec(0, y), size = size, origin = origin }
    end
    layer("sky", 0, -60, picture("sky_" .. number, 0, vec(64, 15)), nil)
    layer("clouds", 0.08, -55, picture("clouds_" .. number, 3.4, vec(24, 6)), 24)
    for i = 1, 3 do layer("hills_" .. i, 0.14 * i, -54 + i, picture("hills_" .. number .. "_" .. i, -7.6, vec(24, 11), vec(0.5, 0)), 24) end
    local place = fx.places[number]
    scene:add(Emitter { shape = "box", area = vec(30, 15), rate = place.rate, speed = 0.5, lifetime = 5, size = { 0.06, 0.16, 0.1 },
        gravity = vec(0, -place.fall * 0.4), color = { color(place.air[1]), color(place.air[1]), color(place.air[2]) }, z = 12,
        image = number == 2 and "art/leaf.png" or "", rotation = 2, position = view.center }, "air")
end
return fx
