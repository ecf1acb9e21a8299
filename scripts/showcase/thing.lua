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
