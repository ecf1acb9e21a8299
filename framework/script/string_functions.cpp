// string.format and string.rep: the originals show addresses, or can loop for ever over nothing.

#include <cctype>

#include <fettle/property/error.h>

#include "guard.h"
#include "machine.h"
#include "sandbox.h"

namespace fettle::script {

using property::Error;
using property::ErrorKind;

namespace {

// Upvalue 1: the original. Arguments of %s become text our way first.
int format(lua_State* L) {
    std::size_t length = 0;
    const char* text = luaL_checklstring(L, 1, &length);
    int argument = 1;
    for (std::size_t i = 0; i < length; ++i) {
        if (text[i] != '%') continue;
        if (++i >= length) break;
        if (text[i] == '%') continue;
        ++argument;
        while (i < length && !std::isalpha(static_cast<unsigned char>(text[i]))) ++i;
        if (i >= length) break;
        if (text[i] == 'p')
            throw Error(ErrorKind::rejected, "string.format: %p would show an address");
        if (text[i] == 's' && argument <= lua_gettop(L) && lua_type(L, argument) != LUA_TSTRING) {
            push_text(L, argument);
            lua_replace(L, argument);
        }
    }
    machine_of(L).budget.charge(L, length / 4);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 1);
    return 1;
}

int repeat(lua_State* L) {
    std::size_t length = 0, separator = 0;
    luaL_checklstring(L, 1, &length);
    const lua_Integer count = luaL_checkinteger(L, 2);
    luaL_optlstring(L, 3, "", &separator);
    if (count <= 0 || length + separator == 0) {
        lua_pushliteral(L, "");
        return 1;
    }
    machine_of(L).budget.charge(L, static_cast<std::uint64_t>(count) / 8);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 1);
    return 1;
}

template <int (*function)(lua_State*)>
void wrap(lua_State* L, const char* name) {
    lua_getglobal(L, "string");
    lua_getfield(L, -1, name);
    lua_remove(L, -2);
    lua_pushcclosure(L, guarded<function>, 1);
    lua_setfield(L, -2, name);
}

}  // namespace

void open_strings(lua_State* L) {
    lua_getfield(L, -1, "string");
    wrap<format>(L, "format");
    wrap<repeat>(L, "rep");
    lua_pop(L, 1);
}

}  // namespace fettle::script
