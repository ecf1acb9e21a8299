
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
world:add(Body{Circle{}}) if n>3 then rewind(0.05) end
end
