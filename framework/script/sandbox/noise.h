#pragma once
// Smooth noise, for landscapes and motion that never repeats. The same point has the same value on
// every machine.

#include <lua/lua_api.h>

namespace fettle::script {

/// Adds `noise` to the table `math` in the table of globals at the top of the stack.
void open_noise(lua_State* L);

}  // namespace fettle::script
