for i=1,9 do world:add(Body{position=vec(i,i%3),Box{},Chain{},Concave{}}) end
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
for _,b in ipairs(world:children(Body)) do b.type=({"static","kinematic","dynamic"})[n%3+1] end save_game("x") load_game("x")
end
