#pragma once
// Arguments of the command line: what is expected of them, and what is said of one that is not as
// expected.

#include <cstdint>
#include <string>
#include <string_view>

namespace CLI {
class App;
}

namespace fettle::program {

/// A whole number in decimal digits. Throws CLI::ValidationError: "--steps: expected a whole number
/// from 0 to 100, got "-1"".
std::uint64_t whole_number(const std::string& option, std::string_view text, std::uint64_t least,
                           std::uint64_t most);

/// The text itself. Throws CLI::ValidationError for an empty one; `expected` says what it should
/// be.
std::string given(const std::string& option, const std::string& text, const char* expected);

/// Whether the first argument is a command of the program, or an option. What is said when it is
/// neither, with the nearest command; "" else.
std::string why_no_command(const CLI::App& app, std::string_view first);

/// What is said of arguments that nobody takes, with the nearest option of the command; "" when
/// there are none.
std::string why_left_over(const CLI::App& command);

}  // namespace fettle::program
