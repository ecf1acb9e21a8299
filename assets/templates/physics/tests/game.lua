-- Run it with: fettle test

test("the tower stands until it is hit", function(t)
    t:steps(180)
    expect(round.done):is(false)
    expect(world.crates.crate_1.position.y):near(1.5, 0.05)
end)

test("a pull throws a ball", function(t)
    t:click(vec(-11, 2))
    expect(round.balls):is(4)
    expect(#world.balls:children()):is(1)
    t:wait_until(function() return world.balls.body_1.position.x > 3 end)
end)

test("a level ends when all crates are down", function(t)
    world.crates:each("Crate", function(crate) crate.position = vec(12 + crate.position.x, 0.5) end)
    t:steps(2)
    expect(round.done):is(true)
    expect(store.best):is(1)
    t:tap("space")
    expect(round.level):is(2)
end)
