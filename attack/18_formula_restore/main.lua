world.a=Body{Circle{}} s=snapshot()
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n==2 then world.a.f=formula(function() return snapshot() end) world.a.g=formula(function() restore(s) return 1 end) world.a.h=formula(function() rewind(1) return 1 end) world.a.i=formula(function() save_game("q") return 1 end) end save_game("x") if n>3 then load_game("x") end
end
