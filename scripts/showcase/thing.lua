-- A thing is a body that shows what it feels: red while it touches another, its own color else.

local red = color("#e5484d")

Thing = class("Thing", Body) {
    tint = color("#5b8def"),
    touching = 0,
    doc = {
        tint = "Its color while it touches nothing.",
        touching = "How many contacts it has right now.",
    },
}

function Thing:repaint()
    local paint = self.tint
    if showcase.red_touch and self.touching > 0 then
        local keep = 0.35
        paint = color(red.r + (paint.r - red.r) * keep, red.g + (paint.g - red.g) * keep,
            red.b + (paint.b - red.b) * keep)
    end
    for _, shape in ipairs(self:children()) do
        if shape:has("color") then shape.color = paint end
    end
end

-- Each impact is heard, the louder the faster and the lower the heavier. Of two things, one is enough.
local knock = Synth {
    wave = "triangle", frequency = 260, slide = -5, sustain = 0.01, decay = 0.11, low_pass = 3000, volume = 0.4, max_voices = 12,
}

function Thing:contact_hit(hit)
    if hit.other:is_a("Thing") and hit.other.name < self.name then return end
    local loudness = math.min(1, hit.speed / 12)
    knock:play { volume = loudness * loudness, pitch = math.max(0.4, math.min(2.5, self.mass ^ -0.25)), position = hit.point }
end

function Thing:ready()
    self:repaint()
end

function Thing:contact_begin()
    self.touching = self.touching + 1
    if self.touching == 1 then self:repaint() end
end

function Thing:contact_end()
    self.touching = math.max(0, self.touching - 1)
    if self.touching == 0 then self:repaint() end
end
