-- What a game of LÖVE expects of love.physics, tried with Fettle's bodies; with the argument --love with LÖVE's own, which
-- shows that the tests expect the right thing. Exit status 1 if one fails.

local tests, own = {}, false

local function near(value, expected, tolerance, what)
    if not value or math.abs(value - expected) > (tolerance or 1e-3) then
        error(("%s: expected %s, got %s"):format(what or "number", expected, tostring(value)), 2)
    end
end

local function run(world, steps)
    for _ = 1, steps do world:update(1 / 60) end
end

local function box(world, x, y, kind, width, height)
    local body = love.physics.newBody(world, x, y, kind)
    return body, love.physics.newFixture(body, love.physics.newRectangleShape(width or 30, height or width or 30), 1)
end

function tests.lengths_are_in_pixels()
    local world = love.physics.newWorld(0, 300)
    local body, fixture = box(world, 100, 50, "dynamic")
    near(body:getMass(), 1)
    run(world, 60)
    local x, y = body:getPosition()
    near(x, 100)
    near(y, 50 + 150, 6, "fall in a second")
    local vx, vy = body:getLinearVelocity()
    near(vy, 300, 1, "velocity")
    near(select(2, world:getGravity()), 300)
    assert(body:getType() == "dynamic" and fixture:getShape():getType() == "polygon")
    assert(#body:getFixtures() == 1 and body:getFixtures()[1] == fixture)
end

function tests.a_box_rests_on_a_chain_and_on_an_edge_from_both_windings()
    for _, points in ipairs { { 0, 100, 200, 100 }, { 200, 100, 0, 100 } } do
        for _, shape in ipairs { love.physics.newChainShape(false, points), love.physics.newEdgeShape(unpack(points)) } do
            local world = love.physics.newWorld(0, 300)
            love.physics.newFixture(love.physics.newBody(world, 0, 0), shape)
            local body = box(world, 100, 60, "dynamic")
            run(world, 120)
            near(body:getY(), 85, 1, "height")
        end
    end
end

function tests.impulses_and_forces_are_in_pixels()
    local world = love.physics.newWorld(0, 0)
    local body = box(world, 0, 0, "dynamic")
    body:applyLinearImpulse(60, 0)
    near(body:getLinearVelocity(), 60)
    for _ = 1, 60 do
        body:applyForce(0, 30)
        world:update(1 / 60)
    end
    near(select(2, body:getLinearVelocity()), 30, 0.1)
    body:setAngularVelocity(0)
    body:applyAngularImpulse(body:getInertia())
    near(body:getAngularVelocity(), 1, 1e-2)
    body:applyTorque(body:getInertia() * 60)
    world:update(1 / 60)
    near(body:getAngularVelocity(), 2, 1e-2)
end

function tests.callbacks_get_fixtures_and_contacts()
    local world = love.physics.newWorld(0, 300)
    local _, ground = box(world, 0, 100, "static", 300, 20)
    local body, fixture = box(world, 0, 50, "dynamic")
    ground:setUserData("ground")
    local begun, ended, solved, impulse = 0, 0, 0, 0
    world:setCallbacks(function(a, b, contact)
        assert(a:getUserData() == "ground" or b:getUserData() == "ground")
        assert(math.abs(select(2, contact:getNormal())) > 0.9)
        begun = begun + 1
    end, function() ended = ended + 1 end, function() solved = solved + 1 end,
        function(_, _, _, normal) impulse = math.max(impulse, normal) end)
    run(world, 120)
    assert(begun == 1 and ended == 0 and solved > 5 and impulse > 0)
    body:setPosition(0, -500)
    body:setAwake(true)  -- Fettle's setters do that themselves
    run(world, 2)
    assert(ended == 1)
    world:setCallbacks(nil, nil, function(_, _, contact) contact:setEnabled(false) end)
    body:setPosition(0, 60)
    run(world, 60)
    assert(body:getY() > 150 and fixture:getBody() == body)
end

function tests.an_error_in_a_callback_comes_out_of_update()
    local world = love.physics.newWorld(0, 300)
    box(world, 0, 100, "static", 300, 20)
    box(world, 0, 76, "dynamic")
    world:setCallbacks(nil, nil, function() error("too hard") end)
    local ok, message = pcall(run, world, 30)
    assert(not ok and message:find "too hard")
    if not own then
        world:setCallbacks(nil, nil, nil)
        run(world, 30)
    end
end

function tests.a_game_may_make_many_worlds_with_callbacks()
    local calls, forgotten = 0, setmetatable({}, { __mode = "k" })
    for i = 1, 600 do
        local world = love.physics.newWorld(0, 300)
        box(world, 0, 0, "dynamic")
        box(world, 5, 0, "dynamic")
        world:setCallbacks(nil, nil, function(_, _, contact) contact:setEnabled(world ~= nil) end)
        world:setContactFilter(function()
            calls = calls + (world and 1)
            return true
        end)
        run(world, 2)
        if i % 2 == 0 then world:destroy() else forgotten[world] = true end
    end
    assert(calls >= 600)
    if not own then
        collectgarbage()
        collectgarbage()
        local left = 0
        for _ in pairs(forgotten) do left = left + 1 end
        assert(left < 10, left .. " worlds that nothing refers to are left")
    end
end

function tests.rays_and_boxes_find_fixtures()
    local world = love.physics.newWorld(0, 0)
    local _, near_one = box(world, 100, 0, "static")
    local _, far_one = box(world, 200, 0, "static")
    local hits = {}
    world:rayCast(0, 0, 300, 0, function(fixture, x, y, nx)
        hits[fixture] = x
        near(nx, -1)
        return 1
    end)
    near(hits[near_one], 85, 0.5)
    near(hits[far_one], 185, 0.5)
    local found = {}
    world:queryBoundingBox(90, -5, 110, 5, function(fixture)
        found[#found + 1] = fixture
        return true
    end)
    assert(#found == 1 and found[1] == near_one)
    assert(near_one:testPoint(100, 0) and not near_one:testPoint(150, 0))
    near(near_one:getBoundingBox(), 85, 1)
end

function tests.joints_hold_and_drive()
    local world = love.physics.newWorld(0, 0)
    local hub = box(world, 0, 0, "static")
    local arm = box(world, 60, 0, "dynamic")
    local pin = love.physics.newRevoluteJoint(hub, arm, 0, 0)
    pin:setMotorSpeed(2)
    pin:setMaxMotorTorque(1e6)
    pin:setMotorEnabled(true)
    run(world, 60)
    near(pin:getJointAngle(), 2, 0.1, "angle")
    local x, y = arm:getPosition()
    near(math.sqrt(x * x + y * y), 60, 1, "radius")
    near(pin:getAnchors(), 0, 0.5)
    local other = box(world, 0, 200, "dynamic")
    local rod = love.physics.newDistanceJoint(hub, other, 0, 0, 0, 200)
    near(rod:getLength(), 200, 0.1)
    rod:setLength(150)
    local slider = box(world, 300, 0, "dynamic")
    local rail = love.physics.newPrismaticJoint(hub, slider, 300, 0, 1, 0)
    rail:setLimits(-30, 30)
    slider:setLinearVelocity(500, 0)
    run(world, 60)
    near(rail:getJointTranslation(), 30, 2, "limit")
    near(select(2, other:getPosition()), 150, 2, "rod")
    local mouse = love.physics.newMouseJoint(other, other:getPosition())
    mouse:setTarget(50, 50)
    mouse:destroy()
    for _, joint in ipairs { love.physics.newWeldJoint(hub, other, 0, 0), love.physics.newRopeJoint(hub, other, 0, 0, 0, 0, 90),
        love.physics.newWheelJoint(hub, other, 0, 0, 0, 1) } do
        assert(not joint:isDestroyed() and #joint:getType() > 0)
        joint:destroy()
    end
end

function tests.filters_say_who_collides()
    local world = love.physics.newWorld(0, 300)
    local _, ground = box(world, 0, 100, "static", 300, 20)
    local body, fixture = box(world, 0, 50, "dynamic")
    ground:setCategory(2)
    fixture:setMask(2)
    assert(ground:getCategory() == 2 and fixture:getMask() == 2)
    run(world, 90)
    assert(body:getY() > 150)
    local other, sensor = box(world, 0, 50, "dynamic")
    sensor:setSensor(true)
    assert(sensor:isSensor())
    run(world, 90)
    assert(other:getY() > 150)
end

function tests.properties_are_kept()
    local world = love.physics.newWorld(0, 0)
    local body, fixture = box(world, 10, 20, "dynamic")
    body:setLinearDamping(0.5)
    body:setFixedRotation(true)
    body:setBullet(true)
    body:setAngle(0.25)
    body:setUserData(world)
    fixture:setFriction(0.75)
    fixture:setRestitution(0.5)
    near(body:getLinearDamping(), 0.5)
    near(body:getAngle(), 0.25)
    near(fixture:getFriction(), 0.75)
    near(fixture:getRestitution(), 0.5)
    assert(body:isFixedRotation() and body:isBullet() and body:getUserData() == world)
    local x, y = body:getWorldPoint(10, 0)
    near(x, 10 + 10 * math.cos(0.25))
    near(y, 20 + 10 * math.sin(0.25))
    near(body:getLocalPoint(x, y), 10)
    body:setType "kinematic"
    assert(body:getType() == "kinematic" and world:getBodyCount() == 1)
end

function tests.what_was_destroyed_is_an_error()
    local world = love.physics.newWorld(0, 0)
    local body, fixture = box(world, 0, 0, "dynamic")
    fixture:destroy()
    assert(fixture:isDestroyed() and #body:getFixtures() == 0)
    body:destroy()
    assert(body:isDestroyed() and not pcall(body.getPosition, body) and not pcall(body.setAngle, body, 1))
    world:destroy()
    assert(world:isDestroyed() and not pcall(world.update, world, 1))
    local others = {}
    for i = 1, 1020 do  -- Fettle keeps the memory of a thousand destroyed worlds
        if i > 980 then others[#others + 1] = love.physics.newWorld(0, 0) end
        love.physics.newWorld(0, 0):destroy()
    end
    assert(not pcall(world.update, world, 1) and not pcall(world.getGravity, world))
    for _, other in ipairs(others) do other:update(1) end
end

function tests.wrong_arguments_are_errors_with_their_names()
    if own then return end  -- LÖVE has its own words
    local world = love.physics.newWorld(0, 0)
    local body, fixture = box(world, 0, 0, "dynamic")
    local other = love.physics.newBody(world, 9, 9, "static")
    local joint = love.physics.newRevoluteJoint(other, body, 0, 0)
    local function says(expected, f, ...)
        local ok, message = pcall(f, ...)
        message = tostring(message):gsub("^%S+:%d+: ", "")
        if ok or message ~= expected then
            error(("expected the error %q, got %q"):format(expected, ok and "none" or message), 2)
        end
    end
    says('Body:setPosition: y: expected a number, got nil', body.setPosition, body, 3)
    says('Body:setPosition: x: expected a number, got a string ("left")', body.setPosition, body, "left", 3)
    says('Body:setAwake: awake: expected a boolean, got a number (1)', body.setAwake, body, 1)
    says('Body:setX: expected a Body before the colon, got a number (3)', body.setX, 3)
    says('Body:getX: expected a Body before the colon, got a Fixture', body.getX, fixture)
    says('Body:getWorldPoints: coordinate: expected a number, got a boolean (true)', body.getWorldPoints, body, 1, true)
    says('Body:isTouching: other: expected a Body, got a table', body.isTouching, body, {})
    says('Fixture:setFriction: friction: expected a number, got a table', fixture.setFriction, fixture, {})
    says('World:setGravity: y: expected a number, got nil', world.setGravity, world, 1)
    says('World:rayCast: callback: expected a function, got nil', world.rayCast, world, 0, 0, 1, 1)
    says('World:update: dt: expected a number, got nil', world.update, world)
    says('newBody: world: expected a World, got nil', love.physics.newBody)
    says('newBody: x: expected a number, got a string ("a")', love.physics.newBody, world, "a")
    says('newFixture: shape: expected a Shape, got nil', love.physics.newFixture, body)
    says('RevoluteJoint:setMotorEnabled: enabled: expected a boolean, got nil', joint.setMotorEnabled, joint)
    says('newWeldJoint: body_2: expected a Body, got a number (0)', love.physics.newWeldJoint, body, 0, 0)
    says('newRevoluteJoint: x2: expected a number, got a string ("x")', love.physics.newRevoluteJoint, other, body, 0, 0, "x", 0)
    says('setMeter: pixels: expected a number, got nil', love.physics.setMeter)
    body:setPosition("4", 5)  -- a string of a number is a number in Lua
    near(body:getX(), 4)
    local _, message = pcall(function() body:setAngle() end)
    assert(message:find "main.lua:%d+: Body:setAngle: angle", message)
end

function love.load(arguments)
    own = arguments[1] == "--love"
    local own_physics = love.physics
    for name, test in pairs(require "coverage") do tests[name] = test end
    if not own then love.physics = require "fettle.physics" end
    local names, failed = {}, 0
    for name in pairs(tests) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do
        local ok, message = xpcall(function() tests[name](own_physics) end, debug.traceback)
        if not ok then
            failed = failed + 1
            print(name .. ": " .. message)
        end
    end
    print(("%d tests, %d failed"):format(#names, failed))
    love.event.quit(failed == 0 and 0 or 1)
end
