#pragma once
// Lua values as one line for people: in the console, in lists of local variables, in messages. No
// metamethod of a script is called, and no address is shown.

#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

/// At most about 80 characters: `2`, `"text"`, `vec(1, 2)`, `world.ball`, `{1, 2, x = 3}`.
std::string short_text(lua_State* L, int index);
/// A key as in the text of a table: `name`, `["two words"]`, `[3]`.
std::string key_text(lua_State* L, int index);
/// A key for a message: a name unchanged, any other value as `short_text`.
std::string key_in_message(lua_State* L, int index);

}  // namespace fettle::script
