#include <letters/shaping.h>

#include <algorithm>
#include <array>

#include <hb.h>

#include <fettle/property/line_breaks.h>

namespace fettle::visuals {
namespace {

struct Range {
    char32_t first, last;
};

/// Letters that are joined or reordered, that run from right to left, or that lie on others.
constexpr std::array with_shapes{
    Range{0x300, 0x36f},      // marks on letters
    Range{0x483, 0x489},      // marks on Cyrillic letters
    Range{0x590, 0x109f},     // Hebrew, Arabic, scripts of India and of South-East Asia
    Range{0x1700, 0x18af},    // Khmer, Mongolian and others
    Range{0x1900, 0x1cff},    // Balinese and others
    Range{0x1dc0, 0x1dff},    // marks
    Range{0x200c, 0x200f},    // joiners, directions
    Range{0x202a, 0x202e},    // directions
    Range{0x2066, 0x2069},    // directions
    Range{0x20d0, 0x20ff},    // marks
    Range{0xa800, 0xabff},    // Javanese and others
    Range{0xfb1d, 0xfdff},    // forms of Hebrew and Arabic letters
    Range{0xfe20, 0xfe2f},    // marks
    Range{0xfe70, 0xfefe},    // forms of Arabic letters
    Range{0x10800, 0x11fff},  // ancient scripts, scripts of India
    Range{0x1e800, 0x1efff}   // African scripts, Arabic for mathematics
};

bool has_shapes(std::u32string_view text) {
    return std::ranges::any_of(text, [](char32_t c) {
        return c >= with_shapes.front().first &&
               std::ranges::any_of(with_shapes, [c](const Range& range) {
                   return c >= range.first && c <= range.last;
               });
    });
}

/// Each letter by itself, with kerning.
Paragraph letter_by_letter(std::u32string_view text, const Family& family) {
    Paragraph made;
    made.units.reserve(text.size());
    made.glyphs.reserve(text.size());
    char32_t before = 0;
    const Font* before_font = nullptr;
    for (const char32_t c : text) {
        Unit unit{.letter = c, .first = made.glyphs.size()};
        if (c == U'\t' || c == property::zero_width_space) {
            before_font = nullptr;
        } else if (c != U'\r') {
            Font& font = family.with(c);
            const double x = before_font == &font ? font.kerning(before, c) : 0;
            made.glyphs.push_back({&font, font.glyph(c), x, 0});
            unit.count = 1;
            unit.advance = x + font.advance(c);
            before = c;
            before_font = &font;
        }
        made.units.push_back(unit);
    }
    return made;
}

/// Divides a text into runs.
class Runs {
  public:
    Runs(std::u32string_view text, const Family& family, const BidirectionalOrder& order)
        : text_(text), family_(family), order_(order) {}

    /// Calls `visit(font, run)` for each run.
    template <class Visit>
    void each(Visit visit) const {
        hb_unicode_funcs_t* const unicode = hb_unicode_funcs_get_default();
        Font* font = nullptr;
        Run run;
        for (std::size_t i = 0; i < text_.size(); ++i) {
            const char32_t c = text_[i];
            const std::uint32_t script = hb_unicode_script(unicode, c);
            const bool any_script = script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED;
            Font* const wanted = stays(c, script, font) ? font : &family_.with(c);
            const bool right_to_left = order_.level(i) % 2 != 0;
            const bool begins = wanted != font || right_to_left != run.right_to_left ||
                                (!any_script && !is_open(run) && script != run.script) ||
                                c == U'\t' || text_[run.begin] == U'\t';
            if (begins) {
                if (run.begin < i) visit(*font, run);
                // Punctuation and spaces have the script of the letters before them.
                run = {i, i, any_script ? run.script : script, right_to_left};
                font = wanted;
            } else if (!any_script) {
                run.script = script;
            }
            run.end = i + 1;
        }
        if (run.begin < run.end) visit(*font, run);
    }

  private:
    /// A run of which the letters so far belong to any script.
    static bool is_open(const Run& run) {
        return run.script == 0 || run.script == HB_SCRIPT_COMMON ||
               run.script == HB_SCRIPT_INHERITED;
    }
    /// What belongs to the letter before it is in the same font, and so are spaces. HarfBuzz does
    /// not show what only controls others.
    static bool stays(char32_t c, std::uint32_t script, const Font* font) {
        if (font == nullptr) return false;
        const bool controls = (c >= 0x200b && c <= 0x200f) || (c >= 0x202a && c <= 0x202e) ||
                              (c >= 0x2066 && c <= 0x2069) || c == 0x061c || c < 0x20;
        const bool is_space = c == U' ' && !font->of_pictures();
        return controls || ((script == HB_SCRIPT_INHERITED || is_space) && font->has(c));
    }

    std::u32string_view text_;
    const Family& family_;
    const BidirectionalOrder& order_;
};

/// Letters that are joined, in the order of their script.
Paragraph joined(std::u32string_view text, const Family& family) {
    Paragraph made;
    made.order.emplace(text);
    made.units.reserve(text.size());
    for (const char32_t c : text) made.units.push_back({.letter = c});
    Runs(text, family, *made.order).each([&](Font& font, const Run& run) {
        for (const ShapedGlyph& glyph : font.shape(text, run)) {
            Unit& unit = made.units[glyph.letter];
            if (unit.letter < 0x20) continue;
            if (unit.count++ == 0) unit.first = made.glyphs.size();
            made.glyphs.push_back({&font, glyph.glyph, unit.advance + glyph.x, glyph.y});
            unit.advance += glyph.advance;
        }
    });
    return made;
}

}  // namespace

Paragraph shaped(std::u32string_view text, const Family& family) {
    return has_shapes(text) ? joined(text, family) : letter_by_letter(text, family);
}

bool runs_right_to_left(std::u32string_view paragraph) {
    return has_shapes(paragraph) && BidirectionalOrder(paragraph).right_to_left();
}

}  // namespace fettle::visuals
