#pragma once
// How a script wrote a call: with a dot or with a colon. For messages about calls with the wrong
// one, whose arguments are shifted by one place.

#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

/// "; call it with a colon: world:add(...)" if the function at `level` of the stack was called as
/// world.add(...), otherwise "".
std::string colon_hint(lua_State* L, int level);
/// "; call it with a dot: math.floor(...)" if the function at `level` was called as math:floor(...)
/// and `math` is a table that has it, otherwise "".
std::string dot_hint(lua_State* L, int level);

}  // namespace fettle::script
