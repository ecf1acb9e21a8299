-- For the tests: plays as a player does. It sees what is near, and holds keys.

local bot = {}

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
function bot.choose(t)
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

-- Plays until ends() is true.
function bot.play(t, ends)
    for _ = 1, 40000 do
        if night.menu == "choose" then bot.choose(t)
        elseif ends() then return hold {}
        else
            local way, cost = best_way()
            hold(keys[way])
            if cost > 6 and world.hero.wait == 0 then t:tap("space") end
            t:steps(4)
        end
    end
end

-- From the title into a run.
function bot.begin(t)
    t:steps(20)
    t:tap("enter")
    t:steps(3)
    expect(night.running):is(true)
end

return bot
