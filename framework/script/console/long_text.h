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

/// Adds "… 77 more (107 WHAT)" for `total` rows of which `shown` are lines, and folds `rest` there.
void fold_rest(std::vector<std::string>& lines, std::vector<std::string> rest, std::size_t shown,
               std::size_t total, const char* what, FoldedLines& folded);
/// How many rows are folded at most.
inline constexpr std::size_t max_folded = 1000;

}  // namespace fettle::script
