#pragma once
// Class objects for scripts: `Body { ... }`.

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

void open_classes(lua_State* L, Machine& machine);

}  // namespace fettle::script
