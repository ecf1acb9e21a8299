-- A bot plays the whole game with keys and the mouse, as a player would.

local screens = require("screens")

-- For each level: cut a rope, wait, hold the button that turns time back; seconds.
local solutions = {
    { { cut = "rope" } },
    { { cut = "left" }, { wait = 1.7 }, { cut = "right" } },
    { { wait = 2 }, { cut = "rope" }, { wait = 2.5 }, { back = 4 } },
    { { cut = "rope" }, { back = 9 } },
    { { wait = 1 }, { cut = "rope" }, { wait = 1.3 }, { back = 4 } },
    { { wait = 5 }, { cut = "rope" }, { wait = 0.5 }, { back = 7 } },
    { { cut = "thread" }, { wait = 1.9 }, { back = 3 } },
    { { wait = 8 }, { cut = "rope" }, { wait = 1.5 }, { back = 8 } },
    { { cut = "rope" }, { wait = 2 }, { cut = "thread" }, { wait = 3.4 }, { back = 6 } },
    { { wait = 0.5 }, { cut = "rope" }, { wait = 6 }, { back = 7 } },
    { { cut = "hold" }, { wait = 1.5 }, { cut = "thread" }, { wait = 0.7 }, { back = 3 } },
    { { wait = 0.5 }, { cut = "rope" }, { wait = 7 }, { cut = "thread" }, { wait = 2.7 }, { back = 14 } },
}

local function perform(t, action)
    if action.cut then
        local rope = world.level[action.cut]
        t:click(action.far and rope:middle():lerp(rope.anchor_a, action.far) or rope:middle())
    end
    if action.wait then t:wait(action.wait) end
    if action.back then
        t:press("space")
        t:wait(action.back)
        t:release("space")
    end
end

test("a bot wins the whole game", function(t)
    t:steps(20)
    t:tap("enter")
    for number, actions in ipairs(solutions) do
        expect(screens.name):is("play")
        expect(screens.game.level):is(number)
        for _, action in ipairs(actions) do perform(t, action) end
        t:wait_until(function() return screens.name == "won" end, 20)
        expect({ number, screens.result.sparks }):is({ number, 3 })
        t:steps(20)
        t:tap("enter")
    end
    expect(screens.name):is("finale")
    expect(store.unlocked):is(12)
    expect(#store.levels):is(12)
    t:steps(20)
    t:tap("enter")
    expect(screens.name):is("title")
end)
