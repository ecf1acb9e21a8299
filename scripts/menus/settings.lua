-- A menu for the settings of a game, with keys to choose.

local actions = { { "Jump", "jump" }, { "Left", "left" }, { "Right", "right" } }

local function line(name, widget)
    return Row { Label { text = name, grow = 1 }, widget }
end

local function open_settings()
    local all = Column { spacing = 6, size = vec(440, 0),
        Label { text = "Settings", font = "bold", font_size = 28 },
        line("Volume", Slider { bind = "audio.volume" }),
        line("Gravity", Slider { bind = "game.gravity", min = 4, max = 40 }),
        Toggle { text = "Full screen", bind = "view.window.fullscreen" },
        Toggle { text = "Large letters", changed = function(e)
            interface.theme.font_size = e.value and 22 or 17
        end } }
    for _, action in ipairs(actions) do
        all:add(line(action[1], Button { bind = "input.actions." .. action[2], size = vec(220, 0) }))
    end
    local menu
    local function close() menu:delete() end
    all:add(Button { text = "Back", look = "accent", pressed = close })
    menu = Panel { modal = true, cancelled = close, all }
    game:add(menu, "settings")
end

return open_settings
