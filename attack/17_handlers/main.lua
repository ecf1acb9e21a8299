world.a=Body{Circle{}} world.a:watch("velocity",function() local s=snapshot() restore(s) rewind(0.1) save_game("h") load_game("h") world.a.x=(world.a:has("x") and world.a.x or 0)+1 end)
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.a.velocity=vec(n,0)
end
