#pragma once
// `class("Ball", Body) { ... }`.

#include <string>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

/// The reason why no instance of a class can be created, as the end of a sentence.
std::string why_not_creatable(const property::Tree& tree, const property::Class& of);
/// Adds `class` to the table of globals at the top of the stack.
void open_class_function(lua_State* L);

}  // namespace fettle::script
