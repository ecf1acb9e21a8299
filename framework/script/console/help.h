#pragma once
// Documentation from the class descriptors: help(x), `path?`, find("word").

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
/// Of any value of Lua.
std::vector<std::string> help_lines(lua_State* L, int index);
/// Of what a path or name stands for; empty when it stands for nothing known.
std::vector<std::string> help_for(Machine& machine, const std::string& path);
/// Everything whose name or documentation has the word.
std::vector<std::string> find_lines(const property::Tree& tree, std::string_view word);

/// `help find` among the globals on top.
void open_help(lua_State* L);

}  // namespace fettle::script
