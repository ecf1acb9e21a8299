#include "guard.h"

#include <fettle/property/exception_text.h>

namespace fettle::script {

std::string position(lua_State* L) {
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0)
            return std::string(frame.short_src) + ":" + std::to_string(frame.currentline) + ": ";
    }
    return {};
}

void raise(lua_State* L, const std::string& message) {
    raise_text(L, message.c_str());
}

void raise_exception(lua_State* L, const std::exception& error) {
    luaL_checkstack(L, 4, "error message");
    {
        const std::string text = position(L) + property::exception_text(error);
        lua_pushlstring(L, text.data(), text.size());
    }
    lua_error(L);
    std::terminate();  // not reached
}

void raise_text(lua_State* L, const char* message) {
    luaL_checkstack(L, 4, "error message");
    {
        const std::string text = position(L) + message;
        lua_pushlstring(L, text.data(), text.size());
    }
    lua_error(L);
    std::terminate();  // not reached
}

}  // namespace fettle::script
