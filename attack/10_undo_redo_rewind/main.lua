
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
edit("e",function() world["o"..n]=Body{Circle{}} end) if n%2==0 then undo() end if n%5==0 then redo() end if n%11==0 then rewind(0.15) end
end
