#pragma once
// Coroutines. Every switch to another Lua thread goes through this file, so that the runtime stores
// the running thread, the budget of a command counts coroutines, and an error in a coroutine keeps
// its own traceback.

#include <lua/lua_api.h>

namespace fettle::script {

/// Resumes `thread` with `arguments` values on its stack. Returns the number of results, which stay
/// on that stack. An error is raised again in `L`.
int resume_thread(lua_State* L, lua_State* thread, int arguments);
/// Replaces the table `coroutine` in the table of globals at the top of the stack.
void open_coroutines(lua_State* L);

}  // namespace fettle::script
