#pragma once
// The places of the letters of a text. All lengths are for a font of size 1, so one layout serves
// for the measure and for drawing in any size.

#include <string_view>
#include <vector>

#include <letters/fonts.h>
#include <letters/shaping.h>

namespace fettle::visuals {

enum class Align : unsigned char { left, center, right };

struct Layout {
    std::vector<PlacedGlyph> glyphs;  // from the top left corner
    double width = 0, height = 0;

    static constexpr double line_height = 1.2;
    static constexpr std::size_t most_letters = 100'000;

    /// Lines end at "\n", and before they become longer than `wrap` (0: never) at a space or where
    /// property::may_divide allows it. A tab goes on at the next multiple of two. Letters after the
    /// first `most_letters` are left out.
    static Layout of(std::string_view utf8, const Family& family, Align align, double wrap);

    /// Whether the first paragraph of a text runs from right to left.
    static bool right_to_left(std::string_view utf8);

    /// Where a caret stands in the first line of a text: before each letter and at the end, from
    /// the left end of the line.
    static std::vector<double> carets(std::string_view utf8, const Family& family);
};

}  // namespace fettle::visuals
