-- Help on the screen, in pixels.

local help = {}

local ink, dim, key_color = color("#eceef0"), color("#9ba1a6"), color("#70b8ff")
local panel, edge = color(0.05, 0.06, 0.08, 0.78), color(1, 1, 1, 0.12)

local rows = {
    { "1 - 6", "pyramid stack slope compounds cradle playground" },
    { "C", "draw circles" },
    { "P", "build a polygon, vertex by vertex" },
    { "X", "delete what is under the mouse" },
    { "Space", "pause, go on" },
    { "Period", "one step" },
    { "R", "the scene from its beginning" },
    { "G", "gravity off and on" },
    { "K  V  M  J", "contacts, velocities, centers of mass, joints" },
    { "T", "red while touching" },
    { "H", "this help" },
    { "Grave", "the console: every value is live" },
}

local function frame(pen, left, top, width, height)
    pen.box(vec(left + width / 2, top + height / 2), width, height, panel, edge, 1)
end

function help.draw(pen, hint)
    pen.screen(function(screen)
        local left, top, line = 16, 16, 18
        frame(screen, left, top, 412, 56 + #rows * line)
        screen.text(vec(left + 16, top + 22), "Fettle", 20, ink, "left")
        screen.text(vec(left + 88, top + 24), showcase.scene, 14, dim, "left")
        for i, row in ipairs(rows) do
            local y = top + 36 + i * line
            screen.text(vec(left + 66, y), row[1], 12, key_color, "right")
            screen.text(vec(left + 80, y), row[2], 12, ink, "left")
        end
        local statistics = world.step
        local figures = string.format("%d bodies   %d awake   %d touching   %.2f ms a step",
            statistics.bodies, statistics.awake_bodies, statistics.touching, statistics.total_ms)
        local bottom = view.screen.y - 16 - 32
        frame(screen, left, bottom, view.screen.x - 32, 32)
        screen.text(vec(left + 16, bottom + 16), hint, 14, ink, "left")
        screen.text(vec(view.screen.x - 32, bottom + 16), figures .. (time.paused and "   paused" or ""), 14, dim, "right")
    end)
end

return help
