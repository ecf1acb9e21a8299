#pragma once
// Methods that classes declare, as functions of Lua.

#include <fettle/property/class.h>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

/// Registry reference of the function that calls `method`; made on first use.
int method_reference(lua_State* L, Machine& machine, const property::Method& method);
/// The method a function of Lua stands for, nullptr for any other function.
const property::Method* method_of(lua_State* L, int index);
/// "raycast(from, to [, filter])"
std::string signature(const property::Method& method);
void push_result(lua_State* L, const property::Result& result);
/// A table whose fields are checked: reading one that is not there is an error.
void push_record(lua_State* L, const property::Record& record);
void open_records(lua_State* L, Machine& machine);
/// Makes the table on top a checked one.
void seal_record(lua_State* L, Machine& machine);

}  // namespace fettle::script
