#pragma once
// What went wrong, described where it went wrong: message, place, traceback, local variables.

#include <string>

#include <fettle/script/runtime.h>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

/// Of the error object at `index` of `from`, raised on the stack of `L` above `level`.
ScriptError describe_error(Machine& machine, lua_State* L, int level, lua_State* from, int index);
/// A message for an error object of any type; calls nothing of a script.
std::string error_text(lua_State* L, int index);
/// For lua_pcall: describes the error into `machine.caught` and returns it.
int describing_handler(lua_State* L);
/// Hands the error over and forgets it.
void report(Machine& machine, ScriptError error);

}  // namespace fettle::script
