-- What the player relies on: what a rewind brings back and what it leaves, restarts, menus, gamepad.

local screens, rewind, things = require("screens"), require("rewind"), require("things")

local function play(t, number)
    store.unlocked = number
    t:steps(20)
    t:tap("enter")
    expect(screens.name):is("play")
    t:steps(5)
end

test("time turns back for a crate and its rope, and not for the ball", function(t)
    play(t, 3)
    local lift, ball = world.level.lift, world.level.ball
    t:wait(1)
    local up = vec(lift.position)
    t:click(world.level.rope:middle())
    t:wait(1)
    expect(lift.position.y):below(up.y - 2)
    expect(world.level.rope:holds()):falsy()
    local rolled = ball.position.x
    t:press("space")
    t:wait(1.5)
    t:release("space")
    t:steps(2)
    expect(lift.position):near(up, 0.01)
    expect(world.level.rope:holds()):truthy()
    expect(lift.type):is("dynamic")
    expect(ball.position.x):above(rolled)
end)

test("a rope of amber stays cut, and a spark stays collected", function(t)
    play(t, 1)
    t:click(world.level.rope:middle())
    t:wait_until(function() return screens.game.sparks() == 1 end)
    t:press("space")
    t:wait(2)
    expect(rewind.past()):near(0, 0.1)
    expect(world.level.rope:holds()):falsy()
    expect(screens.game.sparks()):above(0)
    t:release("space")
    t:wait_until(function() return screens.name == "won" end, 15)
    expect(screens.result.sparks):is(3)
end)

test("the dawn of a level is the end of going back, and the world stands still there", function(t)
    play(t, 4)
    t:wait(1)
    local gate = world.level.gate
    expect(gate.position.y):below(4)
    t:press("space")
    t:wait(3)
    local high = gate.position.y
    expect(high):near(4.9, 0.05)
    t:wait(1)
    expect(gate.position.y):near(high, 0.001)
    t:release("space")
    t:wait(1)
    expect(gate.position.y):below(4)
end)

test("a ball that falls out of the world begins again", function(t)
    play(t, 6)
    t:click(world.level.rope:middle())
    t:wait_until(function() return screens.name == "lost" end, 15)
    t:wait_until(function() return screens.name == "play" end, 2)
    expect(world.level.rope:holds()):truthy()
    expect(screens.game.sparks()):is(0)
end)

test("a gamepad plays: choose ropes, cut, turn back, pause, begin again", function(t)
    play(t, 11)
    local pad = input.gamepad_1
    local function tap(button)
        pad[button] = true
        t:steps(1)
        pad[button] = false
        t:steps(1)
    end
    for _ = 1, 2 do
        pad.left = vec(-1, 0)
        t:steps(2)
        pad.left = vec(0, 0)
        t:steps(2)
    end
    expect(things.chosen):is("hold")
    tap("dpad_right")
    expect(things.chosen):is_not("hold")
    tap("dpad_left")
    tap("a")
    expect(world.level.hold:holds()):falsy()
    t:wait(1)
    pad.right_trigger = 1
    t:steps(10)
    expect(rewind.active):truthy()
    pad.right_trigger = 0
    t:steps(3)
    expect(rewind.active):falsy()
    tap("start")
    expect(screens.name):is("pause")
    local at = time.step
    t:steps(10)
    expect(time.step):is(at)
    tap("b")
    expect(screens.name):is("play")
    tap("y")
    expect(world.level.hold:holds()):truthy()
end)

test("volumes are set, kept, and survive a rewind", function(t)
    play(t, 3)
    t:wait(1)
    t:tap("p")
    for _ = 1, 3 do t:tap("down") end
    t:steps(20)
    t:tap("enter")
    expect(screens.name):is("settings")
    t:tap("left")
    t:tap("left")
    expect(audio.buses.music.volume):near(0.5)
    expect(store.music):is(5)
    t:tap("escape")
    t:tap("escape")
    expect(screens.name):is("play")
    t:hold("space", 30)
    t:steps(3)
    expect(audio.buses.music.volume):near(0.5)
    expect(#sounds.music:children()):is(1)
end)

test("levels that are not reached cannot be played, and scores are erased when asked twice", function(t)
    play(t, 2)
    t:tap("p")
    t:tap("down")
    t:tap("down")
    t:steps(20)
    t:tap("enter")
    expect(screens.name):is("levels")
    t:steps(20)
    t:tap("right")
    t:tap("enter")
    expect(screens.name):is("levels")
    screens.back = "title"
    screens.open("settings")
    for _ = 1, 3 do t:tap("down") end
    t:steps(20)
    t:tap("enter")
    expect(store.unlocked):is(2)
    t:tap("enter")
    expect(store.unlocked):is(nil)
end)

test("playing on and on leaves nothing behind", function(t)
    play(t, 12)
    local count
    for round = 1, 6 do
        t:wait(1)
        t:hold("space", 40)
        t:tap("r")
        t:wait(2)
        if round == 2 then count = #game:all() end
    end
    expect(#game:all()):near(count, 2)
end)
