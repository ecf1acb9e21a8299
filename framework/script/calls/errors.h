#pragma once
// Describes errors where they are raised: message, place, traceback, local variables.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fettle/script/runtime.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Errors {
    std::optional<ScriptError> caught;        // described where it was raised, not reported yet
    std::optional<ScriptError> thread_error;  // raised in a coroutine, now on its way out
    // Places whose error about an instance that a restore removed was reported.
    std::set<std::string> reported_gone;
    int reports = 0;  // running calls of the host's function for errors
    // Functions that pass on a script's own error unchanged: `error`, `assert` and the functions of
    // wrapped coroutines.
    std::vector<lua_CFunction> raise_unchanged;
};

/// Describes the error object at `index` of `from`, raised on the stack of `L` above `level`.
ScriptError describe_error(Machine& machine, lua_State* L, int level, lua_State* from, int index);
/// A message for an error object of any type, without control characters. The only script function
/// that it calls is the object's own `__tostring`.
std::string error_text(lua_State* L, int index);
/// Completes the error at the top of the stack `from`. If a C function raised it, it gets the
/// script's position, as Lua's own functions do; if Lua raised it, a hint for those who know
/// another language. `level`: the function that raised the error, on the stack of `L`.
void complete_message(lua_State* L, lua_State* from, int level);
/// The same as a message handler for lua_pcall.
int placing_handler(lua_State* L);
/// The current place of the script, without an error.
ScriptError describe_place(Machine& machine, lua_State* L);
/// Message handler for lua_pcall: describes the error in `machine.errors.caught` and returns it.
int describing_handler(lua_State* L);
/// A description that contains only the message.
ScriptError bare_error(Machine& machine, std::string message);

}  // namespace fettle::script
