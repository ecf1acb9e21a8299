
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
for _,k in ipairs{"time","view","input","audio"} do pcall(function() game[k]=nil end) pcall(function() game[k]:delete() end) pcall(function() game[k].name="zz" end) pcall(function() game[k]:move(world) end) pcall(function() game[k].parent=world end) pcall(function() game[k]=Object{} end) end save_game("x") load_game("x")
end
