-- Run it with: fettle test

test("the hero stands, runs and jumps", function(t)
    t:steps(60)
    expect(world.hero:stands()):truthy()
    local start = world.hero.position.x
    t:hold("right", 30)
    expect(world.hero.position.x):above(start + 1.5)
    t:tap("space")
    t:steps(10)
    expect(world.hero.position.y):above(1)
    expect(world.hero:stands()):falsy()
    t:wait_until(function() return world.hero:stands() end, 2)
end)

test("a hero in the air cannot jump", function(t)
    t:steps(60)
    t:tap("space")
    t:steps(20)
    local speed = world.hero.velocity.y
    t:tap("space")
    expect(world.hero.velocity.y):below(speed)
end)

test("a coin is collected once", function(t)
    world.hero.position = vec(20, 1)
    t:steps(3)
    expect(course.coins):is(1)
    expect(#world.coins:children()):is(6)
    t:steps(10)
    expect(course.coins):is(1)
end)

test("who falls begins again", function(t)
    world.hero.position = vec(15.5, -7)
    t:wait_until(function() return course.falls == 1 end, 3)
    t:steps(1)
    expect(world.hero.position.x):near(-4, 0.5)
end)

test("the flag ends the game when all coins are collected", function(t)
    world.hero.position = vec(54, 1)
    t:steps(2)
    expect(course.won):is(false)
    course.coins = 7
    t:steps(2)
    expect(course.won):is(true)
    expect(store.best):above(0)
end)
