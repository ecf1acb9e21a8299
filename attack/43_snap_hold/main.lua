
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
held=held or {} local ok=true for i=1,100 do ok=pcall(function() held[#held+1]=snapshot() end) end if n==5 then held=nil collectgarbage() end
end
