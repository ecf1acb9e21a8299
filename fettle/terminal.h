#pragma once
// What the program says, and where. A terminal obeys control characters: those in a script's
// messages, in the names of files and in what a game prints must not command it.

#include <string>
#include <string_view>

namespace fettle::program {

/// The text with its control characters and the bytes that are no UTF-8 as `\x1b`. Lines and tabs
/// stay as they are.
std::string without_controls(std::string_view text);
/// The same on one line: line ends become `\n`.
std::string on_one_line(std::string_view text);

/// "fettle: MESSAGE" as a line of stderr, behind all that was printed before.
void tell(std::string_view message);
/// Lines on stderr, as they are but for control characters.
void tell_lines(std::string_view text);
/// A line of stdout: what a game prints. As it is, unless a terminal is there.
void print_line(std::string_view text);
/// Writes what is still to be written to stdout. False when not all of it could be, which is told.
bool all_printed();

}  // namespace fettle::program
