after(0,function() for i=1,1000 do wait(0.02) world.w=i end end)
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n%9==0 then rewind(0.1) save_game("x") load_game("x") end
end
