-- Prints a table: milliseconds of processor time a step of love.physics and of fettle.physics, and the final state of the scene in each.
--
--     love GAME [SECONDS] [SCENE ...]    SECONDS: the limit for a scene in an engine; 10 by default
--
-- Each engine makes as many steps as fit into the limit. The time of love.physics, and the final state of the scene in it, are compared with
-- those of Fettle after the same number of steps. The compatibility module gives Fettle the calls of love.physics.

local scenes = require "scenes"

local dt, meter = 1 / 60, 30

local function new_shape(physics, s)
    if s.box then return physics.newRectangleShape((s.x or 0) * meter, (s.y or 0) * meter, 2 * s.box[1] * meter, 2 * s.box[2] * meter) end
    if s.circle then return physics.newCircleShape(s.circle * meter) end
    local points = {}
    for i, number in ipairs(s.polygon or s.segment) do points[i] = number * meter end
    if s.segment then return physics.newEdgeShape(unpack(points)) end
    return physics.newPolygonShape(unpack(points))
end

local function new_body(physics, world, b)
    local body = physics.newBody(world, b.x * meter, b.y * meter, b.type)
    for _, s in ipairs(b.shapes) do
        local fixture = physics.newFixture(body, new_shape(physics, s), s.density or 1)
        fixture:setFriction(s.friction)
        if s.mask then fixture:setFilterData(s.category, s.mask, 0) end
    end
    if b.velocity then body:setLinearVelocity(b.velocity[1] * meter, b.velocity[2] * meter) end
    if b.turning then body:setAngularVelocity(b.turning) end
    if b.asleep then body:setAwake(false) end
    return body
end

--- A world with the scene in it: `step()`, `motions()` (x, y, angle and x of the velocity of each body) and `free()`.
local function make(physics, scene)
    physics.setMeter(meter)
    local world, bodies, time = physics.newWorld(0, scene.gravity * meter, scene.sleeping), {}, 0
    for i, b in ipairs(scene.bodies) do bodies[i] = new_body(physics, world, b) end
    for _, p in ipairs(scene.pins) do
        local pin = physics.newRevoluteJoint(bodies[p.a], bodies[p.b], p.x * meter, p.y * meter, false)
        if p.speed then
            pin:setMotorSpeed(p.speed)
            pin:setMaxMotorTorque(p.torque * meter * meter)
            pin:setMotorEnabled(true)
        end
    end
    local made = {}
    function made.step()
        time = time + dt
        for i, b in ipairs(scene.bodies) do
            if b.path then
                local x, y = b.path(time)
                local at_x, at_y = bodies[i]:getPosition()
                bodies[i]:setLinearVelocity((x * meter - at_x) / dt, (y * meter - at_y) / dt)
            end
        end
        world:update(dt)
    end
    function made.motions()
        local found = {}
        for i, body in ipairs(bodies) do
            local x, y = body:getPosition()
            local vx = body:getLinearVelocity()
            found[i] = { x = x / meter, y = y / meter, angle = body:getAngle(), vx = vx / meter }
        end
        return found
    end
    function made.free() world:destroy() end
    return made
end

--- Makes `most` steps of a scene, or as many as fit into `seconds`. Returns their number, their processor time in ms, and the motions.
local function run(physics, scene, most, seconds)
    local made = make(physics, scene)
    collectgarbage()
    local began, limit, steps = os.clock(), love.timer.getTime() + seconds, 0
    repeat
        made.step()
        steps = steps + 1
    until steps >= most or love.timer.getTime() >= limit
    local time, motions = (os.clock() - began) * 1000, made.motions()
    made.free()
    return steps, time, motions
end

local row = "%-16s%-15s%5s%11s%10s  %s"

function love.load(arguments)
    local fettle, seconds, wanted = require "fettle.physics", tonumber(arguments[1]) or 10, {}
    for i = 2, #arguments do wanted[arguments[i]] = true end
    io.stdout:setvbuf("line")
    print(row:format("scene", "engine", "steps", "ms a step", "x Fettle", "final state"))
    for _, name in ipairs(scenes.names) do
        if next(wanted) == nil or wanted[name] then
            local scene = scenes.make(name)
            local steps, time, motions = run(fettle, scene, scene.steps, seconds)
            print(row:format(name, "fettle.physics", steps, ("%.3f"):format(time / steps), "1.00", scene.figure(motions, scene)))
            steps, time, motions = run(love.physics, scene, scene.steps, seconds)
            local _, ours, then_ = run(fettle, scene, steps, math.huge)
            print(row:format(name, "love.physics", steps, ("%.3f"):format(time / steps), ("%.2f"):format(time / ours),
                scene.figure(motions, scene) .. "; Fettle then " .. scene.figure(then_, scene):match "%S+$"))
        end
    end
    love.event.quit()
end
