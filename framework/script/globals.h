#pragma once
// Global names of game and console.

#include <string>
#include <string_view>
#include <vector>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

/// Functions of a game that the host calls.
const std::vector<std::string>& callback_names();
/// Names of the language that have their place but no implementation yet.
const std::vector<std::string>& later_names();
/// Everything a global name can stand for, sorted.
std::vector<std::string> global_names(Machine& machine);
/// Pushes the result of the last console command.
void push_last_result(lua_State* L, Machine& machine);
/// Pushes what a name means that the environment does not hold: `game`, its children, classes,
/// `it`, `_`.
bool push_known_global(lua_State* L, Machine& machine, std::string_view name);

}  // namespace fettle::script
