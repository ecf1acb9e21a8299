-- A game that prints its input and its changes, so that a test can see which keys reach it and which edits take effect.

view.height = 20

world.floor = Body { type = "static", position = vec(0, -9), Box { width = 40, height = 2 } }
world.crate = Body { position = vec(-6, -7), Box { width = 2, height = 2, color = color("steelblue") } }
world.ball = Body { type = "static", position = vec(-10, -6), Circle { radius = 1 } }

world:watch("gravity", function(new) print("gravity is", new) end)
world.crate:watch("mass", function(new) print("mass is", new) end)
world.crate:watch("gravity_scale", function(new) print("gravity_scale is", new) end)

function key_pressed(key)
    print("game got", key)
    if key == "l" then print("for ever") while true do end end
end
function closing() print("closing") end
function mouse_pressed() print("game got a click") end
function start() print("ready") end
