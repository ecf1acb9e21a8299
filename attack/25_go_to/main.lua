
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
pcall(function() time:go_to(n-3) end) pcall(function() time:go_to(-1) end) pcall(function() time:go_to(1e9) end) pcall(function() time:go_to(math.mininteger) end) world.v=n
end
