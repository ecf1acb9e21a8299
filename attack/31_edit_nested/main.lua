
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
edit("a",function() edit("b",function() world.x=n end) pcall(undo) pcall(edit,"c",function() error("x") end) end) if n%5==0 then undo() rewind(0.05) end
end
