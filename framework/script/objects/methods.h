#pragma once
// Declared methods of classes as Lua functions.

#include <fettle/property/class.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Registry reference of the Lua function that calls `method`; it is made on first use.
int method_reference(lua_State* L, Machine& machine, const property::Method& method);

}  // namespace fettle::script
