
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n==2 then for i=1,5000 do world:add(Object{}) end end if n%4==0 then save_game("x") end if n%4==2 and n>5 then load_game("x") end if n==10 then for _,o in ipairs(world:children(Object)) do pcall(o.delete,o) end end
end
