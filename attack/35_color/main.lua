world.a=Body{Circle{}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.a.color=color("red") world.a.circle.color=nil world.a.circle.border=color("blue") pcall(function() world.a.color=color(2,-1,0/0) end) save_game("x") load_game("x")
end
