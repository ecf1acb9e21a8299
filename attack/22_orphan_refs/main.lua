world.o=Object{}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
local a=Body{Circle{}} world.o.ref=a world.o.list={a,a} if n%5==0 then save_game("x") load_game("x") end if n%7==0 then pcall(function() world.o:clone() end) end
end
