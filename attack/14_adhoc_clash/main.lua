
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.o=Object{} world.o.step=3 world.o.lives=1 pcall(function() world.o.lives=Object{} end) save_game("x") load_game("x")
end
