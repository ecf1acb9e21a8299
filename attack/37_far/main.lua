world.a=Body{Circle{center=vec(1e5,0)},Box{center=vec(-1e5,7)}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.a.position=vec(1e8,1e8) world.a.angle=1e8 world.a.angular_velocity=1e4 world.a.velocity=vec(1e4,1e4) world.b=world.a:clone() world.a:move(game) world.a2=game.a game.a:move(world) save_game("x") load_game("x")
end
