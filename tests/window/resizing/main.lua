-- A game for the test of the window: prints changes of its size and its keys.
print("ready", view.window.size)

view.window:watch("fullscreen", function(on) print("fullscreen", on) end)

function resized(width, height)
    print("resized", math.tointeger(width), math.tointeger(height))
    print("screen", view.screen)
end

function key_pressed(key)
    if key == "s" then
        view.window.size = vec(500, 300)
    else
        print("key", key)
    end
end
