for i=1,20 do world:add(Body{Circle{},Box{}}) end
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
for _,b in ipairs(world:children(Body)) do b:move(nil) b:move(world,"n"..random(1,1e6)) end if n%5==0 then rewind(0.1) end
end
