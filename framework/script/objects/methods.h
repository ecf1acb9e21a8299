#pragma once
// Methods that classes declare, as functions of Lua.

#include <fettle/property/class.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Registry reference of the function that calls `method`; made on first use.
int method_reference(lua_State* L, Machine& machine, const property::Method& method);

}  // namespace fettle::script
