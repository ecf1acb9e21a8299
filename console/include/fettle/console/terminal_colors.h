#pragma once
// The colors of the console for output in a terminal.

#include <string>
#include <string_view>

#include <fettle/console/export.h>

FETTLE_CONSOLE_BEGIN

namespace fettle::console {

/// A line that a command printed, with escape sequences of 24 bit colors: paths, numbers, texts and
/// arrows have the colors that they have in the console. `line` must have no control characters.
std::string colored_output(std::string_view line);
/// The same for a line of an error.
std::string colored_error(std::string_view line);

}  // namespace fettle::console

FETTLE_CONSOLE_END
