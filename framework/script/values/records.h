#pragma once
// Records: tables whose fields are checked, so that reading one that is not there is an error. What
// methods return and what handlers are told.

#include <fettle/property/class.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// What a method of a descriptor returned.
void push_result(lua_State* L, const property::Result& result);
void push_record(lua_State* L, const property::Record& record);
/// Makes the table on top a record.
void seal_record(lua_State* L, Machine& machine);
void open_records(lua_State* L, Machine& machine);

}  // namespace fettle::script
