#pragma once
// Hints about variables: a property of `self` without `self`, and a variable that begins further
// down in its file.

#include <string>
#include <string_view>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// ` (did you mean self.lives?)` if the function that reads or writes the global name has a `self`
/// with a property, a method or a child of that name; "" otherwise. With `properties_only` methods
/// and children do not count.
std::string hint_of_self(lua_State* L, Machine& machine, std::string_view name,
                         bool properties_only = false);
/// `; line 12 makes it, which is later` if another line of the file makes a variable or a function
/// of that name; "" otherwise.
std::string hint_of_later_line(lua_State* L, const Machine& machine, std::string_view name);
/// Whether the function of a script that is running has a local variable of that name.
bool has_local(lua_State* L, std::string_view name);

}  // namespace fettle::script
