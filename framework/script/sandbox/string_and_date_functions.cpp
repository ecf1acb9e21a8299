// Replaces string.format, string.rep and os.date: the originals show addresses, may loop forever
// over an empty text, or take a minute for a long one.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string>

#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <sandbox/sandbox.h>

namespace fettle::script {

namespace {

/// Before memory is taken for it.
void refuse_long_text(lua_State* L, std::size_t size) {
    Machine& machine = machine_of(L);
    const std::size_t most = machine.limiters.arena.longest_text();
    if (most == 0 || size <= most) return;
    const Arena::Refusal refusal{.size = size, .final = true, .text = true};
    machine.limiters.budget.memory_refused(refusal);
    throw Error(ErrorKind::rejected, machine.limiters.budget.out_of_memory(refusal));
}

/// What one conversion costs, in instructions. Bytes of %q become up to five each, one by one; C
/// computes every digit of very large and very small numbers.
std::uint64_t cost_of(lua_State* L, char conversion, int argument) {
    if (conversion == 'q') return 8 * lua_rawlen(L, argument);
    if (conversion == 's') return lua_rawlen(L, argument) / 8;
    const double size = std::abs(lua_tonumber(L, argument));
    return size == 0 || (size > 1e-15 && size < 1e15) ? 20 : 5000;
}

// Upvalue 1: the original. Arguments of %s are converted with our `tostring` first.
int format(lua_State* L) {
    std::size_t length = 0;
    const char* text = luaL_checklstring(L, 1, &length);
    int argument = 1;
    std::uint64_t cost = length / 4;
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
        cost += cost_of(L, text[i], argument);
    }
    machine_of(L).limiters.budget.charge(L, cost);
    return call_original(L);
}

int repeat(lua_State* L) {
    std::size_t length = 0, separator = 0;
    const char* const text = luaL_checklstring(L, 1, &length);
    const lua_Integer count = luaL_checkinteger(L, 2);
    const char* const between = luaL_optlstring(L, 3, "", &separator);
    if (count <= 0 || length + separator == 0) {
        lua_pushliteral(L, "");
        return 1;
    }
    // Lua's own function copies a long text of one letter letter by letter.
    const std::size_t part = length + separator;
    constexpr std::size_t most = std::size_t{1} << 62;
    const bool huge = static_cast<std::size_t>(count) > most / part;
    const std::size_t size = huge ? most : part * static_cast<std::size_t>(count) - separator;
    refuse_long_text(L, size);
    if (huge) return call_original(L);  // it has the message
    machine_of(L).limiters.budget.charge(L, size / 64);
    luaL_Buffer buffer;
    char* const to = luaL_buffinitsize(L, &buffer, size);
    std::memcpy(to, text, length);
    if (count > 1) std::memcpy(to + length, between, separator);
    // The text so far is appended to itself until it is long enough.
    for (std::size_t made = part; made < size; made *= 2)
        std::memcpy(to + made, to, std::min(made, size - made));
    luaL_pushresultsize(&buffer, size);
    return 1;
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
