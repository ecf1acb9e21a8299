function love.conf(t)
    t.window.title = "A hosted game of Fettle in LÖVE"
    t.window.width, t.window.height = 960, 640
    t.modules.audio, t.modules.joystick, t.modules.physics = false, false, false
end
