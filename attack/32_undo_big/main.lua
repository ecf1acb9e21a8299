
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
edit("big",function() for i=1,300 do world:add(Body{Circle{}}) end end) undo() redo() undo()
end
