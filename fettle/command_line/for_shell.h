#pragma once
// Arguments in the messages that name a command.

#include <string>

namespace fettle::program {

/// The text in the form in which it must be typed as an argument.
std::string for_shell(const std::string& text);

}  // namespace fettle::program
