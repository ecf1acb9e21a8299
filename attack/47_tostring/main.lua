
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
local s=snapshot() tostring(s) if n==3 then keep=s end if n==5 then tostring(keep) restore(keep) end for _,f in ipairs{restore,rewind,load_game} do pcall(f) pcall(f,nil) pcall(f,world) end
end
