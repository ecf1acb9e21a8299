local bot = require("bot")

test("who stands still in the dark is put out, and begins again", function(t)
    bot.begin(t)
    world.hero.hp = 10
    t:wait_until(function() return night.menu ~= "" and night.menu ~= "choose" end, 60)
    expect(night.menu):is("over")
    expect(store.scores[1].won):is(false)
    expect(world.hero.hp):is(0)
    t:steps(20)
    t:tap("enter")
    t:steps(5)
    expect(night.running):is(true)
    expect(world.hero.hp):is(world.hero.max_hp)
    expect(night.score):is(0)
    expect(#world.swarm:children()):below(3)
end)

test("each lost night gives one gift more to begin with, up to six, until one is won", function(t)
    local function gifts()
        local sum = -1                           -- the sparks with which every night begins
        for _, arm in ipairs(world.arms:children()) do sum = sum + arm.level end
        return sum
    end
    bot.begin(t)
    for lost = 1, 8 do
        expect(gifts()):is(math.min(lost - 1, 6))
        world.hero.hp, world.hero.mercy = 1, 0
        world.hero:hurt(5)
        t:wait_until(function() return night.menu == "over" end, 10)
        t:steps(20)
        t:tap("enter")
        t:steps(5)
    end
    expect(night.subtitle):is("6 gifts to begin with")
    night:finish(true)
    expect(night.lost):is(0)
end)

test("each night that ends is among the eight best, or is forgotten", function(t)
    store.scores = {}
    for i = 1, 8 do store.scores[i] = { score = 1000 * (9 - i), arena = 1, kills = i, won = false } end
    t:steps(20)
    for ended, score in ipairs { 5500, 10, 9000 } do
        t:tap("enter")
        t:steps(5)
        night.score, world.hero.hp = score, 1
        world.hero:hurt(5)
        t:wait_until(function() return night.menu == "over" end, 10)
        t:steps(20)
        expect(#store.scores):is(8)
        expect(#display.over.scores.items):is(8)
        expect(display.over.scores.selected):is(({ 4, 0, 1 })[ended])
    end
    expect({ store.scores[1].score, store.scores[5].score, store.scores[8].score }):is { 9000, 5500, 3000 }
end)

test("keys, the mouse and a gamepad walk", function(t)
    bot.begin(t)
    input.gamepad_1.left = vec(0, 1)
    t:steps(30)
    expect(world.hero.position.y):above(1)
    input.gamepad_1.left = vec(0, 0)
    t:move_mouse(world.hero.position + vec(5, 0))
    input.mouse.left = true
    t:steps(30)
    input.mouse.left = false
    expect(world.hero.position.x):above(1)
    t:hold("a", 60)
    expect(world.hero.position.x):below(0)
    local x = world.hero.position.x
    t:press("d")
    t:tap("space")
    t:steps(10)
    expect(world.hero.position.x):above(x + 2)
end)

test("between menus, a pause and a scale of time that the console sets stay", function(t)
    bot.begin(t)
    t:steps(60)
    time.scale = 0.5
    t:steps(30)
    expect(time.scale):is(0.5)
    time.scale, time.paused = 1, true
    t:steps(5)
    expect(time.paused):is(true)
end)

test("a pause stands still, and its settings are kept", function(t)
    bot.begin(t)
    t:steps(60)
    t:tap("escape")
    t:steps(30)
    expect(night.menu):is("pause")
    expect(time.paused):is(true)
    local clock = night.clock
    t:tap("down")
    t:steps(12)
    t:tap("enter")
    t:steps(12)
    expect(night.menu):is("settings")
    t:tap("left")
    t:steps(2)
    expect(audio.buses.effects.volume):near(0.7)
    for _ = 1, 3 do t:tap("down") end
    t:steps(2)
    t:tap("enter")
    expect(settings.shake):is(false)
    t:tap("escape")
    t:steps(12)
    expect(night.clock):is(clock)
    t:tap("escape")
    t:steps(30)
    expect(time.paused):is(false)
    expect(night.clock):above(clock)
    t:rewind(1)
    expect(night.clock):below(clock)
    expect(audio.buses.effects.volume):near(0.7)
    expect(settings.shake):is(false)
end)

test("who has beaten the last boss sees the morning without another choice", function(t)
    night.first = 3
    bot.begin(t)
    while night.menu == "choose" do bot.choose(t) end
    night.clock = 80.0
    t:wait_until(function() return world.swarm:has("boss") end)
    world.hero.mercy = 100.0
    world.swarm.boss:hurt(100000, vec(0, 0))
    t:wait_until(function() return night.menu ~= "" end, 10)
    expect(night.menu):is("over")
    expect(night.won):is(true)
end)

test("enough gems are a level, and a gift is chosen", function(t)
    bot.begin(t)
    for i = 1, 7 do require("enemies").drop(vec(1 + 0.1 * i, 0), 1) end
    t:wait_until(function() return night.menu == "choose" end)
    expect(#night.choices):is(3)
    local name = night.choices[2]
    local before = arms.level(name)
    t:steps(40)
    t:tap("down")
    t:steps(2)
    t:tap("enter")
    t:steps(2)
    expect(arms.level(name)):is(before + 1)
    expect(world.hero.level):is(2)
end)

test("the end of a boss opens the next arena", function(t)
    bot.begin(t)
    night.clock = 70.0
    t:wait_until(function() return world.swarm:has("boss") end)
    world.hero.mercy = 100.0
    world.swarm.boss:hurt(10000, vec(0, 0))
    t:steps(3)
    expect(#world.swarm:children()):is(0)
    for _ = 1, 600 do
        if night.menu == "choose" then bot.choose(t) end
        t:steps(1)
    end
    expect(night.arena):is(2)
    expect(store.unlocked):is(2)
end)

test("a rewind brings back what was", function(t)
    bot.begin(t)
    t:steps(300)
    local crowd, at, clock = #world.swarm:children(), vec(world.hero.position), night.clock
    t:hold("d", 60)
    t:rewind(1)
    expect(night.clock):near(clock, 0.05)
    expect(world.hero.position):near(at, 0.3)
    expect(#world.swarm:children()):near(crowd, 3)
    t:steps(120)
end)

test("the title names the key that the player has chosen, and offers arenas when there is a choice", function(t)
    t:steps(20)
    expect(display.title.keys.text):contains(" space or A: dash")
    expect(display.title.arena.visible):is(false)
    input.actions.dash = { "left_control", "gamepad.a" }
    store.unlocked = 2
    t:tap("enter")
    t:steps(3)
    night:finish(false)
    t:wait_until(function() return night.menu == "over" end)
    night.menu = "title"
    t:steps(2)
    expect(display.title.keys.text):contains(" left control or A: dash")
    expect(display.title.arena.visible):is(true)
end)

test("the words of a card are drawn over its button", function(t)
    t:steps(5)
    for _, menu in ipairs(game:find("Menu")) do
        for _, card in ipairs(menu:children("Panel")) do expect(card:children()[1]):is(card.take) end
    end
    expect(game:find("Item")[1]:alive()):truthy()
end)
