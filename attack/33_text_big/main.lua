
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.t=string.rep("x",2e6)..n save_game("x") if n%4==0 then load_game("x") end
end
