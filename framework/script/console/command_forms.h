#pragma once
// Forms of commands that are no Lua: `undo` without brackets, `who world.gravity` without quotes,
// and several of them on one line.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::script {

/// Functions without arguments that may be typed without parentheses.
bool is_bare_command(std::string_view command);
/// Functions whose arguments may be typed without brackets and quotes.
bool takes_words(std::string_view function);
/// The arguments that commas separate, outside of brackets and quotes.
std::vector<std::string_view> arguments_of(std::string_view text);
/// The texts that semicolons and line ends separate, outside of brackets, quotes and comments;
/// without blanks at their ends, and without empty ones.
std::vector<std::string> separate_commands(std::string_view text);

/// Adds what another command has printed, its result and its error.
void append(Evaluation& all, Evaluation next);

}  // namespace fettle::script
