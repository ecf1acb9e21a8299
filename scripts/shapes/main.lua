-- One of each shape and of each joint, from a scene file that is easy to read and to edit: shapes.json. Everything is
-- live: try `world.shapes.ellipse.ellipse.radius_x = 1.5` in the console (the grave key), drag things with the mouse,
-- press R to begin again.

local function load_scene()
    world.shapes = nil
    scene.load("shapes.json", world)
end

function start()
    view.background = color("#20283d")
    view.center = vec(-1, 5.5)
    view.height = 17
    view.show.joints = true
    load_scene()
end

function key_pressed(key)
    if key == "r" then load_scene() end
end
