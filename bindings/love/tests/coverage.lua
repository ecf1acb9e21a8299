-- Every function of love.physics and every method of its objects is there with Fettle's bodies.

local tests = {}

local function near(value, expected, tolerance, what)
    if not value or math.abs(value - expected) > (tolerance or 1e-3) then
        error(("%s: expected %s, got %s"):format(what or "number", expected, tostring(value)), 2)
    end
end

local function box(world, x, y, kind, width, height)
    local body = love.physics.newBody(world, x, y, kind)
    return body, love.physics.newFixture(body, love.physics.newRectangleShape(width or 30, height or width or 30), 1)
end

local function run(world, steps)
    for _ = 1, steps do world:update(1 / 60) end
end

-- An object of each class, made by the calls of love.physics.
local function one_of_each()
    local p, world = love.physics, love.physics.newWorld(0, 300)
    local a, fixture = box(world, 0, 100, "static", 200, 20)
    local b, c = box(world, 0, 76, "dynamic"), box(world, 100, 0, "dynamic")
    local hinge, other_hinge = p.newRevoluteJoint(a, b, 0, 76), p.newRevoluteJoint(a, c, 100, 0)
    local made = { World = world, Body = b, Fixture = fixture, PolygonShape = p.newRectangleShape(1, 1),
        CircleShape = p.newCircleShape(1), EdgeShape = p.newEdgeShape(0, 0, 1, 0), ChainShape = p.newChainShape(false, 0, 0, 1, 0, 2, 1),
        DistanceJoint = p.newDistanceJoint(b, c, 0, 76, 100, 0), RopeJoint = p.newRopeJoint(b, c, 0, 76, 100, 0, 200),
        RevoluteJoint = hinge, PrismaticJoint = p.newPrismaticJoint(b, c, 0, 0, 1, 0), WheelJoint = p.newWheelJoint(b, c, 0, 0, 0, 1),
        WeldJoint = p.newWeldJoint(b, c, 0, 0), MouseJoint = p.newMouseJoint(b, 0, 76), FrictionJoint = p.newFrictionJoint(b, c, 0, 0),
        MotorJoint = p.newMotorJoint(b, c), PulleyJoint = p.newPulleyJoint(b, c, 0, 0, 100, 0, 0, 76, 100, 50, 1),
        GearJoint = p.newGearJoint(hinge, other_hinge, 2) }
    local other = love.physics.newWorld(0, 300)
    box(other, 0, 100, "static", 200, 20)
    box(other, 0, 76, "dynamic")
    run(other, 10)
    made.Contact = other:getContacts()[1]
    return made
end

function tests.every_call_of_love_physics_is_there(own_physics)
    for name in pairs(own_physics) do assert(type(love.physics[name]) == "function", "physics." .. name) end
    for class, made in pairs(one_of_each()) do
        local methods = debug.getregistry()[class] or debug.getregistry().Joint
        -- LÖVE's own distance joint says that it is a "Joint".
        assert(class == "DistanceJoint" or made:type() == class and made:typeOf(class), class)
        assert(made:typeOf "Object" and not made:typeOf "Texture", class)
        for name in pairs(methods) do
            if not name:find "^_" then assert(type(made[name]) == "function", class .. "." .. name) end
        end
    end
end

function tests.joints_can_have_two_anchors_and_angles()
    local world = love.physics.newWorld(0, 0)
    local a, b = box(world, 0, 0, "static"), box(world, 100, 0, "dynamic")
    b:setAngle(0.5)
    local pin = love.physics.newRevoluteJoint(a, b, 20, 0, 80, 0, true)
    near(pin:getJointAngle(), 0, 1e-3)
    near(pin:getReferenceAngle(), 0.5, 1e-3)
    assert(pin:getCollideConnected())
    pin:setLimits(-1, 2)
    pin:setLimitsEnabled(true)
    pin:setLowerLimit(-0.5)
    assert(pin:hasLimitsEnabled() and pin:areLimitsEnabled())
    near(pin:getLowerLimit(), -0.5)
    near(pin:getUpperLimit(), 2)
    assert(not pcall(pin.setLimits, pin, 2, 1))
    b:setAngularVelocity(3)
    near(pin:getJointSpeed(), 3)
    near(love.physics.newWeldJoint(a, b, 0, 0, 100, 0, true, 0.25):getReferenceAngle(), 0.25)
    local rail = love.physics.newPrismaticJoint(a, b, 0, 0, 100, 0, 0, 2, true)
    local ax, ay = rail:getAxis()
    near(ax, 0)
    near(ay, 1)
    b:setAngularVelocity(0)
    b:setLinearVelocity(7, 40)
    near(rail:getJointSpeed(), 40, 0.01)
    near(rail:getJointTranslation(), 0, 0.01)
    local wheel = love.physics.newWheelJoint(a, b, 0, 0, 100, 0, 1, 0)
    near(wheel:getSpringFrequency(), 2)
    near(wheel:getSpringDampingRatio(), 0.7)
    near(wheel:getAxis(), 1)
    assert(#world:getJoints() == 4 and world:getJointCount() == 4 and #b:getJoints() == 4)
    wheel:destroy()
    assert(wheel:isDestroyed() and world:getJointCount() == 3)
end

function tests.a_frequency_of_0_is_rigid()
    for _, kind in ipairs { "Distance", "Weld" } do
        local world = love.physics.newWorld(0, 300)
        local a, b = box(world, 0, 0, "static"), box(world, 60, 0, "dynamic")
        local joint = kind == "Weld" and love.physics.newWeldJoint(a, b, 0, 0) or love.physics.newDistanceJoint(a, b, 0, 0, 60, 0)
        near(joint:getFrequency(), 0)
        joint:setFrequency(3)
        near(joint:getFrequency(), 3)
        joint:setFrequency(0)
        near(joint:getFrequency(), 0)
        run(world, 60)
        local x, y = b:getPosition()
        near(math.sqrt(x * x + y * y), 60, 1, kind)
        if kind == "Weld" then near(y, 0, 1, "weld") end
    end
end

function tests.friction_joints_brake()
    local world = love.physics.newWorld(0, 0)
    local a, b = box(world, 0, 0, "static"), box(world, 200, 0, "dynamic")
    local brake = love.physics.newFrictionJoint(a, b, 200, 0)
    brake:setMaxForce(60)
    brake:setMaxTorque(1e6)
    near(brake:getMaxForce(), 60)
    b:setLinearVelocity(30, 0)
    b:setAngularVelocity(5)
    run(world, 15)
    near(b:getLinearVelocity(), 15, 2, "braked by 60 px/s2")
    near(b:getAngularVelocity(), 0, 0.1)
    run(world, 60)
    near(b:getLinearVelocity(), 0, 0.1)
end

function tests.motor_joints_hold_offsets()
    local world = love.physics.newWorld(0, 0)
    local a, b = box(world, 0, 0, "static"), box(world, 90, 0, "dynamic")
    local drive = love.physics.newMotorJoint(a, b, 0.3)
    near(drive:getCorrectionFactor(), 0.3)
    near(drive:getLinearOffset(), 90, 0.01)
    drive:setMaxForce(1e6)
    drive:setMaxTorque(1e8)
    drive:setLinearOffset(60, 60)
    drive:setAngularOffset(1)
    run(world, 60)
    local x, y = b:getPosition()
    near(x, 60, 1)
    near(y, 60, 1)
    near(b:getAngle(), 1, 0.02)
end

function tests.pulleys_exchange_length()
    local world = love.physics.newWorld(0, 300)
    local heavy, light = box(world, 0, 200, "dynamic", 40), box(world, 200, 200, "dynamic")
    local pulley = love.physics.newPulleyJoint(heavy, light, 0, 0, 200, 0, 0, 200, 200, 200, 1)
    near(pulley:getLengthA(), 200, 0.01)
    near(pulley:getRatio(), 1)
    local gx, gy, hx = pulley:getGroundAnchors()
    near(gx + gy, 0)
    near(hx, 200)
    run(world, 45)
    assert(heavy:getY() > 205 and light:getY() < 195)
    near(pulley:getLengthA() + pulley:getLengthB(), 400, 1)
end

function tests.gears_turn_together()
    local world = love.physics.newWorld(0, 0)
    local hub = box(world, 0, 0, "static", 4)
    local a, b = box(world, 0, 0, "dynamic"), box(world, 200, 0, "dynamic")
    local first, second = love.physics.newRevoluteJoint(hub, a, 0, 0), love.physics.newRevoluteJoint(hub, b, 200, 0)
    local gear = love.physics.newGearJoint(first, second, 2)
    near(gear:getRatio(), 2)
    local one, other = gear:getJoints()
    assert(one == first and other == second)
    first:setMaxMotorTorque(1e7)
    first:setMotorSpeed(2)
    first:setMotorEnabled(true)
    run(world, 60)
    near(a:getAngle(), 2, 0.1)
    near(b:getAngle(), -1, 0.1, "angle a + 2 angle b stays")
end

function tests.masses_are_about_the_origin()
    local world = love.physics.newWorld(0, 0)
    local body = love.physics.newBody(world, 0, 0, "dynamic")
    local fixture = love.physics.newFixture(body, love.physics.newRectangleShape(30, 0, 30, 30), 2)
    local x, y, mass, inertia = body:getMassData()
    near(x, 30, 0.01)
    near(y, 0, 0.01)
    near(mass, 2, 0.01)
    near(inertia, 2 * (150 + 900), 1)
    local fx, _, fixture_mass, fixture_inertia = fixture:getMassData()
    near(fx, 30, 0.01)
    near(fixture_mass, 2, 0.01)
    near(fixture_inertia, 2 * (150 + 900) / 900, 0.01)
    near(body:getInertia(), inertia, 1)
    body:setMassData(10, 0, 4, 4 * 100 + 500)
    x, y, mass, inertia = body:getMassData()
    near(x, 10, 0.01)
    near(mass, 4)
    near(inertia, 900, 1)
    body:resetMassData()
    near(body:getMassData(), 30, 0.01)
end

function tests.shapes_are_measured_alone()
    local circle = love.physics.newCircleShape(10, 0, 5)
    assert(circle:testPoint(100, 0, math.pi / 2, 100, 10) and not circle:testPoint(100, 0, 0, 100, 10))
    local nx, ny, fraction = circle:rayCast(0, 0, 50, 0, 1, 0, 0, 0)
    near(nx, -1)
    near(ny, 0)
    near(fraction, 0.1)
    assert(not circle:rayCast(0, 20, 50, 20, 1, 0, 0, 0) and not circle:rayCast(0, 0, 50, 0, 0.05, 0, 0, 0))
    local left, top, right, bottom = circle:computeAABB(1, 2, 0)
    near(left, 6, 0.5)
    near(top, -3, 0.5)
    near(right, 16, 0.5)
    near(bottom, 7, 0.5)
    local x, y, mass = circle:computeMass(1)
    near(x, 10)
    near(y, 0)
    near(mass, math.pi * 25 / 900, 1e-3)
    local box_shape = love.physics.newRectangleShape(20, 10)
    assert(box_shape:validate() and box_shape:getChildCount() == 1 and box_shape:testPoint(0, 0, 0, 9, 4))
    local chain = love.physics.newChainShape(true, 0, 0, 10, 0, 10, 10)
    assert(chain:getVertexCount() == 4 and chain:getChildCount() == 3)
    near(chain:getPoint(2), 10)
    near(select(4, chain:getChildEdge(2):getPoints()), 10)
    near(circle:getPoint(), 10)
    local edge = love.physics.newEdgeShape(0, 0, 10, 0)
    assert(edge:getNextVertex() == nil)
    edge:setNextVertex(20, 0)
    near(edge:getNextVertex(), 20)
end

function tests.a_shape_without_its_numbers_is_an_error_where_it_is_made()
    local p = love.physics
    for _, make in ipairs { function() p.newCircleShape() end, function() p.newCircleShape("wide") end, function() p.newRectangleShape(4) end,
        function() p.newPolygonShape(0, 0, 1, 1) end, function() p.newPolygonShape { 0, 0, 1, 1, 2 } end, function() p.newEdgeShape(1) end,
        function() p.newChainShape(true, 0, 0, 1, 1) end, function() p.newChainShape(false, 0, 0, 1) end } do
        local ok, message = pcall(make)
        assert(not ok and message:find "coverage.lua", message)
    end
end

function tests.the_shape_of_a_fixture_is_its_own_and_can_change()
    local world = love.physics.newWorld(0, 0)
    local shape = love.physics.newCircleShape(10)
    local fixture = love.physics.newFixture(love.physics.newBody(world, 0, 0, "dynamic"), shape)
    shape:setRadius(50)
    assert(not fixture:testPoint(30, 0))
    fixture:getShape():setRadius(40)
    near(fixture:getShape():getRadius(), 40)
    assert(fixture:testPoint(30, 0))
    run(world, 1)
    local found = 0
    world:queryBoundingBox(35, -1, 38, 1, function()
        found = found + 1
        return true
    end)
    assert(found == 1)
end

function tests.fixtures_are_cast_and_have_distances()
    local world = love.physics.newWorld(0, 0)
    local _, left = box(world, 0, 0, "static")
    local _, right = box(world, 100, 0, "static")
    local distance, x1, _, x2 = love.physics.getDistance(left, right)
    near(distance, 70, 1)
    near(x1, 15, 1)
    near(x2, 85, 1)
    local nx, _, fraction = right:rayCast(0, 0, 170, 0, 1)
    near(nx, -1)
    near(fraction, 0.5, 0.01)
end

function tests.points_and_velocities_of_bodies()
    local world = love.physics.newWorld(0, 0)
    local body = box(world, 10, 0, "dynamic")
    body:setAngle(math.pi / 2)
    local x1, y1, x2, y2 = body:getLocalPoints(10, 5, 10, -5)
    near(x1, 5)
    near(y1, 0)
    near(x2, -5)
    near(y2, 0)
    body:setAngularVelocity(2)
    near(body:getLinearVelocityFromLocalPoint(5, 0), -10, 0.01)
    assert(body:isActive())
    body:setActive(false)
    body:setLinearVelocity(60, 0)
    run(world, 10)
    assert(not body:isActive() and math.abs(body:getX() - 10) < 1e-3)
    assert(#body:getFixtureList() == 1 and #body:getContactList() == 0)
end

function tests.contacts_have_two_points_and_both_fixtures()
    local world = love.physics.newWorld(0, 300)
    local ground = box(world, 0, 100, "static", 300, 20)
    local body, fixture = box(world, 0, 75, "dynamic")
    local begun
    world:setCallbacks(function(_, _, contact) begun = begun or { contact:getPositions() } end)
    run(world, 30)
    assert(#begun == 4, "a box touches in two points, got " .. #begun)
    near(math.abs(begun[1] - begun[3]), 30, 2)
    near(begun[2], 90, 1)
    local contact = body:getContacts()[1]
    local a, b = contact:getFixtures()
    assert((a == fixture or b == fixture) and world:getContactCount() == 1 and #ground:getContacts() == 1)
    assert(#{ contact:getPositions() } == 4 and contact:isEnabled() and contact:isTouching())
    local first, second = contact:getChildren()
    assert(first == 1 and second == 1)
    near(contact:getTangentSpeed(), 0)
end

function tests.a_ball_touches_where_it_hits()
    local world = love.physics.newWorld(0, 900)
    box(world, 0, 600, "static", 600, 20)
    local ball = love.physics.newBody(world, 7, 0, "dynamic")
    love.physics.newFixture(ball, love.physics.newCircleShape(20)):setRestitution(0.5)
    local begun
    world:setCallbacks(function(_, _, contact) begun = begun or { contact:getPositions() } end)
    run(world, 90)
    assert(#begun == 2)
    near(begun[1], 7, 0.5)
    near(begun[2], 590, 1.5)
end

function tests.belts_are_made_in_pre_solve(own_physics)
    local world = love.physics.newWorld(0, 300)
    local _, ground = box(world, 0, 100, "static", 3000, 20)
    local body, fixture = box(world, 0, 75, "dynamic")
    ground:setFriction(1)
    fixture:setFriction(1)
    local kept
    world:setCallbacks(nil, nil, function(_, _, contact)
        contact:setTangentSpeed(2)
        kept = contact
    end)
    run(world, 60)
    near(math.abs((body:getLinearVelocity())), 60, 6, "speed of the belt")
    -- What LÖVE does with a contact after the step is its business; here it is an error, not memory of C that is gone.
    if love.physics.setMeter ~= own_physics.setMeter then
        assert(not pcall(kept.setEnabled, kept, false) and not pcall(kept.setFriction, kept, 1))
    end
end

function tests.a_filter_says_who_may_collide()
    local world = love.physics.newWorld(0, 300)
    local _, ground = box(world, 0, 100, "static", 300, 20)
    local ghost, solid = box(world, -60, 50, "dynamic"), box(world, 60, 50, "dynamic")
    local asked = 0
    local function filter(a, b)
        asked = asked + 1
        assert(a == ground or b == ground)
        return a:getBody() ~= ghost and b:getBody() ~= ghost
    end
    world:setContactFilter(filter)
    assert(world:getContactFilter() == filter)
    run(world, 90)
    assert(asked > 0 and ghost:getY() > 150)
    near(solid:getY(), 75, 1)
    world:setContactFilter(nil)
    assert(world:getContactFilter() == nil)
end

function tests.the_origin_can_be_moved()
    local world = love.physics.newWorld(0, 0)
    local body = box(world, 50, 20, "dynamic")
    world:translateOrigin(30, 5)
    near(body:getX(), 20, 0.01)
    near(body:getY(), 15, 0.01)
    world:setSleepingAllowed(false)
    assert(not world:isSleepingAllowed())
end

return tests
