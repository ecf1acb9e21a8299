#pragma once
// Texts for a screen of fixed width.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

inline constexpr std::size_t line_width = 100;  // characters of a value on one line

/// What came from a float in memory reads as it was written: 0.1, not 0.10000000149011612.
property::Precision shortest_precision(double number);
property::Precision shortest_precision(const property::Vec2& vec);
/// A number as people write it: floats of native memory short, integral floats with ".0".
std::string number_for_people(double number);
/// Columns of text, padded to their widest cell; the last is not.
std::vector<std::string> columns(const std::vector<std::vector<std::string>>& rows);
/// How many characters a terminal shows of UTF-8 text.
std::size_t shown_width(std::string_view text);
/// `text` cut to about `width` characters, whole UTF-8 sequences only, with "…" where cut.
std::string cut(std::string_view text, std::size_t width);

}  // namespace fettle::script
