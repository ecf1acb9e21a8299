-- Checks the arguments of functions, so that a wrong one is an error with the name of the function, of the argument, and of the
-- type that is expected.
--
-- A signature names the arguments and their types: "x number, y number, kind string?". A type ends with "?" if nil is allowed, or
-- with "..." if all further arguments have it. "..." alone allows anything. A type with a capital letter is one of LÖVE's objects.

local arguments = {}

local function with_article(kind) return (kind:find "^[aeiouAEIOU]" and "an " or "a ") .. kind end

local function described(value)
    local kind = type(value)
    if kind == "nil" then return "nil" end
    if kind == "string" then return ("a string (%q)"):format(value) end
    if kind == "number" or kind == "boolean" then return with_article(kind) .. " (" .. tostring(value) .. ")" end
    local class = kind == "table" and getmetatable(value)
    return with_article(class and class.type_name or kind)
end

local function is_object(value, kind)
    return type(value) == "table" and type(value.typeOf) == "function" and value:typeOf(kind)
end

local function parsed(signature)
    local all = {}
    for part in signature:gmatch "[^,]+" do
        local name, kind, suffix = part:match "^%s*(%S+)%s+(%a+)([?.]*)$"
        all[#all + 1] = name and { name = name, kind = kind, optional = suffix == "?", rest = suffix == "..." } or { any = true }
    end
    return all
end

--- `value` if it has the type, or a number if it is a string of one, as Lua has it. `level`: that of the call
--- in the game, where 1 is the caller of this.
local function required(value, what, kind, level)
    if type(value) == kind or is_object(value, kind) then return value end
    local number = kind == "number" and type(value) == "string" and tonumber(value)
    return number or error(("%s: expected %s, got %s"):format(what, with_article(kind), described(value)), level + 1)
end
arguments.required = required

--- The function with its arguments checked. `class`: it is a method of these objects. The code is made for the count of
--- arguments, so that LuaJIT compiles it to a comparison for each.
function arguments.checked(name, signature, f, class)
    local all, list, code = parsed(signature), {}, {}
    local function check(i, value)
        local expected = all[i]
        if not expected then
            if is_object(value, class.type_name) then return value end
            error(("%s: expected %s before the colon, got %s"):format(name, with_article(class.type_name), described(value)), 3)
        end
        local same = required(value, name .. ": " .. expected.name, expected.kind, 3)
        return same
    end
    if class then
        list[1] = "self"
        code[1] = "if getmetatable(self) ~= class then self = check(0, self) end"
    end
    local rest
    for i, argument in ipairs(all) do
        if argument.any or argument.rest then
            list[#list + 1], rest = "...", argument.rest and i
        else
            local a = "a" .. i
            list[#list + 1] = a
            code[#code + 1] = ("if %stype(%s) ~= %q then %s = check(%d, %s) end"):format(
                argument.optional and a .. " ~= nil and " or "", a, argument.kind, a, i, a)
        end
    end
    if rest then code[#code + 1] = ("for i = 1, select('#', ...) do check(%d, (select(i, ...))) end"):format(rest) end
    local parameters = table.concat(list, ", ")
    local made = assert(loadstring(([[local f, class, check = ...
        local type, getmetatable, select = type, getmetatable, select
        return function(%s) %s return f(%s) end]]):format(parameters, table.concat(code, " "), parameters), "=" .. name))
    return made(f, class, check)
end

--- Checks the arguments of all methods of a class; those without a signature have none but the object.
function arguments.of_class(class, signatures)
    for name, f in pairs(class) do
        if type(f) == "function" and name:sub(1, 2) ~= "__" then
            class[name] = arguments.checked(class.type_name .. ":" .. name, signatures[name] or "...", f, class)
            signatures[name] = nil
        end
    end
    local unknown = next(signatures)
    assert(not unknown, unknown and class.type_name .. " has no method " .. unknown)
    return class
end

return arguments
