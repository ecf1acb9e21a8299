-- Pixels for a meter, as love.physics.setMeter sets them.
return { meter = 30 }
