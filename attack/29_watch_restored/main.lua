game:on("restored",function() world.a=Body{Circle{}} rewind(0.05) end)
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n==3 then save_game("x") end if n==6 then load_game("x") end
end
