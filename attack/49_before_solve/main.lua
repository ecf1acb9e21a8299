world.a=Body{position=vec(0,1),Circle{}} world.f=Body{type="static",position=vec(0,-1),Box{width=30}} world.a:on("before_solve",function(c) pcall(save_game,"y") pcall(rewind,1) pcall(snapshot) pcall(function() world.a:delete() end) end)
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n%20==0 then save_game("x") load_game("x") end
end
