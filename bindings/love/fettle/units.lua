-- Pixels for a metre, as love.physics.setMeter sets them.
return { meter = 30 }
