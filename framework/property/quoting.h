#pragma once
// Texts in quotes: what a terminal would obey, or a reader would be misled by, stands as decimal
// digits.

#include <cstddef>
#include <string>
#include <string_view>

namespace fettle::property {

/// How many bytes of `text` at `at` are a control character: of C0, DEL, of C1, or one that turns
/// the direction of writing. 0: it is none.
std::size_t control_character(std::string_view text, std::size_t at);
/// One byte as `\ddd`: three digits always, so that a digit that follows is not part of it.
void append_digits(std::string& out, char byte);
/// What `\` at `at` stands for: a byte by its decimal digits, or the next character as it is. `at`
/// is then at the last character that was read.
char unescaped(std::string_view text, std::size_t& at);

}  // namespace fettle::property
