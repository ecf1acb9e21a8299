-- A bot plays as a player does: it sees what is near, and holds keys.

local ENEMY, GEM, SHOT = 2, 8, 16
local wishes = { "orbit", "nova", "storm", "might", "comet", "sparks", "haste", "heart", "swift", "magnet" }
local keys = { { "d" }, { "d", "w" }, { "w" }, { "w", "a" }, { "a" }, { "a", "s" }, { "s" }, { "s", "d" } }

-- Where to go: away from what hurts, to gems, not into a wall.
local function best_way()
    local at = world.hero.position
    local threats = {}
    for _, body in ipairs(world:overlap_box(at - vec(7, 7), at + vec(7, 7), ENEMY | SHOT)) do
        if not body:is_a(Spark) then
            threats[#threats + 1] = { body.position, body.velocity, body:is_a(Boss) and 8 or body:is_a(Orb) and 3 or 1 }
        end
    end
    local gem, nearest
    for _, body in ipairs(world:overlap_box(at - vec(9, 9), at + vec(9, 9), GEM)) do
        local far = (body.position - at):length()
        if not nearest or far < nearest then gem, nearest = vec(body.position), far end
    end
    local best, least = 1, math.huge
    for i = 1, 8 do
        local angle = (i - 1) * math.pi / 4
        local way = vec(math.cos(angle), math.sin(angle))
        local cost = 0
        for _, ahead in ipairs { 0.2, 0.5 } do
            local there = at + way * 5.2 * ahead
            for _, threat in ipairs(threats) do
                local far = (threat[1] + threat[2] * ahead - there):length()
                cost = cost + threat[3] / (0.15 + far * far)
            end
        end
        local there = at + way * 2.5
        cost = cost + 0.4 * math.max(0, math.abs(there.x) - 28) + 0.4 * math.max(0, math.abs(there.y) - 20)
        if gem then cost = cost - 0.8 * way:dot((gem - at):normalized()) end
        if cost < least then best, least = i, cost end
    end
    return best, least
end

local held = {}
local function hold(names)
    for _, key in ipairs { "w", "a", "s", "d" } do
        local wanted = false
        for _, name in ipairs(names) do wanted = wanted or name == key end
        if held[key] ~= wanted then
            held[key] = wanted
            input.keys[key] = wanted
        end
    end
end

local function rank(name)
    for i, wish in ipairs(wishes) do
        if wish == name then return i end
    end
end

-- Takes the wish that is highest on the list.
local function choose(t)
    hold {}
    t:steps(40)
    local best = night.choices[1]
    for _, name in ipairs(night.choices) do
        if rank(name) < rank(best) then best = name end
    end
    for _, key in ipairs { "up", "up", "down", "down" } do     -- from the card that was chosen last
        if interface.focus.go == best then break end
        t:tap(key)
        t:steps(2)
    end
    expect(interface.focus.go):is(best)
    t:tap("enter")
    t:steps(2)
end

local function play(t, ends)
    for _ = 1, 40000 do
        if night.menu == "choose" then choose(t)
        elseif ends() then return hold {}
        else
            local way, cost = best_way()
            hold(keys[way])
            if cost > 6 and world.hero.wait == 0 then t:tap("space") end
            t:steps(4)
        end
    end
end

local function begin(t)
    t:steps(20)
    t:tap("enter")
    t:steps(3)
    expect(night.running):is(true)
end

test("a bot wins the whole game", function(t)
    time.rewind_limit = 0
    begin(t)
    for _ = 1, 5 do                              -- it does not always win at once
        play(t, function() return night.menu == "over" end)
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

test("who stands still in the dark is put out, and begins again", function(t)
    begin(t)
    world.hero.hp = 10
    t:wait_until(function() return night.menu ~= "" and night.menu ~= "choose" end, 60)
    expect(night.menu):is("over")
    expect(store.scores[1].won):is(false)
    expect(world.hero.hp):is(0)
    t:steps(20)
    t:tap("enter")
    t:steps(5)
    expect(night.running):is(true)
    expect(world.hero.hp):is(100)
    expect(night.score):is(0)
    expect(#world.swarm:children()):below(3)
end)

test("keys, the mouse and a gamepad walk", function(t)
    begin(t)
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
    begin(t)
    t:steps(60)
    time.scale = 0.5
    t:steps(30)
    expect(time.scale):is(0.5)
    time.scale, time.paused = 1, true
    t:steps(5)
    expect(time.paused):is(true)
end)

test("a pause stands still, and its settings are kept", function(t)
    begin(t)
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
    begin(t)
    while night.menu == "choose" do choose(t) end
    night.clock = 80.0
    t:wait_until(function() return world.swarm:has("boss") end)
    world.hero.mercy = 100.0
    world.swarm.boss:hurt(100000, vec(0, 0))
    t:wait_until(function() return night.menu ~= "" end, 10)
    expect(night.menu):is("over")
    expect(night.won):is(true)
end)

test("enough gems are a level, and a gift is chosen", function(t)
    begin(t)
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
    begin(t)
    night.clock = 70.0
    t:wait_until(function() return world.swarm:has("boss") end)
    world.hero.mercy = 100.0
    world.swarm.boss:hurt(10000, vec(0, 0))
    t:steps(3)
    expect(#world.swarm:children()):is(0)
    for _ = 1, 600 do
        if night.menu == "choose" then choose(t) end
        t:steps(1)
    end
    expect(night.arena):is(2)
    expect(store.unlocked):is(2)
end)

test("a rewind brings back what was", function(t)
    begin(t)
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
