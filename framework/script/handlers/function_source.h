#pragma once
// Finds the source text of a script's function, with which a formula is shown and saved.

#include <string>
#include <string_view>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct FunctionSource {
    std::string text;  // "function() return ball.mass * 2 end"; "" if unknown
    /// The reason why the text alone does not make the same function; "" if it does.
    std::string not_saved;
};

/// The source of the function at `index`. A text found by line numbers is compiled and compared
/// with the function, so a text that was replaced since, or another function on the same line, is
/// never returned.
FunctionSource function_source(lua_State* L, Machine& machine, int index);

/// Whether the text of a formula is a function and not an expression.
bool is_function_text(std::string_view text);

}  // namespace fettle::script
