// Replaces string.format, string.rep and os.date: the originals show addresses, may loop forever
// over an empty text, or take a minute for a long one.

#include <cctype>
#include <string>

#include <lua/budget.h>
#include <lua/guard.h>
#include <lua/machine.h>
#include <sandbox/sandbox.h>

namespace fettle::script {

namespace {

// Upvalue 1: the original. Arguments of %s are converted with our `tostring` first.
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
            push_tostring(L, argument);
            lua_replace(L, argument);
        }
    }
    machine_of(L).budget.charge(L, length / 4);
    return call_original(L);
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
    return call_original(L);
}

int date(lua_State* L) {
    constexpr std::size_t longest = 1000;
    std::size_t length = 0;
    luaL_optlstring(L, 1, "", &length);
    if (length > longest)
        throw Error(ErrorKind::out_of_range, "os.date: the format has " + std::to_string(length) +
                                                 " bytes, and " + std::to_string(longest) +
                                                 " at most are possible");
    return call_original(L);
}

}  // namespace

void open_strings(lua_State* L) {
    lua_getfield(L, -1, "string");
    wrap_pure<format>(L, "string", "format");
    wrap_pure<repeat>(L, "string", "rep");
    lua_pop(L, 1);
    lua_getfield(L, -1, "os");
    wrap_pure<date>(L, "os", "date");
    lua_pop(L, 1);
}

}  // namespace fettle::script
