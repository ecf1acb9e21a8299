#include <memory>

#include <fettle/script/syntax.h>

#include <lua/lua_api.h>
#include <sources/sources.h>

namespace fettle::script {

std::string syntax_error(std::string_view text, const std::string& name) {
    text = without_shell_line(without_byte_order_mark(text));
    const std::unique_ptr<lua_State, void (*)(lua_State*)> lua(luaL_newstate(), lua_close);
    if (!lua) return name + ": no memory is left to compile it";
    const int status =
        luaL_loadbufferx(lua.get(), text.data(), text.size(), ("@" + name).c_str(), "t");
    if (status == LUA_OK) return {};
    place_overflow(lua.get(), text, ("@" + name).c_str(),
                   [](lua_State*, void* rest, std::size_t* size) -> const char* {
                       auto& left = *static_cast<std::string_view*>(rest);
                       *size = left.empty() ? 0 : 1;
                       const char* const byte = left.data();
                       left.remove_prefix(*size);
                       return byte;
                   });
    std::size_t size = 0;
    const char* const message = lua_tolstring(lua.get(), -1, &size);
    return message == nullptr ? name + ": cannot be compiled" : std::string(message, size);
}

}  // namespace fettle::script
