#include <calls/held_memory.h>
#include <lua/environment.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>

namespace fettle::script {
namespace {

// Sizes in bytes in Lua 5.4 on 64-bit systems.
constexpr std::size_t function_size = 64, upvalue_size = 56, table_size = 56, element_size = 16,
                      entry_size = 40, text_size = 32;
constexpr std::size_t min_text = 64;  // shorter texts are not counted
constexpr int max_values = 1 << 16, deepest_value = 16;

class Measure {
  public:
    Measure(lua_State* L, Machine& machine) : L_(L), machine_(machine) {
        luaL_checkstack(L, 4 * deepest_value + 8, "a function's memory");
        if (machine.lua.counted.set == 0) make_set();
        push_registry(L, machine.lua.counted.set);
        set_ = lua_gettop(L);
    }
    ~Measure() { lua_settop(L_, set_ - 1); }
    Measure(const Measure&) = delete;

    std::size_t of(int index, int depth = 0) {
        if (--left_ < 0 || depth > deepest_value) return 0;
        switch (lua_type(L_, index)) {
            case LUA_TSTRING:
                return text(index);
            case LUA_TTABLE:
                return is_new(index) ? table(index, depth) : 0;
            case LUA_TFUNCTION:
                return is_new(index) ? function(index, depth) : 0;
            default:
                return 0;
        }
    }

  private:
    /// Makes a weak set, which keeps no value alive. The globals are in it from the beginning, so
    /// they are not counted.
    void make_set() {
        push_weak_table(L_, "k");
        for (const int known : {machine_.globals.table, machine_.globals.loaded}) {
            push_registry(L_, known);
            lua_pushboolean(L_, 1);
            lua_rawset(L_, -3);
        }
        machine_.lua.counted.set = luaL_ref(L_, LUA_REGISTRYINDEX);
    }

    bool is_new(int index) {
        lua_pushvalue(L_, index);
        const bool known = lua_rawget(L_, set_) != LUA_TNIL;
        lua_pop(L_, 1);
        if (known) return false;
        lua_pushvalue(L_, index);
        lua_pushboolean(L_, 1);
        lua_rawset(L_, set_);
        return true;
    }

    std::size_t text(int index) {
        const std::size_t size = lua_rawlen(L_, index);
        const void* const address = lua_topointer(L_, index);
        if (size < min_text || address == machine_.lua.counted.text) return 0;
        machine_.lua.counted.text = address;
        return size + text_size;
    }

    std::size_t table(int index, int depth) {
        std::size_t bytes = table_size + lua_rawlen(L_, index) * element_size;
        lua_pushnil(L_);
        while (lua_next(L_, index) != 0) {
            const int value = lua_gettop(L_);
            bytes += of(value, depth + 1) + (lua_isinteger(L_, value - 1) ? 0 : entry_size);
            lua_pop(L_, 1);
            if (left_ >= 0) continue;
            lua_pop(L_, 1);
            break;
        }
        return bytes;
    }

    std::size_t function(int index, int depth) {
        std::size_t bytes = function_size;
        for (int i = 1; lua_getupvalue(L_, index, i) != nullptr; ++i) {
            bytes += upvalue_size + of(lua_gettop(L_), depth + 1);
            lua_pop(L_, 1);
        }
        return bytes;
    }

    lua_State* L_;
    Machine& machine_;
    int set_ = 0;
    int left_ = max_values;
};

}  // namespace

std::size_t held_memory(lua_State* L, Machine& machine, int index) {
    const int function = lua_absindex(L, index);
    // Kept memory delays Lua's next collection, so the garbage until then counts, too.
    return Measure(L, machine).of(function) * (collector_pause / 100);
}

}  // namespace fettle::script
