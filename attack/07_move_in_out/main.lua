game.other=World{} world.b=Body{Circle{},Box{}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
local b=world.b or game.other.b if b.parent==world then b:move(game.other) else b:move(world) end if n%7==0 then save_game("m") load_game("m") end
end
