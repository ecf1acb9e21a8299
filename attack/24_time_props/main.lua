world.a=Body{Circle{}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
time.dt=({1e-5,1,1/60,0.5})[n%4+1] time.rewind_memory=({1,2,65536,3})[n%4+1] time.rewind_limit=({0,1,3600,60})[n%4+1] time.max_steps=n%5+1 if n%3==0 then rewind(0.5) end save_game("x") load_game("x")
end
