#pragma once
// Help texts from the class descriptors: help(x), `path?`.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

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
/// Adds `help` to the table of globals at the top of the stack.
void open_help(lua_State* L);

}  // namespace fettle::script
