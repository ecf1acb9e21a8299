#pragma once
// Global names of game and console.

#include <string>
#include <string_view>
#include <vector>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Everything a global name can stand for, sorted.
std::vector<std::string> global_names(Machine& machine);
/// Pushes the result of the last console command.
void push_last_result(lua_State* L, Machine& machine);
/// Pushes what a name means that the environment does not hold: `game`, its children, classes,
/// `it`, `_`.
bool push_known_global(lua_State* L, Machine& machine, std::string_view name);

/// Makes the table of globals on top the environment of scripts.
void open_globals(lua_State* L, Machine& machine);

}  // namespace fettle::script
