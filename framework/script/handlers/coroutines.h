#pragma once
// Coroutines. Every switch to another thread of Lua goes through here, so that the runtime knows
// which one runs, a command's budget follows it, and an error inside keeps its own traceback.

#include <lua/lua_api.h>

namespace fettle::script {

/// Resumes `thread` with `arguments` values on its stack; its results stay there, their number is
/// returned. Raises its error in `L`.
int resume_thread(lua_State* L, lua_State* thread, int arguments);
/// Replaces the table `coroutine` among the globals on top.
void open_coroutines(lua_State* L);

}  // namespace fettle::script
