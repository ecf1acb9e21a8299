#pragma once
// Checks of command line arguments, and the messages for invalid ones.

#include <cstdint>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace fettle::program {

/// Parses a whole number in decimal digits. Throws CLI::ValidationError, for example: --steps:
/// expected a whole number from 0 to 100, got "-1".
std::uint64_t whole_number(const std::string& option, std::string_view text, std::uint64_t min,
                           std::uint64_t max);

/// Returns `text`. Throws CLI::ValidationError if it is empty; `expected` describes a valid value.
std::string checked_text(const std::string& option, const std::string& text, const char* expected);

/// Returns "" if the first argument is a command of the program or an option. Otherwise returns an
/// error message with the nearest command.
std::string command_problem(const CLI::App& app, std::string_view first);

/// Returns an error message for arguments that no option takes, with the nearest option of the
/// command. Returns "" if there are none.
std::string left_over_problem(const CLI::App& command);

}  // namespace fettle::program
