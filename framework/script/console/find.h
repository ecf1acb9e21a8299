#pragma once
// find("word") searches names and documentation; find("mass > 5") the instances.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

#include <lua/lua_api.h>

namespace fettle::script {

/// Lists the entries whose name or documentation contains the word. `folded`: gets those beyond the
/// first fifty.
std::vector<std::string> find_lines(const property::Tree& tree, std::string_view word,
                                    FoldedLines& folded);

/// Adds `find` to the table of globals at the top of the stack.
void open_find(lua_State* L);

}  // namespace fettle::script
