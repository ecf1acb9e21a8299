game.o=World{} world.p=Body{Concave{}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
local v={} for i=1,12 do v[i]=vec(math.cos(i/12*6.283)*random(),math.sin(i/12*6.283)*random()) end pcall(function() world.p.concave.vertices=v end) local ok,e=pcall(function() return world.p:clone() end) assert(ok,e) world.p:move(game.o) game.o.p:move(world) save_game("x") load_game("x")
end
