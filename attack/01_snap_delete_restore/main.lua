
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1

 if n==2 then world.a=Body{Circle{}} s=snapshot() end
 if n==4 then world.a:delete() world.a=Object{} end
 if n==5 then restore(s) end
 if n==7 then assert(world.a:is_a(Body)) save_game("x") end
 if n==9 then load_game("x") end
end
