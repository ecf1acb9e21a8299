#pragma once
// Records: results of methods and arguments of handlers. They are tables, but reading a field that
// does not exist is an error.

#include <fettle/property/class.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Pushes the result of a method.
void push_result(lua_State* L, const property::Result& result);
void push_record(lua_State* L, const property::Record& record);
/// Whether the value at `index` is a record, as handlers of events get one.
bool is_record(lua_State* L, int index);
/// Makes the table at the top of the stack a record.
void seal_record(lua_State* L, Machine& machine);
void open_records(lua_State* L, Machine& machine);

}  // namespace fettle::script
