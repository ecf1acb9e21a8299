
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
local l={} for i=1,60 do l={l} end pcall(function() world.l=l end) local m={} for i=1,200 do m={m} end pcall(function() world.m=m end) save_game("x") load_game("x")
end
