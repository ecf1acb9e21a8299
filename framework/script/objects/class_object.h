#pragma once
// Every class of the tree is an object in scripts: `Body { ... }`, `class("Ball", Body) { ... }`.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// The text keys of a table in their order. Throws for a key that is neither text nor a whole
/// number; `what`: whose table it is.
std::vector<std::string> sorted_keys(lua_State* L, int table, const std::string& what);
/// Why an instance of a class that is not creatable cannot be made, as the end of a sentence.
std::string why_not_creatable(const property::Tree& tree, const property::Class& of);
void open_classes(lua_State* L, Machine& machine);
/// `class` among the globals on top.
void open_class_function(lua_State* L);

}  // namespace fettle::script
