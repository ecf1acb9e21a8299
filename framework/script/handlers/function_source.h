#pragma once
// The text of a function of a script, as it stands in its file: what a formula is shown by, and
// saved as.

#include <string>
#include <string_view>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct FunctionSource {
    std::string text;  // "function() return ball.mass * 2 end"; "" when it is not known
    /// Why the text alone does not make the same function again; "" when it does.
    std::string not_saved;
};

/// Of the function at `index`. It is found by its lines, and compiled and compared with the
/// function itself, so that a text which was replaced since, or another function on the same line,
/// is never taken for it.
FunctionSource function_source(lua_State* L, Machine& machine, int index);

/// Whether a formula's text is that of a function, rather than an expression.
bool is_function_text(std::string_view text);

}  // namespace fettle::script
