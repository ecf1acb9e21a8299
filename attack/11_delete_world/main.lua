
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n==3 then s=snapshot() world:delete() end if n==5 then game.world=World{} end if n==8 then restore(s) end if n==10 then save_game("x") load_game("x") end
end
