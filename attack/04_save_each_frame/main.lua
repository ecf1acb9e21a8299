
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world:add(Body{position=vec(n,3),Box{}}) save_game("s"..n%3) if n%5==0 then load_game("s0") end
end
