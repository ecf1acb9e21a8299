#pragma once
// Global names of the game and the console.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// `in_tree`: `game` or a child of it.
using GlobalName = std::function<void(std::string_view name, bool in_tree)>;
/// Calls `use` with each valid global name, with some of them twice.
void each_global_name(Machine& machine, const GlobalName& use);
/// All valid global names, sorted.
std::vector<std::string> global_names(Machine& machine);
/// Pushes the result of the last console command.
void push_last_result(lua_State* L, Machine& machine);
/// Pushes the value of a name that is not in the environment: `game`, its children, classes, `it`,
/// `_`.
bool push_known_global(lua_State* L, Machine& machine, std::string_view name);

/// Read and write a variable that `state` declared. Return false for any other name.
bool read_stated(lua_State* L, Machine& machine, std::string_view name);
bool write_stated(lua_State* L, Machine& machine, std::string_view name, int value);

/// Messages about variables whose current value, from before a reload or from a saved game, has
/// another type than the value that `state` declares. `only`: only about this variable.
std::vector<std::string> stated_problems(const Machine& machine, std::string_view only = {});

/// Makes the table at the top of the stack the environment of all scripts.
void open_globals(lua_State* L, Machine& machine);

}  // namespace fettle::script
