-- The console of a hosted game over a game of LÖVE: `require("fettle.console").attach(game)`, in love.load. The grave key opens it.

local host = require "fettle.host"
local fettle = require "fettle"
local ffi, lib, check = fettle.ffi, host.lib, fettle.check

local Console = {}
Console.__index = Console

local names = {
    ["`"] = "grave", ["return"] = "enter", kpenter = "enter", pageup = "page_up", pagedown = "page_down",
    lshift = "left_shift", rshift = "right_shift", lctrl = "left_control", rctrl = "right_control",
    lalt = "left_alt", ralt = "right_alt", lgui = "left_system", rgui = "right_system",
    ["-"] = "minus", ["="] = "equal", ["["] = "left_bracket", ["]"] = "right_bracket", ["\\"] = "backslash",
    [";"] = "semicolon", ["'"] = "apostrophe", [","] = "comma", ["."] = "period", ["/"] = "slash",
    ["kp+"] = "numpad_add", ["kp-"] = "numpad_subtract", ["kp*"] = "numpad_multiply", ["kp/"] = "numpad_divide",
}
for i = 0, 9 do names["kp" .. i] = "numpad_" .. i end
local buttons = { "left", "right", "middle", "extra_1", "extra_2" }

-- --- Input ----------------------------------------------------------------------------------------

--- Passes an event to the game. Returns true if the console has used it.
function Console:pass_event(kind, fields)
    local input, used = self.input, self.used
    check(lib.fettle_hosted_input_init(input, ffi.sizeof(input)))
    input.kind = kind
    local scale = love.graphics.getDPIScale()
    local x, y = love.mouse.getPosition()
    input.x, input.y = (fields.x or x) * scale, (fields.y or y) * scale
    local down = love.keyboard.isDown
    input.control, input.shift, input.alt = down("lctrl", "rctrl"), down("lshift", "rshift"), down("lalt", "ralt")
    local name = fields.name  -- kept while the call lasts
    input.name, input.character, input.delta = name, fields.character or 0, fields.delta or 0
    input.repeated, input.focused = fields.repeated or false, fields.focused or false
    used[0] = false
    -- An error of a script is in the console.
    if lib.fettle_hosted_handle(self.game.pointer, input, used) == lib.FETTLE_FAILED then self.problem = true end
    return used[0]
end

function Console:keypressed(key, _, repeated)
    return self:pass_event(lib.FETTLE_INPUT_KEY_PRESSED, { name = names[key] or key, repeated = repeated })
end
function Console:keyreleased(key) return self:pass_event(lib.FETTLE_INPUT_KEY_RELEASED, { name = names[key] or key }) end
function Console:textinput(text)
    local used = false
    for _, character in require("utf8").codes(text) do
        used = self:pass_event(lib.FETTLE_INPUT_TEXT, { character = character }) or used
    end
    return used
end
function Console:mousemoved(x, y) return self:pass_event(lib.FETTLE_INPUT_MOUSE_MOVED, { x = x, y = y }) end
function Console:mousepressed(x, y, button)
    return self:pass_event(lib.FETTLE_INPUT_MOUSE_PRESSED, { x = x, y = y, name = buttons[button] })
end
function Console:mousereleased(x, y, button)
    return self:pass_event(lib.FETTLE_INPUT_MOUSE_RELEASED, { x = x, y = y, name = buttons[button] })
end
function Console:wheelmoved(_, y) return self:pass_event(lib.FETTLE_INPUT_WHEEL, { delta = y }) end
function Console:focus(focused) return self:pass_event(lib.FETTLE_INPUT_FOCUS, { focused = focused }) and false end

-- --- Drawing --------------------------------------------------------------------------------------

local format = {
    { "VertexPosition", "float", 2 }, { "VertexTexCoord", "float", 2 }, { "VertexColor", "byte", 4 },
}

local function bytes_of(pointer, size)
    local data = love.data.newByteData(size)
    ffi.copy(data:getFFIPointer(), pointer, size)
    return data
end

--- Makes images for the textures of the picture, and drops those of textures that it no longer has.
function Console:renew_textures(picture)
    local images = {}
    for i = 0, picture.texture_count - 1 do
        local texture = picture.textures[i]
        local known = self.images[texture.id]
        if not known or known.version ~= texture.version then
            local width, height = texture.width, texture.height
            local pixels = love.image.newImageData(width, height, "rgba8", ffi.string(texture.rgba, width * height * 4))
            known = { version = texture.version, image = love.graphics.newImage(pixels) }
        end
        images[texture.id] = known
    end
    self.images = images
end

function Console:renew_mesh(picture)
    if picture.vertex_count > self.room then
        self.room = math.ceil(picture.vertex_count * 1.5)
        self.mesh = love.graphics.newMesh(format, self.room, "triangles", "stream")
    end
    self.mesh:setVertices(bytes_of(picture.vertices, picture.vertex_count * ffi.sizeof("fettle_console_vertex")))
    self.mesh:setVertexMap(bytes_of(picture.indices, picture.index_count * 4), "uint32")
end

--- Draws the console over the picture. It is called before each frame is shown.
function Console:draw()
    local now = love.timer.getTime()
    local seconds = math.min(now - (self.drawn or now), 1)
    self.drawn = now
    local width, height = love.graphics.getPixelDimensions()
    local picture = self.picture
    if lib.fettle_console_draw(self.game.pointer, width, height, seconds, picture) ~= lib.FETTLE_DONE then return end
    if picture.index_count == 0 then return end
    love.graphics.push "all"
    love.graphics.reset()
    love.graphics.scale(1 / love.graphics.getDPIScale())
    self:renew_textures(picture)
    self:renew_mesh(picture)
    for i = 0, picture.command_count - 1 do
        local command = picture.commands[i]
        local clip, known = command.clip, self.images[command.texture]
        if known then self.mesh:setTexture(known.image) else self.mesh:setTexture() end
        self.mesh:setDrawRange(command.first_index + 1, command.index_count)
        local scale = love.graphics.getDPIScale()
        love.graphics.setScissor(clip.left / scale, clip.top / scale, clip.width / scale, clip.height / scale)
        love.graphics.draw(self.mesh)
    end
    love.graphics.pop()
end

--- Where the world is on the screen: a point (px, py) is at (a px + b py + x, c px + d py + y). Then a click selects a body.
function Console:view(a, b, c, d, x, y)
    check(lib.fettle_console_set_view(self.game.pointer, ffi.new("double[6]", a, b, c, d, x, y)), 2)
end
function Console:open(open) check(lib.fettle_console_open(self.game.pointer, open ~= false), 2) end
function Console:is_open()
    check(lib.fettle_console_is_open(self.game.pointer, self.used), 2)
    return self.used[0]
end

-- --- Attaching ------------------------------------------------------------------------------------

local events = { "keypressed", "keyreleased", "textinput", "mousemoved", "mousepressed", "mousereleased", "wheelmoved", "focus" }

local console = {}

--- From now on the console of the game gets each event before LÖVE's callbacks do, and is drawn over each frame.
function console.attach(game)
    local made = setmetatable({
        game = game, room = 0, images = {}, input = ffi.new("fettle_hosted_input"), used = ffi.new("bool[1]"),
        picture = ffi.new("fettle_console_picture"),
    }, Console)
    local clipboard
    local read = ffi.cast("fettle_clipboard_read", function()
        clipboard = love.system.getClipboardText()
        return ffi.cast("const char*", clipboard)
    end)
    local write = ffi.cast("fettle_clipboard_write", function(_, text) love.system.setClipboardText(ffi.string(text)) end)
    made.callbacks = { read, write }
    check(lib.fettle_console_set_clipboard(game.pointer, read, write, nil), 2)
    love.keyboard.setKeyRepeat(true)
    for _, name in ipairs(events) do
        local before = love.handlers[name]
        love.handlers[name] = function(...)
            if not made[name](made, ...) then return before(...) end
        end
    end
    local present = love.graphics.present
    love.graphics.present = function()
        made:draw()
        return present()
    end
    return made
end

-- These call functions of Lua, which compiled code must not do.
for _, f in pairs(Console) do if type(f) == "function" then jit.off(f) end end
return console
