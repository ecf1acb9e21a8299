// The table library. A metamethod may return any length and elements, so each function charges the
// budget before its loop. Changing a list of a property is one change.

#include <algorithm>
#include <limits>

#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <sandbox/sandbox.h>
#include <values/moved_lists.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// A longer loop is an error, even without a budget.
constexpr lua_Integer longest_loop = 200'000'000;

void charge(lua_State* L, const char* what, lua_Integer from, lua_Integer to) {
    if (to < from) return;
    const auto count = static_cast<lua_Unsigned>(to) - static_cast<lua_Unsigned>(from);
    if (count >= static_cast<lua_Unsigned>(longest_loop))
        throw Error(ErrorKind::out_of_range, std::string(what) + ": too many elements");
    machine_of(L).limiters.budget.charge(L, count);
}

// Accepts values with elements. For others, raises the same error as Lua's own functions, before
// any change.
void check_list(lua_State* L) {
    if (lua_type(L, 1) == LUA_TTABLE || list_at(L, 1) != nullptr) return;
    if (luaL_getmetafield(L, 1, "__index") == LUA_TNIL || lua_type(L, 1) == LUA_TSTRING)
        luaL_checktype(L, 1, LUA_TTABLE);
    lua_pop(L, 1);
}

std::size_t position(lua_State* L, int index, std::size_t max, const char* what) {
    const lua_Integer place = luaL_checkinteger(L, index);
    if (place < 1 || static_cast<std::size_t>(place) > max)
        throw Error(ErrorKind::out_of_range, std::string(what) + ": position " +
                                                 std::to_string(place) + " is not between 1 and " +
                                                 std::to_string(max));
    return static_cast<std::size_t>(place);
}

/// All elements of the list, which was `before`, are others now from this place on.
void note_moved(lua_State* L, const ListBox& box, std::size_t place, const Value& before) {
    if (place <= before.list().size())
        machine_of(L).moved_lists.note(box.origin, place, std::numeric_limits<std::size_t>::max(),
                                       before);
}

int insert(lua_State* L) {
    check_list(L);
    if (const auto* box = list_at(L, 1)) {
        Value before = list_value(L, *box);
        const std::size_t after = before.list().size() + 1;
        const bool placed = lua_gettop(L) >= 3;
        const std::size_t place = placed ? position(L, 2, after, "table.insert") : after;
        const Value added = to_value(L, placed ? 3 : 2);
        if (place == after && !added.is_nil() && change_element(L, *box, before, place, added))
            return 0;
        List list = before.list();
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(place - 1), added);
        write_list(L, *box, list);
        note_moved(L, *box, place, before);
        return 0;
    }
    if (lua_gettop(L) >= 3 && lua_isinteger(L, 2))
        charge(L, "table.insert", lua_tointeger(L, 2), luaL_len(L, 1));
    return call_original(L);
}

int remove(lua_State* L) {
    check_list(L);
    if (const auto* box = list_at(L, 1)) {
        Value before = list_value(L, *box);
        const std::size_t size = before.list().size();
        if (size == 0) {
            lua_pushnil(L);
            return 1;
        }
        const std::size_t place =
            lua_isnoneornil(L, 2) ? size : position(L, 2, size, "table.remove");
        push_value(L, before.list()[place - 1]);
        if (place == size && change_element(L, *box, before, place, Value())) return 1;
        List list = before.list();
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(place - 1));
        write_list(L, *box, list);
        note_moved(L, *box, place, before);
        return 1;
    }
    if (lua_isinteger(L, 2)) charge(L, "table.remove", lua_tointeger(L, 2), luaL_len(L, 1));
    return call_original(L);
}

int concat(lua_State* L) {
    check_list(L);
    const lua_Integer from = luaL_optinteger(L, 3, 1);
    const lua_Integer to = lua_isnoneornil(L, 4) ? luaL_len(L, 1) : luaL_checkinteger(L, 4);
    charge(L, "table.concat", from, to);
    return call_original(L);
}

int move(lua_State* L) {
    charge(L, "table.move", luaL_checkinteger(L, 2), luaL_checkinteger(L, 3));
    return call_original(L);
}

int unpack(lua_State* L) {
    check_list(L);
    const lua_Integer from = luaL_optinteger(L, 2, 1);
    const lua_Integer to = lua_isnoneornil(L, 3) ? luaL_len(L, 1) : luaL_checkinteger(L, 3);
    charge(L, "table.unpack", from, to);
    return call_original(L);
}

constexpr std::size_t long_text = 4096;  // bytes

// Upvalue: the function that compares, or nil for `<`.
int compare_with_limit(lua_State* L) {
    std::size_t bytes = 0;
    for (const int index : {1, 2})
        if (lua_type(L, index) == LUA_TSTRING) bytes += lua_rawlen(L, index);
    machine_of(L).limiters.budget.charge_by_the_clock(L, 10 + bytes / 8);
    lua_settop(L, 2);
    if (lua_isnil(L, lua_upvalueindex(1))) {
        lua_pushboolean(L, lua_compare(L, 1, 2, LUA_OPLT));
        return 1;
    }
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, 2, 1);
    return 1;
}

/// Lua runs no hook between two comparisons that no script makes. If they may take long (of long
/// texts, by a function in C), replaces the function that compares by one that can be stopped.
void limit_comparisons(lua_State* L, lua_Integer length) {
    if (!machine_of(L).limiters.budget.counting() || lua_type(L, 1) != LUA_TTABLE) return;
    bool slow = lua_iscfunction(L, 2) != 0;
    if (!slow && !lua_isnoneornil(L, 2)) return;
    for (lua_Integer i = 1; i <= length && !slow; ++i) {
        lua_rawgeti(L, 1, i);
        slow = lua_type(L, -1) == LUA_TSTRING && lua_rawlen(L, -1) > long_text;
        lua_pop(L, 1);
    }
    if (!slow) return;
    lua_settop(L, 2);
    lua_pushcclosure(L, guarded<compare_with_limit>, 1);
}

// The cost is about n log n.
int sort(lua_State* L) {
    check_list(L);
    const lua_Integer length = luaL_len(L, 1);
    charge(L, "table.sort", 1, length);
    std::uint64_t rounds = 0;
    for (lua_Integer n = length; n > 1; n /= 2) ++rounds;
    machine_of(L).limiters.budget.charge(
        L, rounds * static_cast<std::uint64_t>(std::max<lua_Integer>(length, 0)));
    const auto* box = list_at(L, 1);
    if (box == nullptr) {
        limit_comparisons(L, length);
        return call_original(L);
    }
    // A table with its elements is sorted, and then written in one change. An error of the function
    // that compares leaves this frame without its destructors, so nothing is held meanwhile.
    const ListBox list = *box;
    push_value(L, list_value(L, list));
    lua_replace(L, 1);
    limit_comparisons(L, length);
    call_original(L);
    const Value before = list_value(L, list), sorted = to_value(L, 1);
    write_list(L, list, sorted.list());
    note_moved(L, list, 1, before);
    return 0;
}

}  // namespace

void open_table_guards(lua_State* L) {
    lua_getfield(L, -1, "table");
    wrap_pure<insert>(L, "table", "insert");
    wrap_pure<remove>(L, "table", "remove");
    wrap_pure<concat>(L, "table", "concat");
    wrap_pure<move>(L, "table", "move");
    wrap_pure<unpack>(L, "table", "unpack");
    wrap_pure<sort>(L, "table", "sort");
    lua_pop(L, 1);
}

}  // namespace fettle::script
