#pragma once
// Sets of instances, which `find`, `all` and `children` return: a table 1..n with the methods :set,
// :add and :each for all elements.

#include <string>
#include <vector>

#include <fettle/property/value.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

void push_set(lua_State* L, const std::vector<property::Handle>& instances);
/// The instances for which a condition holds (condition.h). Throws Error for a text that is none,
/// and for a name that nothing has.
std::vector<property::Handle> instances_matching(lua_State* L, const std::string& condition);
bool is_set(lua_State* L, int index);
void open_sets(lua_State* L, Machine& machine);
/// Adds `query` to the table of globals at the top of the stack.
void open_query(lua_State* L);

}  // namespace fettle::script
