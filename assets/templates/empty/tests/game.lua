-- Run it with: fettle test

test("the game begins with a greeting", function(t)
    t:steps(60)
    expect(game.greeting.text):is("Hello")
end)
