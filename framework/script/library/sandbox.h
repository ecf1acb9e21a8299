#pragma once
// What scripts may use of Lua's own library: an environment of allowed names, with the dangerous
// ones left out or replaced.

#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Pushes the table of globals with what is allowed of Lua's own library.
void open_sandbox(lua_State* L);

// Each into the table of globals on top.
void open_base(lua_State* L);
void open_table_guards(lua_State* L);
void open_strings(lua_State* L);
void open_patterns(lua_State* L);
void open_require(lua_State* L);
void open_scenes(lua_State* L);
void open_saves(lua_State* L);
void open_tweaks(lua_State* L);
void open_history(lua_State* L);

/// A line of `print`: into the console's answer or to the host.
void print_line(Machine& machine, std::string text);
/// In a replay: true, and tells that `what` writes nothing. No error, or the replay would go
/// another way than the run did.
bool tell_of_replay(Machine& machine, const std::string& what);
/// Text of any value without calling anything but a script's own __tostring.
void push_tostring(lua_State* L, int index);

}  // namespace fettle::script
