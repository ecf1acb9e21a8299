
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world.x=Body{Circle{}} world.x=Object{} world.x=nil world.x=5 world.x=Body{Box{}} game.world.x=nil if n%6==0 then rewind(0.05) end if n%7==0 then save_game("x") load_game("x") end
end
