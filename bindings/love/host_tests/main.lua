-- What a game of LÖVE does with a hosted game. Exit status 1 if a test fails.

local host = require "fettle.host"
local tests = {}

local function near(value, expected, tolerance)
    if not value or math.abs(value - expected) > (tolerance or 1e-9) then
        error(("expected %s, got %s"):format(expected, tostring(value)), 2)
    end
end

local function new()
    local game = host.new { console = false }
    game:run "world.ball = Body { Circle {}, position = vec(1, 5) }"
    return game
end

function tests.values_are_read_and_written()
    local game = new()
    local position = game:get "world.ball.position"
    assert(position.x == 1 and position.y == 5)
    game:set("world.ball.position", { x = 2, y = 7 })
    near(game:get "world.ball.position.x", 2)
    game:set("world.ball.type", "static")
    assert(game:get "world.ball.type" == "static")
    game:set("world.ball.bullet", true)
    assert(game:get "world.ball.bullet" == true)
    game:run "game.list = {} game.goal = world.ball"
    game:set("list", { 1, "two", { x = 3, y = 4 } })
    local list = game:get "list"
    assert(#list == 3 and list[2] == "two" and list[3].y == 4)
    local goal = game:get "goal"
    game:set("goal", goal)
    assert(game:get "goal" == goal)
    local names = {}
    for _, path in ipairs(game:children "world") do names[path] = true end
    assert(names["world.ball"])
end

function tests.properties_are_fast_and_end_with_their_instance()
    local game = new()
    local position, y = game:property "world.ball.position", game:property "world.ball.position.y"
    for _ = 1, 30 do game:frame(1 / 60) end
    local px, py = position:vec2()
    assert(px == 1 and py < 4.5 and py == y:number())
    local sum = 0
    for _ = 1, 1e6 do sum = sum + y:number() end
    near(sum / 1e6, py, 1e-6)
    y:set(9)
    near(y:get(), 9)
    game:run "world.ball:delete()"
    assert(not y:exists())
    local ok, message = pcall(y.number, y)
    assert(not ok and message:find "world.ball was deleted")
end

function tests.errors_have_the_message_of_fettle()
    local game = new()
    local ok, message = pcall(game.run, game, "world.ball.velocty = vec(1, 1)", "start.lua")
    assert(not ok and message:find "start.lua:1: " and message:find "velocity", message)
    ok, message = pcall(game.set, game, "world.ball.mass", -1)
    assert(not ok and message:find "world.ball.mass: expected a number of at least", message)
    assert(not pcall(game.set, game, "world.ball.mass", print))
end

function tests.scripts_call_functions_of_love()
    local game = new()
    game:add_function("twice", function(n) return 2 * n end)
    game:add_function("fails", function() error "no luck" end)
    local value, output = game:evaluate "twice(1.25)"
    assert(value == 2.5 and output == "2.5")
    local ok, message = pcall(game.evaluate, game, "fails()")
    assert(not ok and message:find "no luck")
    game:run "function hear(a, b) game.heard = a .. b end"
    game:call("hear", "x", "y")
    assert(game:get "heard" == "xy")
    for _ = 1, 1000 do game:evaluate "twice(2)" end
    for i = 1, 1200 do game:add_function("twice", function(n) return i * n end) end
    assert(game:evaluate "twice(2)" == 2400)
    local ok, message = pcall(game.add_function, game, "nothing", nil)
    assert(not ok and message:find "Game:add_function: f: expected a function, got nil", message)
end

function tests.wrong_arguments_are_errors_with_their_names()
    local game = new()
    for expected, f in pairs {
        ["Game:get: path: expected a string, got nil"] = function() game:get() end,
        ["Game:frame: dt: expected a number, got a table"] = function() game:frame({}) end,
        ["Game:run: expected a Game before the colon, got a string (\"x = 1\")"] = function() game.run("x = 1") end,
    } do
        local ok, message = pcall(f)
        assert(not ok and message:find(expected, 1, true), message)
    end
end

function tests.a_closed_game_is_an_error()
    local game = new()
    game:close()
    assert(not pcall(game.frame, game, 0.1))
    for _ = 1, 5 do
        new()
        collectgarbage()
    end
end

function love.load()
    local names, failed = {}, 0
    for name in pairs(tests) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do
        local ok, message = xpcall(tests[name], debug.traceback)
        if not ok then
            failed = failed + 1
            print(name .. ": " .. message)
        end
    end
    print(("%d tests, %d failed"):format(#names, failed))
    love.event.quit(failed == 0 and 0 or 1)
end
