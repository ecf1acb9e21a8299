#pragma once
// Texts in quotes: what a terminal would obey, or a reader would be misled by, stands as decimal
// digits.

#include <cstddef>
#include <string>
#include <string_view>

namespace fettle::property {

/// The character of `text` at `at` as it stands in quotes; `at` is then behind it.
void append_escaped(std::string& out, std::string_view text, std::size_t& at);
/// What `\` at `at` stands for: a byte by its decimal digits, or the next character as it is. `at`
/// is then at the last character that was read.
char unescaped(std::string_view text, std::size_t& at);

}  // namespace fettle::property
