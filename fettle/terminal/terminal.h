#pragma once
// Output on stdout and stderr. A terminal obeys control characters, so they are escaped in messages
// of scripts, names of files and output of games.

#include <string>
#include <string_view>
#include <vector>

namespace fettle::program {

/// Returns the text with control characters and bytes that are not UTF-8 escaped as `\x1b`. Line
/// ends and tabs are unchanged.
std::string without_controls(std::string_view text);
/// The same on one line: line ends become `\n`.
std::string on_one_line(std::string_view text);

/// Writes "fettle: MESSAGE" as a line to stderr, after everything that was printed before.
void print_error(std::string_view message);
/// Writes lines to stderr, with control characters escaped.
void print_error_lines(std::string_view text);
/// Writes a line of a game's output to stdout; control characters are escaped only for a terminal.
void print_line(std::string_view text);
/// Writes the lines of an answer of the console (`lines_of`): in the console's colors if stdout is
/// a terminal, NO_COLOR is not set, and TERM is not "dumb".
void print_answer(const std::vector<std::string>& lines);
/// A line that a command has led to after its answer, as a terminal shows it: indented like an
/// answer, unless it is an error.
std::string line_after_answer(std::string line);
/// Flushes stdout. If that fails, reports the error and returns false.
bool all_printed();

}  // namespace fettle::program
