
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n==2 then local t=world for i=1,3000 do local o=Object{} t.c=o t=o end end if n==4 then world.copy=world.c:clone() save_game("x") end if n==6 then load_game("x") end if n==8 then world.c:delete() rewind(0.05) end
end
