local k=0 every(0,function() k=k+1 after(0.01,function() world.t=k end) end)
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n%9==0 then rewind(0.1) end
end
