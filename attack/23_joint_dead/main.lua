world.a=Body{Circle{}} world.b=Body{position=vec(1,0),Circle{}} world.j=WeldJoint{body_a=world.a,body_b=world.b}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n==3 then world.a:delete() end if n==4 then save_game("x") end if n==5 then load_game("x") world.j2=world.j:clone() end if n==6 then world.j.body_a=nil end
end
