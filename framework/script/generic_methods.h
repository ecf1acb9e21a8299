#pragma once
// What every instance can do, whatever its class: delete, has, watch, on, add, find, each, all ...

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

struct GenericMethod {
    const char* name;
    const char* signature;  // as in language.h
    const char* doc;
    lua_CFunction function;
};

const std::vector<GenericMethod>& generic_methods();
/// Registry reference of the method of that name, LUA_NOREF when there is none.
int generic_reference(lua_State* L, Machine& machine, std::string_view name);

}  // namespace fettle::script
