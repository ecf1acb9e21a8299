#pragma once
// Formats a whole value as lines for the console; instances and sets of instances become tables
// with units.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

#include <lua/lua_api.h>

namespace fettle::script {

/// `command`: the command whose result it is. A table of instances has columns for the properties
/// that it names. `table`: gets the cells of such a table; its lines are the first ones. `folded`:
/// gets the rows beyond those that are shown.
std::vector<std::string> long_text(lua_State* L, int index, std::string_view command,
                                   TableLines& table, FoldedLines& folded);

}  // namespace fettle::script
