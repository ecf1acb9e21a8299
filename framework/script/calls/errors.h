#pragma once
// Descriptions of errors at the point where they are raised: message, place, traceback, local
// variables.

#include <optional>
#include <string>
#include <vector>

#include <fettle/script/runtime.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Errors {
    std::optional<ScriptError> caught;        // described where it was raised, not yet reported
    std::optional<ScriptError> thread_error;  // raised in a coroutine, on its way out of it
    int reports = 0;                          // calls of the host's sink that have not returned
    // Functions whose errors are as the script wants them: `error`, `assert`, those of wrapped
    // coroutines.
    std::vector<lua_CFunction> raise_as_told;
};

/// Of the error object at `index` of `from`, raised on the stack of `L` above `level`.
ScriptError describe_error(Machine& machine, lua_State* L, int level, lua_State* from, int index);
/// A message for an error object of any type, without control characters; calls nothing of a script
/// but a `__tostring` of its own.
std::string error_text(lua_State* L, int index);
/// Puts the script's position in front of the error on top of `from` when it has none because a
/// function in C raised it that knows none: Lua's own functions do so for what goes wrong deeper
/// inside. `level`: of the function that raised it, on the stack of `L`.
void add_missing_position(lua_State* L, lua_State* from, int level);
/// For lua_pcall: does that.
int placing_handler(lua_State* L);
/// Where a script is, without anything having gone wrong.
ScriptError describe_place(Machine& machine, lua_State* L);
/// For lua_pcall: describes the error into `machine.errors.caught` and returns it.
int describing_handler(lua_State* L);
/// An error of which nothing is known but its message.
ScriptError bare_error(Machine& machine, std::string message);

}  // namespace fettle::script
