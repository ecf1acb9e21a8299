#pragma once
// A set of instances: what `find`, `all` and `children` return. A table 1..n with bulk :set, :add
// and :each.

#include <vector>

#include <fettle/property/value.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

void push_set(lua_State* L, const std::vector<property::Handle>& instances);
bool is_set(lua_State* L, int index);
void open_sets(lua_State* L, Machine& machine);
/// `query` among the globals on top.
void open_query(lua_State* L);

}  // namespace fettle::script
