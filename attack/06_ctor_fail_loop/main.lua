
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
for i=1,50 do local c=Circle{} pcall(Body,{c,mass="x"}) assert(c:alive()) pcall(function() world.q=Body{c,Chain{closed=true}} end) assert(c:alive() and not world:has("q")) end if n%10==0 then save_game("x") load_game("x") rewind(0.1) end
end
