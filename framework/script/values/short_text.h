#pragma once
// Values of Lua as one line for people: in the console, among local variables, in messages. Nothing
// here calls into a script, so hostile metamethods have no say, and no address is ever shown.

#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

/// At most about 80 characters: `2`, `"text"`, `vec(1, 2)`, `world.ball`, `{1, 2, x = 3}`.
std::string short_text(lua_State* L, int index);
/// A key in the text of a table: `name`, `["two words"]`, `[3]`.
std::string key_text(lua_State* L, int index);
/// A key in a message: a name as it is, anything else as `short_text`.
std::string key_in_message(lua_State* L, int index);

}  // namespace fettle::script
