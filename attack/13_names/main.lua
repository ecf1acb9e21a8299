
local n=0
local function at(k,f) if n==k then f() end end
function update() n=n+1
pcall(function() world["a.b"]=Body{} end) pcall(function() world[""]=Body{} end) world["x\0y"..n%3]=Body{} world[string.rep("n",5000)]=Object{} world["body_0005"]=nil world["body_0005"]=Object{} world["9_9"]=Object{} save_game("x") load_game("x")
end
