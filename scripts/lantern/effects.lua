-- What is seen for a moment: sparks, rings, lightning, falling stars, numbers. Nothing in the game depends on it.
local effects = {}

Burst = class("Burst", Emitter) { image = "art/glow.png", blend = "add", rate = 0, lifetime = 0.5, speed = 2.6, damping = 3, randomness = 0.5 }
function Burst:finished() self:delete() end

function effects.burst(at, tint, count)
    world.effects:add(Burst { position = at, burst = count, size = { 1, 0 }, color = { tint }, seed = random(1000000) })
end

-- One particle that grows to the ring of a radius, or stays as large as it is.
function effects.ring(at, radius, tint)
    local pale = color(tint.r, tint.g, tint.b, 0)
    world.effects:add(Burst { image = "art/ring.png", position = at, burst = 1, speed = 0, lifetime = 0.45, randomness = 0,
        size = { 0, 1.83 * radius, 2.5 * radius, 2.6 * radius }, color = { tint, tint, pale } })
end

-- It is seen for some seconds, in which a property goes to a value.
local function show(instance, seconds, property, to)
    world.effects:add(instance):tween(property, to, seconds)
    instance:after(seconds, function(it) it:delete() end)
end

function effects.lightning(from, to)
    local side, points = (to - from):rotated(math.pi / 2) * 0.24, { from }
    for i = 1, 5 do points[i + 1] = from:lerp(to, i / 6) + side * random(-0.5, 0.5) end
    points[7] = to
    for _, width in ipairs { 0.25, 0.07 } do
        show(Line { points = points, width = width, blend = "add", color = color(0.6, 0.7, 1, 0.05 / width) }, 0.2, "color", color("#99b3ff00"))
    end
end

function effects.comet(at)
    show(Sprite { image = "art/glow.png", blend = "add", tint = color("#bfe4ff"), position = at + vec(5, 9), size = vec(1.8, 1.8),
        Burst { rate = 90, lifetime = 0.3, speed = 0.5, size = { 0.9, 0 }, color = { color("#8ad0ff80") } } }, 0.55, "position", at)
    show(Sprite { image = "art/glow.png", blend = "add", tint = color("#5a8cff20"), position = at, size = vec(2.4, 2.4) },
        0.55, "tint", color("#5a8cff90"))
end

function effects.number(at, amount)
    if #world.effects:children() > 120 then return end
    at = at + vec(random(-0.3, 0.3), 0.6)
    show(Text { text = tostring(math.max(1, math.floor(amount + 0.5))), size = math.min(0.85, 0.4 + 0.03 * amount), font = "bold",
        color = color("#fff0c4"), position = at }, 0.6, "position", at + vec(0, 0.9))
end

function effects.banner(title, text) night.title, night.subtitle, night.said = title, text, time.now end

return effects
