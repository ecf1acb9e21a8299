#pragma once
// Class objects for scripts: `Body { ... }`, `class("Ball", Body) { ... }`.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// The text keys of a table, sorted. Throws for a key that is neither text nor a whole number;
/// `what` names the table.
std::vector<std::string> sorted_keys(lua_State* L, int table, const std::string& what);
/// The reason why no instance of a class can be created, as the end of a sentence.
std::string why_not_creatable(const property::Tree& tree, const property::Class& of);
void open_classes(lua_State* L, Machine& machine);
/// Adds `class` to the table of globals at the top of the stack.
void open_class_function(lua_State* L);

}  // namespace fettle::script
