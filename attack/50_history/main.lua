
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
edit("e"..n,function() world.q=n end) history() if n%3==0 then undo() history() end if n%8==0 then rewind(0.1) end
end
