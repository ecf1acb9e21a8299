#pragma once
// A whole value as lines of the console: instances and sets of instances as tables with units.

#include <string>
#include <vector>

#include <lua/lua_api.h>

namespace fettle::script {

std::vector<std::string> long_text(lua_State* L, int index);

}  // namespace fettle::script
