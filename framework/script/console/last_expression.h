#pragma once
// Commands of several statements whose last one is an expression, as `local y = 3; y`.

#include <string_view>

#include <lua/lua_api.h>

namespace fettle::script {

/// Compiles such a command so that it returns the value of its last expression, and leaves the
/// function on the stack. False, with nothing on the stack, if the command is none.
bool load_with_last_expression(lua_State* L, std::string_view command, const char* chunk);

}  // namespace fettle::script
