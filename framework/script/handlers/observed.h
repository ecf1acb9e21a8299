#pragma once
// Values that a person observes, and `it` in texts and functions that outlive the selection.

#include <string>
#include <string_view>

#include <fettle/script/observed.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// The text with the path of the selected instance in place of `it`. Throws Error if `it` is
/// mentioned and nothing is selected, or if what is selected has no place in the tree.
std::string with_selected(Machine& machine, std::string_view source);
/// From now on, `it` in the function at `index` is the instance that is selected now, even if
/// another one is selected later.
void bind_selected(lua_State* L, Machine& machine, int index);

/// A path or an expression as a value to observe. Throws Error for a text that does not compile.
Observed observe(Machine& machine, std::string_view expression);
/// The argument at `index`: a text or a function; otherwise raises an error.
Observed observe(lua_State* L, int index, const char* what);

}  // namespace fettle::script
