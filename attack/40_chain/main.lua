world.p=Body{Chain{}}
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
pcall(function() world.p.chain.points={vec(0,0),vec(0,0),vec(n,1)} end) pcall(function() world.p.chain.closed=true end) pcall(function() world.p.chain.points={vec(0,0),vec(1,0)} end) pcall(function() world.p.chain.points=nil end) pcall(function() world.p.chain.closed=n%2==0 end) local q=world.p:clone() scene.save("q.json",world.p) local l=scene.load("q.json") l:delete() q:delete() save_game("x") load_game("x")
end
