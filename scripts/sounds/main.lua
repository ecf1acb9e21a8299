-- A workshop for sounds without files. The keys 1 to 6 play the presets, M changes the chosen one by chance, and the picture is
-- the form of its wave. Every number is live: try `synths.coin.arpeggio = 12` in the console (the grave key), or drag it in the
-- inspector while the siren (S) goes round: it is heard from where it is.

local names = { "coin", "jump", "hit", "explosion", "blip", "power_up" }
local ink, dim, gold = color("#eceef0"), color("#7d8590"), color("#ffc53d")
local columns, form = 240, {}

game.synths = Object {}
for _, name in ipairs(names) do synths[name] = Synth[name]() end
game.chosen = Object { name_of = "coin" }

world.gravity = vec(0, 0)
world.siren = Body {
    type = "kinematic", position = vec(0, -4), Circle { radius = 0.4, color = gold },
    tone = Synth { wave = "triangle", frequency = 600, vibrato = 4, vibrato_rate = 2, sustain = 2, decay = 0,
                   volume = 0.4, loop = true, range = 14 },
}

local function synth() return synths[chosen.name_of] end

local function draw_again() form = synth():wave_form(columns) end

local function choose(name)
    chosen.name_of = name
    draw_again()
    synth():play()
end

function start()
    view.background = color("#12161c")
    view.height = 16
    draw_again()
    watch("synths.*.*", draw_again)
end

function step()
    local angle = 0.8 * time.now
    world.siren.position = vec(10 * math.cos(angle), -4 + 2 * math.sin(angle))
end

local commands = {
    space = function() synth():play() end,
    m = function() synth():mutate(0.3) synth():play() end,
    r = function() synth():preset(chosen.name_of) synth():play() end,
    s = function()
        local tone = world.siren.tone
        if #tone:children() > 0 then tone:stop(0.3) else tone:play { fade = 0.3 } end
    end,
    up = function() audio.volume = math.min(1, audio.volume + 0.1) end,
    down = function() audio.volume = math.max(0, audio.volume - 0.1) end,
    p = function() time.paused = not time.paused end,
}

function key_pressed(key)
    local name = names[tonumber(key)]
    if name then choose(name) elseif commands[key] then commands[key]() end
end

local function draw_wave(pen, left, width, middle, height)
    local step = width / columns
    for i, extremes in ipairs(form) do
        local x = left + (i - 0.5) * step
        pen.line(vec(x, middle - height * extremes.y), vec(x, middle - height * extremes.x), "turquoise", step)
    end
    for _, voice in ipairs(synth():children()) do
        local x = left + width * math.min(1, voice.time / synth().duration)
        pen.line(vec(x, middle - height), vec(x, middle + height), gold, 2)
    end
end

local help = "1-6 play    M mutate    R reset    Space again    S siren    P pause    up, down volume"

-- Returns the lower edge of the text. Single spaces do not end a line: a key stays beside what it does.
local function draw_text(screen, text, size, left, top)
    text = text:gsub("(%g) (%g)", "%1\u{A0}%2")
    local width = view.screen.x - 2 * left
    local _, height = screen.text_size(text, size, nil, width)
    screen.text(vec(left, top + height / 2), text, size, dim, "left", nil, width)
    return top + height
end

function draw(pen)
    pen.screen(function(screen)
        local left, first = view.screen.x < 600 and 24 or 40, view.screen.y < 400 and 28 or 44
        local width = view.screen.x - 2 * left
        screen.text(vec(left, first), "Sounds", 26, ink, "left")
        local top = draw_text(screen, help, 14, left, first + 20) + 24
        local in_row = math.max(1, math.min(#names, width // 115))
        local column = math.min(140, width / in_row)
        for i, name in ipairs(names) do
            local place = vec(left + column * ((i - 1) % in_row), top + 26 * ((i - 1) // in_row))
            screen.text(place, i .. "  " .. name, 17, name == chosen.name_of and gold or ink, "left")
        end
        top = top + 26 * math.ceil(#names / in_row)
        -- A wave may be somewhat higher than 1.
        local height = math.max(10, math.min(75, (view.screen.y - top - 70) / 2.8))
        draw_wave(screen, left, width, top + 1.4 * height, height)
        local figures = string.format("%.2f s    %.0f Hz    %s    %d voices    volume %.1f", synth().duration, synth().frequency,
            synth().wave, #audio.voices, audio.volume)
        draw_text(screen, figures, 15, left, top + 2.8 * height + 14)
    end)
end
