#pragma once
// Help texts from the class descriptors: help(x), `path?`, find("word").

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

std::vector<std::string> property_help(const property::Tree& tree,
                                       const property::Property& property);
std::vector<std::string> method_help(const property::Method& method);
std::vector<std::string> class_help(Machine& machine, const property::Class& of);
/// Help for any Lua value.
std::vector<std::string> help_lines(lua_State* L, int index);
/// Help for a path or name; empty if it is not known.
std::vector<std::string> help_for(Machine& machine, const std::string& path);
/// Lists the entries whose name or documentation contains the word. `folded`: gets those beyond the
/// first fifty.
std::vector<std::string> find_lines(const property::Tree& tree, std::string_view word,
                                    FoldedLines& folded);

/// Adds `help` and `find` to the table of globals at the top of the stack.
void open_help(lua_State* L);

}  // namespace fettle::script
