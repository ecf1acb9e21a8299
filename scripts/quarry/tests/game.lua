-- A bot plays through the quarry with keys, as a player would, and meets everything that a mover can do.

local bot = { held = {}, met = {} }
local function hold(key, down)
    if (bot.held[key] or false) == down then return end
    bot.held[key] = down
    input.keys[key] = down
end

-- What it does at a place: to the right, unless it waits; whether it crouches, climbs or jumps.
local function think()
    local hero, at = world.hero, world.hero.position
    local right, down, up, jump = true, false, false, false
    if at.x > 18.9 and at.x < 24.6 then down = true end
    if at.x > 26.2 and at.x < 27 then right = world.lift.position.x < 28.8 end
    if hero.ground == world.lift then right = at.x < world.lift.position.x or world.lift.position.x > 33.3 end
    if at.x > 41 and at.x < 43.2 and at.y < 5.2 then jump = hero.on_ground and hero.on_wall end
    if at.x > 47.9 and at.x < 49.5 and at.y < 9.2 then
        right, up = false, true
        if at.x < 48.2 then right = true end
    end
    if at.y > 9.2 and at.x > 50 then
        if hero.on_ground then bot.plank = at.y < 10.3 and 0 or at.y < 11.3 and 1 or 2 end  -- to be reached
        local n = bot.plank or 0
        local goal = 54 + 2.4 * n
        right = at.x < goal - 0.2
        jump = hero.on_ground and (n == 0 and not right or n > 0 and at.x > goal - 1.7 and at.x < goal - 0.6)
    end
    return right, down, up, jump
end

test("a bot finds all gems", function(t)
    local hero = world.hero
    for _ = 1, 2400 do
        local right, down, up, jump = think()
        hold("right", right)
        hold("down", down)
        hold("up", up)
        if jump then t:tap("space") end
        t:steps(1)
        local met = bot.met
        met.slope = met.slope or hero.on_ground and hero.ground_normal.y < 0.95 and hero.position.x < 10
        met.crouched = met.crouched or hero.crouched
        met.lift = met.lift or hero.ground == world.lift
        met.crate = met.crate or hero.ground == world.crate
        met.climbed = met.climbed or hero.climbing
        if quarry.found == 7 then break end
    end
    expect(quarry.found):is(7)
    expect(quarry.falls):is(0)
    for _, what in ipairs { "slope", "crouched", "lift", "crate", "climbed" } do expect(bot.met[what]):is(true) end
end)

test("the miner drops through a plank and cannot stand up in the tunnel", function(t)
    local hero = world.hero
    hero.position = vec(54, 10.4)
    t:steps(30)
    expect(hero.position.y > 10.3):is(true)
    t:press("down")
    t:tap("space")
    t:release("down")
    t:steps(60)
    expect(hero.position.y < 9.4):is(true)
    t:press("down")
    t:steps(10)
    hero.position = vec(22, 3.27)
    t:steps(10)
    t:release("down")
    t:steps(30)
    expect(hero.crouched):is(true)
end)

test("the miner grasps the ladder with the key that was down before", function(t)
    local hero = world.hero
    hero.position = vec(47.4, 5.35)
    t:press("up")
    t:press("right")
    t:steps(30)
    expect(hero.climbing):is(true)
    t:release("right")
    t:steps(90)
    for _ = 1, 120 do  -- at the end of the ladder it does not fall
        t:steps(1)
        expect(hero.position.y > 8.8):is(true)
    end
    t:press("right")
    t:steps(60)
    expect(hero.position.x > 50 and hero.on_ground):is(true)
end)
