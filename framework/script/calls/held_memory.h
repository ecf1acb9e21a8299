#pragma once
// Memory that a function keeps: for lists of old functions with a limit.

#include <cstddef>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// What was counted already.
struct CountedMemory {
    int set = 0;                 // weak table in the registry: tables and functions; 0: none yet
    const void* text = nullptr;  // the text counted last
};

/// Bytes, about, by which Lua's memory may be larger because the function at `index` is kept: its
/// own, and those of tables, functions and long texts among its local variables of outer functions,
/// times `collector_pause`. What was counted for another function before is not counted again, nor
/// is what the game's globals hold. Looks at 65 536 values at most.
std::size_t held_memory(lua_State* L, Machine& machine, int index);

}  // namespace fettle::script
