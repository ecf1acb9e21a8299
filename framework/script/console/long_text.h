#pragma once
// Formats a whole value as lines for the console; instances and sets of instances become tables
// with units.

#include <string>
#include <vector>

#include <lua/lua_api.h>

namespace fettle::script {

std::vector<std::string> long_text(lua_State* L, int index);

}  // namespace fettle::script
