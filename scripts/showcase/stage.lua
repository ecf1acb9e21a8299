-- The stage: where a scene stands while it is shown.

local stage = { names = { "pyramid", "stack", "slope", "compounds", "cradle", "playground" } }

function stage.show(name)
    if world:has("drag") then world.drag = nil end
    if world:has("stage") then world.stage = nil end
    world.gravity = vec(0, -10)
    world.stage = scene.load("showcase/" .. name .. ".json", world, "stage")
    view.center = world.stage.eye
    view.height = world.stage.eye_height
    view.show.joints = world.stage:has("show_joints") and world.stage.show_joints
    time.paused = false
end

--- Where new things are put.
function stage.place()
    return world.stage
end

return stage
