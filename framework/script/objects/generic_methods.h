#pragma once
// Methods that every instance has, whatever its class: delete, has, watch, on, add, find, each, all
// ... `instance_docs` describes them.

#include <string_view>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Registry reference of the method of that name; LUA_NOREF if there is none.
int generic_reference(lua_State* L, Machine& machine, std::string_view name);
/// The name of the method at `index`; "" for any other function.
std::string_view generic_name(lua_State* L, int index);

}  // namespace fettle::script
