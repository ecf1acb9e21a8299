#pragma once
// Texts in quotes. Characters that control a terminal or could mislead a reader are written as
// decimal numbers.

#include <cstddef>
#include <string>
#include <string_view>

namespace fettle::property {

/// Appends the quoted form of the character at `at` and moves `at` after it.
void append_escaped(std::string& out, std::string_view text, std::size_t& at);
/// The character after `\` at `at`: a byte by its decimal digits, or the next character itself.
/// Moves `at` to the last character that was read.
char unescaped(std::string_view text, std::size_t& at);

}  // namespace fettle::property
