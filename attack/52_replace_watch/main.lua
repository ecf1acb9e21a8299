world:on("deleted",function() end) world.x=Body{Circle{}} world.x:on("deleted",function() world.y=Object{} end)
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.x=Body{Circle{}}
end
