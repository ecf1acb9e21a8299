
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n==2 then s=snapshot() end if n>3 then for i=1,20 do restore(s) end world.b=Body{Circle{}} end
end
