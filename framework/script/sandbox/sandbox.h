#pragma once
// The part of Lua's library that scripts may use: an environment of allowed names. Dangerous
// functions are missing or replaced.

#include <string>

#include <fettle/script/runtime.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Pushes a table of globals with the allowed part of Lua's library.
void open_sandbox(lua_State* L);

// Each function adds its names to the table of globals at the top of the stack.
void open_base(lua_State* L);
void open_table_guards(lua_State* L);
void open_strings(lua_State* L);
void open_patterns(lua_State* L);
void open_require(lua_State* L);

/// Prints a line: into the result of a console command, or to the host.
void print_line(Machine& machine, std::string text);
/// Prints lines, one of which stands for folded ones.
void print_folded(Machine& machine, std::vector<std::string> lines, FoldedLines folded);
/// Pushes the text of any value. The only script function that it calls is a `__tostring`.
void push_tostring(lua_State* L, int index);

}  // namespace fettle::script
