-- A game with nothing in it but a greeting. Change a line while it runs and save: the game follows.

view.height = 10
game.greeting = Object { text = "Hello" }

-- Functions with these names are called by Fettle.

function start()
end

function update(dt)
end

function key_pressed(key)
    if key == "escape" then quit() end
end

function draw(pen)
    pen.text(vec(0, 0), game.greeting.text, 1, "white")
end
