world.a=Body{Circle{}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
time.paused=n%2==0 time.step_once=true if n%3==0 then rewind(0.05) save_game("x") load_game("x") end
end
