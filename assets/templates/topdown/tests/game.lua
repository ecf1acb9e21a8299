-- Run it with: fettle test

test("the hero moves and stays in the field", function(t)
    t:hold("d", 30)
    expect(world.hero.position.x):above(2)
    t:hold("w", 200)
    expect(world.hero.position.y):below(9)
end)

test("enemies come and follow the hero", function(t)
    t:wait_until(function() return #world.enemies:children() > 0 end, 3)
    local enemy = world.enemies.enemy_1
    local far = enemy.position:length()
    t:steps(60)
    expect(enemy.position:length()):below(far)
end)

test("a shot removes an enemy", function(t)
    world.enemies:add(Enemy { position = vec(4, 0), Circle { radius = 0.45 } })
    t:click(vec(6, 0))
    t:wait_until(function() return fight.score == 1 end, 2)
    expect(#world.enemies:children()):is(0)
end)

test("three touches end the game and space begins another", function(t)
    for _ = 1, 3 do
        world.enemies:add(Enemy { position = world.hero.position + vec(1.2, 0), Circle { radius = 0.45 } })
        t:wait(1.2)
        world.enemies = Object {}
    end
    expect(fight.lives):is(0)
    expect(fight.over):is(true)
    t:tap("space")
    expect(fight.over):is(false)
    expect(fight.lives):is(3)
end)
