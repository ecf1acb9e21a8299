
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
pcall(function() world.bounds={vec(-1e8,-1e8),vec(1e8,1e8)} end) pcall(function() world.bounds={vec(0,0),vec(0,1)} end) pcall(function() world.bounds={vec(5,5),vec(1,1)} end) save_game("x") load_game("x") game.c=nil game.c=world:clone()
end
