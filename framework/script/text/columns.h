#pragma once
// Formats texts for a screen of fixed width.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

inline constexpr std::size_t line_width = 100;  // characters of a value on one line

/// A number for people: values of floats in short form, integral floats with ".0".
std::string number_for_people(double number);
/// Joins the cells of each row. Cells are padded to the width of their column, except in the last.
/// Cells that are far wider than the others of their column are not cut and stand out of it.
/// `cells`: of each line, the bytes where its cells begin.
std::vector<std::string> columns(const std::vector<std::vector<std::string>>& rows,
                                 std::vector<std::vector<std::size_t>>* cells = nullptr);
/// Number of characters of UTF-8 text.
std::size_t shown_width(std::string_view text);
/// `text` cut to about `width` characters, never inside a UTF-8 sequence, with "…" at the cut.
std::string cut(std::string_view text, std::size_t width);

}  // namespace fettle::script
