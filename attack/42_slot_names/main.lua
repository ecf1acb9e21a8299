
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
for _,s in ipairs{"",".","..","a/b","a\0b",string.rep("x",65),"CON"," a","ä"} do pcall(save_game,s) pcall(load_game,s) pcall(delete_save,s) end
end
