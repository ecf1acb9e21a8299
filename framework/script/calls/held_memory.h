#pragma once
// Estimates the memory that a function keeps, for lists of old functions with a memory limit.

#include <cstddef>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// The estimated number of bytes by which Lua's memory grows if the function at `index` is kept:
/// the function itself, and the tables, functions and long texts in its local variables of outer
/// functions, times `collector_pause`. Does not count values that were counted before or that the
/// globals refer to. Checks at most 65 536 values.
std::size_t held_memory(lua_State* L, Machine& machine, int index);

}  // namespace fettle::script
