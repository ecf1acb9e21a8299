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

-- The parts in as few lines as fit into the width, with `gap` between them.
local function lines_of(pen, parts, gap, height, width)
    local lines = {}
    for _, part in ipairs(parts) do
        local longer = #lines > 0 and lines[#lines] .. gap .. part
        if longer and pen.text_size(longer, height) <= width then lines[#lines] = longer else lines[#lines + 1] = part end
    end
    return lines
end

local function words(text)
    local all = {}
    for word in text:gmatch("%S+") do all[#all + 1] = word end
    return all
end

local function parts_of(hint)
    local all = {}
    for part in (hint .. "    "):gmatch("(.-)    +") do all[#all + 1] = part end
    return all
end

local function margin() return view.screen.x < 500 and 8 or 16 end

-- The hint and the figures at the lower edge, side by side, or the figures below the hint; a low window has no room for them.
-- Returns the upper edge.
local function draw_below(screen, hint)
    local statistics, left = world.step, 2 * margin()
    local width = view.screen.x - 2 * left
    local figures = { statistics.bodies .. " bodies", statistics.awake_bodies .. " awake", statistics.touching .. " touching",
        string.format("%.2f ms a step", statistics.total_ms) }
    if time.paused then figures[#figures + 1] = "paused" end
    local right = table.concat(figures, "   ")
    local beside = screen.text_size(hint, 14) + screen.text_size(right, 14) + 24 <= width
    local lines = beside and { hint } or lines_of(screen, parts_of(hint), "    ", 14, width)
    local said = #lines
    if not beside and view.screen.y >= 400 then
        for _, line in ipairs(lines_of(screen, figures, "   ", 14, width)) do lines[#lines + 1] = line end
    end
    local height = 14 + 18 * #lines
    local top = view.screen.y - margin() - height
    frame(screen, margin(), top, view.screen.x - 2 * margin(), height)
    for i, line in ipairs(lines) do screen.text(vec(left, top - 2 + 18 * i), line, 14, i <= said and ink or dim, "left") end
    if beside then screen.text(vec(view.screen.x - left, top + 16), right, 14, dim, "right") end
    return top
end

function help.draw(pen, hint)
    pen.screen(function(screen)
        local below, left = draw_below(screen, hint), margin()
        local width = math.min(412, view.screen.x - 2 * left)
        local lines = {}
        for _, row in ipairs(rows) do
            for i, text in ipairs(lines_of(screen, words(row[2]), " ", 12, width - 92)) do lines[#lines + 1] = { i == 1 and row[1] or "", text } end
        end
        -- In a low window the lines are closer to each other.
        local room = below - 2 * left - 56
        local is_low = room < 18 * #lines
        local line = is_low and math.max(13, (room + 16) / #lines) or 18
        frame(screen, left, left, width, (is_low and 40 or 56) + #lines * line)
        screen.text(vec(2 * left, left + (is_low and 17 or 22)), "Fettle", 20, ink, "left")
        screen.text(vec(2 * left + 72, left + (is_low and 19 or 24)), showcase.scene, 14, dim, "left")
        for i, row in ipairs(lines) do
            local y = left + (is_low and 27 or 36) + i * line
            screen.text(vec(2 * left + 50, y), row[1], 12, key_color, "right")
            screen.text(vec(2 * left + 64, y), row[2], 12, ink, "left")
        end
    end)
end

return help
