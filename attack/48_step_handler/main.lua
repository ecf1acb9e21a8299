world.a=Body{Circle{}} world.f=Body{type="static",position=vec(0,-1),Box{width=30}} world.a:on("contact_begin",function() save_game("c") load_game("c") rewind(0.05) world.a:delete() world.a=Body{Circle{}} end)
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.a.position=vec(0,3)
end
