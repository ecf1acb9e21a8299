#pragma once
// The glyphs of the letters of a text, before it is divided into lines.

#include <optional>
#include <string_view>
#include <vector>

#include <letters/bidirectional.h>
#include <letters/fonts.h>

namespace fettle::visuals {

struct PlacedGlyph {
    Font* font = nullptr;
    unsigned glyph = 0;
    double x = 0, y = 0;  // of the pen on the baseline, y down
};

/// A letter of a text. The glyphs of letters that are joined belong to the first of them; the
/// others have none.
struct Unit {
    char32_t letter = 0;
    std::size_t first = 0, count = 0;  // of its glyphs
    double advance = 0;                // of the pen; 0 for a tab
};

/// All lengths are for a font of size 1.
struct Paragraph {
    std::vector<Unit> units;
    std::vector<PlacedGlyph> glyphs;          // from the pen position of their unit
    std::optional<BidirectionalOrder> order;  // without: from left to right
};

/// Whether a paragraph, which has no line breaks in it, runs from right to left.
bool runs_right_to_left(std::u32string_view paragraph);

/// `text` has no line breaks.
Paragraph shaped(std::u32string_view text, const Family& family);

}  // namespace fettle::visuals
