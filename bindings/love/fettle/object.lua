-- The members of all objects of LÖVE: the name of their type.

local object = {}

local Object = {}
Object.__index = Object
function Object:type() return self.type_name end
function Object:typeOf(name)
    local class = getmetatable(self)
    while class do
        if class.type_name == name then return true end
        class = class.parent
    end
    return name == "Object"
end

--- To be called when a game no longer needs the object: the garbage collector then frees it.
function Object:release() return true end

--- A class of objects whose `type()` is `name`, with the methods of `parent`.
function object.class(name, parent)
    local class = setmetatable({ type_name = name, parent = parent }, parent or Object)
    class.__index = class
    return class
end

return object
