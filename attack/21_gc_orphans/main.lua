
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
for i=1,100 do local b=Body{Circle{},Box{}} b.ref=b end if n%10==0 then save_game("x") load_game("x") end
end
