game.o=World{} world.p=Body{Polygon{}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
local v={} for i=1,40 do v[i]=vec(math.cos(i)*1e-3*random(1,1000),math.sin(i)*random()) end pcall(function() world.p.polygon.vertices=v end) local q=world.p:clone() q:delete() world.p:move(game.o) world.p2=nil game.o.p:move(world) save_game("x") load_game("x")
end
