#include <algorithm>
#include <memory>

#include <fettle/script/syntax.h>

#include <lua/lua_api.h>

namespace fettle::script {

std::string syntax_error(std::string_view text, const std::string& name) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
    if (text.starts_with('#')) text.remove_prefix(std::min(text.find('\n'), text.size()));
    const std::unique_ptr<lua_State, void (*)(lua_State*)> lua(luaL_newstate(), lua_close);
    if (!lua) return name + ": no memory is left to compile it";
    const int status =
        luaL_loadbufferx(lua.get(), text.data(), text.size(), ("@" + name).c_str(), "t");
    if (status == LUA_OK) return {};
    std::size_t size = 0;
    const char* const message = lua_tolstring(lua.get(), -1, &size);
    return message == nullptr ? name + ": cannot be compiled" : std::string(message, size);
}

}  // namespace fettle::script
