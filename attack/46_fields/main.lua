
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
for _,c in ipairs{Wind,Drag,Buoyancy,Attractor} do local f=c{} world:add(f) pcall(function() f.region={vec(3,3),vec(1,1)} end) pcall(function() f.normal=vec(0,0) end) local g=f:clone() g:delete() if n%3==0 then f:delete() end end save_game("x") load_game("x")
end
