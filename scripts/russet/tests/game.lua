-- A bot plays the whole game with keys, as a player would: it looks at the map and at what moves.

local function feet(hero) return hero.position.y - 0.55 end

-- Whether one can stand at x, at most 3 m below y.
local function ground_at(level, x, y)
    for n = 0, 3 do
        local cell = level.map:cell_at(vec(x, y - 0.3 - n))
        if level.map:tile(cell.x, cell.y, "water") > 0 then return false end
        if level.map:tile(cell.x, cell.y, "ground") > 0 then return true end
    end
    return false
end

local function hurts(level, x, y)
    local cell = level.map:cell_at(vec(x, y))
    local tile = level.map:tile(cell.x, cell.y, "decor")
    return tile > 0 and level.map:tile_property(tile, "hurts")
end

-- Where it goes besides to the right: the way to a key, by level; offsets to the key.
local ways = {
    [2] = { vec(0, -4), vec(4, -2), vec(0, 0) },
    [3] = { vec(4.5, -2), vec(0.5, 0) },
    [4] = { vec(-3, -4.5), vec(0, 0) },
}

local bot = { floor = 0, held = {}, stage = 1, last = 0, stuck = 0, lost = 0 }
local function hold(t, key, down)
    if (bot.held[key] or false) == down then return end
    bot.held[key] = down
    if down then t:press(key) else t:release(key) end
end

local function lift_for(level, at)
    for _, lift in ipairs(level.map.things:children("Lift")) do
        local left, right = lift.home.x - 1.6, lift.home.x + lift.dx + 1.6
        if at.x > left - 0.9 and at.x < right then return lift end
    end
end

-- One decision: way to run (-1, 0, 1) and whether to jump.
local function think(level)
    local hero = level.hero
    local at, y, things = hero.position, feet(hero), level.map.things
    local way, jump = 1, false
    local goal
    if things:has("boar") then
        local boar = things.boar
        local d = boar.position.x - at.x
        if at.x < 9.5 then return 1, false end
        if boar:state() == "stun" then
            way = math.abs(d) < 0.4 and 0 or d > 0 and 1 or -1
            return way, hero.grounded and math.abs(d) < 3.2 or not hero.grounded and hero.velocity.y > 0
        end
        if boar:state() == "charge" then
            local near = math.abs(d) < 4.2 and (d > 0) == (boar.way < 0)
            return near and -boar.way or d * boar.way > 0 and boar.way or 0, near or hero.velocity.y > 0
        end
        return at.x < 15 and 1 or at.x > 28 and -1 or 0, false
    end
    local keys = things:children("Key")
    if not hero.key and #keys > 0 and not keys[1].taken and ways[level.number] then
        local place, route = keys[1].position, ways[level.number]
        if bot.stage == 1 and at.x > place.x - 9 or bot.stage > 1 then
            goal = place + route[math.min(bot.stage, #route)]
            local there = math.abs(at.x - goal.x) < 0.6 and math.abs(y - (goal.y - 0.5)) < 0.4 and hero.grounded
            if (there or hero.velocity.y > 16) and bot.stage < #route then bot.stage = bot.stage + 1 end
            if bot.stage > 1 and hero.grounded and y < place.y + route[bot.stage - 1].y - 1.5 then bot.stage = 1 end
        end
    end
    if goal then
        local d = goal.x - at.x
        way = math.abs(d) < 0.3 and 0 or d > 0 and 1 or -1
        if goal.y - 0.5 > y + 0.5 and math.abs(d) < 3.4 then jump = true end
    end
    local lift = not goal and lift_for(level, at)
    if hero.grounded and bot.leaving and time.step > bot.leaving + 5 then bot.leaving = nil end
    if lift and bot.leaving and bot.left ~= lift then bot.leaving = nil end
    if lift and not bot.leaving then
        local top, riding = lift.position.y + 0.25, math.abs(lift.position.x - at.x) < 1.3 and math.abs(y - lift.position.y - 0.25) < 0.3
        if riding then
            if lift.dx > 0 then
                if lift.position.x > lift.home.x + lift.dx - 0.6 then
                    if at.x > lift.position.x + 0.6 then bot.leaving, bot.left = time.step, lift return 1, true end
                    return 1, false
                end
                return math.abs(at.x - lift.position.x) < 0.2 and 0 or at.x < lift.position.x and 1 or -1, false
            end
            if lift.position.y > lift.home.y + lift.dy - 0.5 then bot.leaving, bot.left = time.step, lift return 1, true end
            return math.abs(at.x - lift.position.x) < 0.2 and 0 or at.x < lift.position.x and 1 or -1, false
        end
        if at.x < lift.home.x - 0.9 and hero.grounded then
            local edge = not ground_at(level, at.x + 0.5 + math.max(0, hero.velocity.x) * (level.number == 4 and 0.22 or 0.05), y)
            if not edge then return 1, false end
            local gap = lift.position.x - 1 - at.x
            local ready = lift.dx > 0 and gap < 2.4 and lift.velocity.x <= 0.3 or lift.dy > 0 and math.abs(top - y) < 0.6
            if not ready then return ground_at(level, at.x + 0.6, y) and 0 or -1, false end
            return 1, true
        end
        if not hero.grounded and at.x < lift.home.x + lift.dx + 0.5 and y > top - 0.3 then
            local d = lift.position.x - at.x
            return math.abs(d) < 0.3 and 0 or d > 0 and 1 or -1, hero.velocity.y > 0 and d > 0.5
        end
    end
    if hero.grounded then bot.floor, bot.sprung = y, false end
    if hero.velocity.y > 15 then bot.sprung = true end
    if not hero.grounded then
        -- It brakes where it would land in a gap or on spikes, but not on the way that a spring has sent it.
        local v, fall = hero.velocity, 38
        local left = (v.y + math.sqrt(math.max(0, v.y * v.y + 2 * fall * (y - bot.floor)))) / fall
        local land = at.x + v.x * left
        local bad = function(x) return not ground_at(level, x, bot.floor + 0.2) or hurts(level, x, bot.floor + 0.3) or hurts(level, x + 0.4, bot.floor + 0.3) end
        if not goal and not bot.sprung and v.y < 11 and bad(land) and not bad(at.x + 0.3) then way = -1 end
        return way, jump or v.y > 0
    end
    local ahead = at.x + way * 0.75
    -- A crate is pushed until it is at a wall.
    for _, crate in ipairs(things:children("Crate")) do
        local d = (crate.position.x - at.x) * way
        if d > 0 and d < 1.3 and math.abs(crate.position.y - at.y) < 0.8 then
            return way, level:solid(crate.position + vec(way * 0.62, 0))
        end
    end
    if way ~= 0 then
        local slope = level.map:tile(level.map:cell_at(vec(ahead, y + 0.3)).x, level.map:cell_at(vec(ahead, y + 0.3)).y, "ground")
        if level:solid(vec(ahead, y + 0.4)) and slope ~= 17 and slope ~= 18 then jump = true end
        if not ground_at(level, at.x + way * 0.45, y) then jump = true end
        if hurts(level, at.x + way, y + 0.3) then jump = true end
        for _, enemy in ipairs(things:children("Enemy")) do
            local d = enemy.position - at
            if not enemy.dead and d.x * way > 0 and d.x * way < 2.3 and d.y < 1.2 and d.y > -2 then jump = true end
        end
    end
    return way, jump
end

local function play(t, level)
    bot.stage, bot.leaving = 1, nil
    t:steps(bot.lost * 13)  -- enemies and lifts are elsewhere than when it lost the last time
    while not level.over do
        if level.clock > 120 then error("stuck at " .. tostring(level.hero.position) .. " in level " .. level.number) end
        local way, jump = think(level)
        local hero = level.hero
        if hero.grounded and bot.held.space then jump = false end   -- a jump begins with a new press
        -- A cub that gets no farther jumps.
        bot.stuck = math.abs(hero.position.x - bot.last) < 0.02 and bot.stuck + 1 or 0
        bot.last = hero.position.x
        if bot.stuck > 420 then jump, bot.stuck = true, 380 end
        hold(t, "left", way < 0)
        hold(t, "right", way > 0)
        hold(t, "space", jump)
        t:steps(1)
    end
    for _, key in ipairs { "left", "right", "space" } do hold(t, key, false) end
end

function bot_plays(t)
    t:steps(40)
    t:tap("enter")
    while true do
        t:wait_until(function() return game.scene:is_a("Level") and not game.scene.over end, 10)
        local level, number = game.scene, game.scene.number
        play(t, level)
        local won = hearts > 0
        bot.lost = won and 0 or bot.lost + 1
        t:wait(1)
        if won then
            if number == 6 then break end
            t:wait_until(function() return game:has("menu") end, 10)
            t:steps(15)
            t:tap("enter")
            t:wait_until(function() return game.scene.number == number + 1 end, 10)
        elseif lives == 0 then
            t:steps(40)
            t:tap("enter")
            t:steps(60)
        end
    end
end

test("a bot wins the whole game", function(t)
    bot_plays(t)
    t:wait_until(function() return game:has("menu") end, 10)
    expect(game.scene.number):is(6)
    expect(points):above(1500)
    expect(store.reached):is(6)
    local won = false
    for _, entry in ipairs(store.scores) do won = won or entry.won end
    expect(won):truthy()
    t:steps(30)
    t:tap("enter")
    t:wait_until(function() return game.scene:is_a("Title") end, 5)
    t:steps(60)
end)

test("keys work in the title again after the settings", function(t)
    t:steps(60)
    t:tap("down")
    t:tap("down")
    t:tap("enter")
    t:steps(20)
    expect(game:has("settings")):truthy()
    expect(game.menu.visible):is(false)
    t:tap("escape")
    t:steps(5)
    expect(game:has("settings")):falsy()
    expect(game.menu.visible):is(true)
    expect(interface.focus and interface.focus.name):is("settings")
    t:tap("up")
    t:tap("up")
    t:tap("enter")
    t:wait_until(function() return game.scene:is_a("Level") end, 5)
end)

test("who begins a place again has won nothing there", function(t)
    t:steps(60)
    t:tap("enter")
    t:wait_until(function() return game.scene:is_a("Level") end, 5)
    t:steps(120)
    lives, coins, points = 6, 49, 700
    t:tap("p")
    t:steps(5)
    t:tap("down")
    t:tap("enter")
    t:steps(120)
    expect(points):is(0)
    expect(coins):is(0)
    expect(lives):is(5)
    lives = 3
    t:tap("p")
    t:steps(5)
    t:tap("down")
    t:tap("enter")
    t:steps(120)
    expect(lives):is(3)
end)

test("the button that has the keyboard has a color of its own, and no other", function(t)
    local function colored()
        local names = {}
        for _, button in ipairs(game:find("Button", function(each) return each.look == "accent" end)) do names[#names + 1] = button.name end
        return names
    end
    t:steps(60)
    expect(colored()):is { "new" }
    t:tap("down")
    t:steps(2)
    expect(colored()):is { "scores" }
    t:tap("enter")
    t:steps(10)
    expect(colored()):is { "back" }
    t:tap("enter")
    t:steps(10)
    expect(colored()):is { "scores" }
end)

test("the title says how to play with what the player has", function(t)
    local function help() return game.menu.column:children("Label")[2].text end
    t:steps(30)
    input.actions.jump = { "left_control", "gamepad.a" }
    expect(help()):contains("Arrows run, left control jumps.")
    input.gamepad_1.connected = true
    t:steps(1)
    expect(help()):contains("The stick runs, A jumps.")
end)

test("a fall into water costs one heart", function(t)
    t:steps(40)
    t:tap("enter")
    t:wait_until(function() return game.scene:is_a("Level") end, 10)
    t:steps(60)
    local level, water = game.scene, nil
    local function is_water(at)
        local cell = level.map:cell_at(at)
        return level.map:tile(cell.x, cell.y, "water") > 0
    end
    for x = 1, level.map.size.x - 1 do
        for y = 0.5, 4 do
            if is_water(vec(x - 0.2, y)) and is_water(vec(x + 0.2, y)) then water = vec(x, y + 0.35) end
        end
    end
    expect(water):truthy()
    level.hero.position, level.hero.velocity = water, vec(0, 0)
    t:steps(3)
    expect(hearts):is(2)
    expect(level.hits):is(1)
end)
