-- A game in which the wind blows; `modules.json` beside it names the module.
world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
world.wind = Breeze { velocity = vec(6, 0), gusts = 0.5 }
for i = 1, 6 do
    world:add(Body { position = vec(-6 + i, 2 * i), Circle { radius = 0.4, density = 0.2 } })
end
