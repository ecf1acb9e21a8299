#pragma once
// Texts for a screen of fixed width.

#include <string>
#include <string_view>
#include <vector>

namespace fettle::script {

inline constexpr std::size_t line_width = 100;  // characters of a value on one line

/// A number as people write it: floats of native memory short, integral floats with ".0".
std::string number_for_people(double number);
/// Columns of text, padded to their widest cell; the last is not.
std::vector<std::string> columns(const std::vector<std::vector<std::string>>& rows);
/// How many characters a terminal shows of UTF-8 text.
std::size_t shown_width(std::string_view text);
/// `text` cut to about `width` characters, whole UTF-8 sequences only, with "…" where cut.
std::string cut(std::string_view text, std::size_t width);

}  // namespace fettle::script
