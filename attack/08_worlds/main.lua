
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
if n%3==0 then game.w=World{Body{Circle{}}} end if n%3==1 and game:has("w") then game.w:delete() end if n%10==9 then rewind(0.2) end
end
