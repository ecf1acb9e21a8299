-- Boxes and balls that the mouse drags. With the argument --love the bodies are those of LÖVE, for comparison:
--
--     love GAME [--love] [--frames N PICTURE.png]     ends after N frames and saves the last one in the save folder
--     love GAME --speed [--love]                      steps a second of a pyramid of 820 boxes

local options = {}
function love.load(arguments)
    for i, word in ipairs(arguments) do options[word:match "^%-%-(%w+)" or i] = i end
    if not options.love then love.physics = require "fettle.physics" end
    if options.speed then return measure() end
    love.physics.setMeter(40)
    world = love.physics.newWorld(0, 10 * 40)
    touches = 0
    world:setCallbacks(function() touches = touches + 1 end)
    ground = love.physics.newBody(world, 400, 580)
    love.physics.newFixture(ground, love.physics.newRectangleShape(720, 40))
    things = {}
    love.math.setRandomSeed(3)
    for i = 1, 60 do
        local body = love.physics.newBody(world, 240 + love.math.random() * 320, 540 - 9 * i, "dynamic")
        local size = 12 + love.math.random() * 28
        local shape = i % 3 == 0 and love.physics.newCircleShape(size / 2) or love.physics.newRectangleShape(size, size)
        love.physics.newFixture(body, shape, 1):setRestitution(0.2)
        things[i] = { body = body, shape = shape }
    end
end

function measure()
    love.physics.setMeter(30)
    local world, m = love.physics.newWorld(0, 300, false), 30
    love.physics.newFixture(love.physics.newBody(world, 0, 15), love.physics.newRectangleShape(200 * m, m))
    for row = 0, 39 do
        for i = 1, 40 - row do
            local x, y = 1.1 * (i - (40 - row) / 2) * m, -(0.5 + 1.05 * row) * m
            love.physics.newFixture(love.physics.newBody(world, x, y, "dynamic"), love.physics.newRectangleShape(m, m), 1)
        end
    end
    world:update(1 / 60)
    local count, begin = 0, love.timer.getTime()
    while love.timer.getTime() - begin < 3 do
        world:update(1 / 60)
        count = count + 1
    end
    print(("%s: %.0f steps a second"):format(options.love and "love.physics" or "fettle", count / 3))
    love.event.quit()
end

function love.mousepressed(x, y)
    world:queryBoundingBox(x, y, x + 1, y + 1, function(fixture)
        if fixture:getBody():getType() == "dynamic" and fixture:testPoint(x, y) then
            drag = love.physics.newMouseJoint(fixture:getBody(), x, y)
            return false
        end
        return true
    end)
end
function love.mousemoved(x, y) if drag then drag:setTarget(x, y) end end
function love.mousereleased()
    if drag then drag:destroy() end
    drag = nil
end

local frames = 0
function love.update()
    if options.speed then return end
    world:update(1 / 60)
    frames = frames + 1
    local last = options.frames and tonumber(arg[#arg - 1])
    if frames == last then
        print(touches .. " touches")
        love.graphics.captureScreenshot(arg[#arg])
    end
    if last and frames > last + 2 then love.event.quit() end
end

function love.draw()
    if options.speed then return end
    love.graphics.clear(0.13, 0.14, 0.16)
    love.graphics.setColor(0.41, 0.41, 0.41)
    love.graphics.rectangle("fill", 40, 560, 720, 40)
    local colors = { { 1, 0.39, 0.28 }, { 1, 0.84, 0 }, { 0.53, 0.81, 0.92 } }
    for i, thing in ipairs(things) do
        love.graphics.setColor(colors[i % 3 + 1])
        if thing.shape:getType() == "circle" then
            local x, y = thing.body:getPosition()
            love.graphics.circle("fill", x, y, thing.shape:getRadius())
        else
            love.graphics.polygon("fill", thing.body:getWorldPoints(thing.shape:getPoints()))
        end
    end
end
