-- Balls of a hosted game, drawn by LÖVE; the grave key opens Fettle's console over them.
--
--     love GAME [--frames N PICTURE.png]     types a command, ends after N frames and saves the last one in the save folder

local host = require "fettle.host"
local scale = 32  -- pixels a meter

local function add_ball(name)
    balls[#balls + 1] = {
        position = game:property("world." .. name .. ".position"),
        angle = game:property("world." .. name .. ".angle"),
        radius = game:property("world." .. name .. ".circle.radius"),
    }
end

function love.load(arguments)
    if arguments[1] == "--frames" then frames, picture = tonumber(arguments[2]), arguments[3] end
    balls = {}
    game = host.new()
    game:add_function("ball_made", add_ball)
    game:run([[
        world.floor = Body { Box { width = 60, height = 1 }, type = "static" }
        function ball(n, at)
          local name = "ball_" .. n
          world[name] = Body { Circle { radius = 0.3 + 0.05 * (n % 5), restitution = 0.4 }, position = at }
          ball_made(name)
        end
        for i = 0, 59 do ball(i, vec(i % 10 - 4.5 + 0.1 * (i // 10), 4 + 1.2 * (i // 10))) end
    ]], "balls")
    console = require("fettle.console").attach(game)
    console:view(scale, 0, 0, -scale, 480, 580)
end

-- The input in the run that makes a picture.
local function act(frame)
    if frame == 20 then
        love.event.push("keypressed", "`", "`", false)
        love.event.push("keyreleased", "`", "`")
    elseif frame == 30 then
        love.event.push("textinput", "world.gravity = vec(2, -4)")
    elseif frame == 31 then
        love.event.push("keypressed", "return", "return", false)
        love.event.push("keyreleased", "return", "return")
    end
end

local frame = 0
function love.update(dt)
    frame = frame + 1
    if frames then act(frame) end
    local ok, message = pcall(game.frame, game, frames and 1 / 60 or dt)
    if not ok then print(message) end  -- it is in the console, too
end

function love.draw()
    love.graphics.clear(0.24, 0.31, 0.43)
    love.graphics.setColor(0.43, 0.55, 0.43)
    love.graphics.rectangle("fill", 0, 580 - scale / 2, 960, scale)
    for _, ball in ipairs(balls) do
        if ball.position:exists() then  -- the console may have deleted it
            local x, y = ball.position:vec2()
            local radius, angle = ball.radius:number(), ball.angle:number()
            local px, py = 480 + scale * x, 580 - scale * y
            love.graphics.setColor(0.98, 0.75, 0.28)
            love.graphics.circle("fill", px, py, radius * scale)
            love.graphics.setColor(0.24, 0.31, 0.43)
            love.graphics.line(px, py, px + radius * scale * math.cos(angle), py - radius * scale * math.sin(angle))
        end
    end
    love.graphics.setColor(1, 1, 1)
    if frame == frames then
        love.graphics.captureScreenshot(picture)
    elseif frames and frame > frames then
        local gravity = game:get "world.gravity"
        print(("gravity is %g, %g"):format(gravity.x, gravity.y))
        love.event.quit()
    end
end
