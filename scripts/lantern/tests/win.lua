-- A bot plays the whole game with keys, as a player would.

local bot = require("bot")

test("a bot wins the whole game", function(t)
    time.rewind_limit = 0
    bot.begin(t)
    for _ = 1, 5 do                              -- it does not always win at once
        bot.play(t, function() return night.menu == "over" end)
        if night.won then break end
        t:steps(30)
        t:tap("enter")
        t:steps(3)
    end
    expect(night.won):is(true)
    expect(night.score):above(50000)
    expect(store.scores[1].score):is(night.score)
    expect(store.unlocked):is(3)
    t:steps(30)
    t:tap("enter")
    t:steps(30)
    expect(night.running):is(true)
    expect(night.first):is(1)
    expect(#game:all("Object")):below(500)       -- nothing of the last run is left
end)
