#include <letters/layout.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fettle/property/line_breaks.h>
#include <fettle/property/utf8.h>

namespace fettle::visuals {
namespace {

constexpr double tab_stop = 2, least_tab = 0.3;

/// A line of a paragraph: its letters from `begin` to `end`.
struct Line {
    std::size_t begin = 0, end = 0;
    double length = 0;
    double width = 0;  // without spaces at the end
};

/// Divides a paragraph into lines, and gives its tabs their width.
class Divider {
  public:
    Divider(Paragraph& paragraph, double wrap) : paragraph_(paragraph), wrap_(wrap) {}

    std::vector<Line> lines() {
        char32_t before = 0;
        for (std::size_t i = 0; i < paragraph_.units.size(); ++i) {
            Unit& unit = paragraph_.units[i];
            const char32_t c = unit.letter;
            if (c == U'\r') continue;
            if (c == U'\t') {
                const double to =
                    tab_stop * std::ceil((line_.length + least_tab) / tab_stop - 1e-6);
                unit.advance = to - line_.length;
                line_.length = to;
                before = 0;
                may_end_before(i + 1);
                continue;
            }
            if (before != 0 && property::may_divide(before, c)) may_end_before(i);
            before = c;
            line_.length += unit.advance;
            if (c == U' ')
                may_end_before(i + 1);
            else if (c != property::zero_width_space)
                line_.width = line_.length;
            if (wrap_ > 0 && line_.width > wrap_) divide();
        }
        line_.end = paragraph_.units.size();
        lines_.push_back(line_);
        return std::move(lines_);
    }

  private:
    void may_end_before(std::size_t letter) {
        shorter_ = line_;
        shorter_.end = letter;
    }
    /// Letters after the last place where the line may end begin another one. A word that is longer
    /// than the line stays in one piece.
    void divide() {
        if (shorter_.end <= line_.begin) return;
        lines_.push_back(shorter_);
        line_.begin = shorter_.end;
        line_.length -= shorter_.length;
        line_.width -= shorter_.length;
    }

    Paragraph& paragraph_;
    double wrap_;
    std::vector<Line> lines_;
    Line line_;     // the last one
    Line shorter_;  // it up to the last place where it may end
};

std::u32string first_paragraph(std::string_view utf8) {
    std::u32string text = property::decode_utf8(utf8.substr(0, 4 * Layout::most_letters));
    text.resize(std::min({text.size(), text.find(U'\n'), Layout::most_letters}));
    return text;
}

/// Calls `visit(letter, x)` for the letters of a line from left to right.
template <class Visit>
void walk(const Paragraph& paragraph, const Line& line, Visit visit) {
    if (!paragraph.order) {
        double x = 0;
        for (std::size_t i = line.begin; i < line.end; ++i) {
            visit(i, x);
            x += paragraph.units[i].advance;
        }
        return;
    }
    // Spaces at the end of a line are beyond its left end in a text from right to left.
    double x = paragraph.order->right_to_left() ? line.width - line.length : 0;
    for (const std::size_t i : paragraph.order->line(line.begin, line.end)) {
        visit(i, x);
        x += paragraph.units[i].advance;
    }
}

}  // namespace

Layout Layout::of(std::string_view utf8, const Family& family, Align align, double wrap) {
    if (family.empty() || utf8.empty()) return {};
    // A letter has at most four bytes; the last one may be cut, which decodes to U+FFFD.
    const std::u32string letters = property::decode_utf8(utf8.substr(0, 4 * most_letters));
    const std::u32string_view text = std::u32string_view(letters).substr(0, most_letters);
    Layout made;
    struct Beginning {
        std::size_t glyph;  // the first one of the line
        double width;
    };
    std::vector<Beginning> beginnings;
    // The letters are in the middle of the height of their line.
    double baseline = 0.5 * (line_height + family.main().ascent() - family.main().descent());
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(U'\n', begin), text.size());
        Paragraph paragraph = shaped(text.substr(begin, end - begin), family);
        for (const Line& line : Divider(paragraph, wrap).lines()) {
            beginnings.push_back({made.glyphs.size(), line.width});
            made.width = std::max(made.width, line.width);
            walk(paragraph, line, [&](std::size_t letter, double x) {
                const Unit& unit = paragraph.units[letter];
                for (std::size_t i = unit.first; i < unit.first + unit.count; ++i) {
                    PlacedGlyph glyph = paragraph.glyphs[i];
                    glyph.x += x;
                    glyph.y += baseline;
                    made.glyphs.push_back(glyph);
                }
            });
            baseline += line_height;
        }
        begin = end + 1;
    }
    made.height = line_height * static_cast<double>(beginnings.size());
    // How far lines move is known only now, with the width of the longest.
    const double share = align == Align::left ? 0 : align == Align::center ? 0.5 : 1;
    for (std::size_t i = 0; share > 0 && i < beginnings.size(); ++i) {
        const double left = share * (made.width - beginnings[i].width);
        const std::size_t end =
            i + 1 < beginnings.size() ? beginnings[i + 1].glyph : made.glyphs.size();
        for (std::size_t g = beginnings[i].glyph; g < end; ++g) made.glyphs[g].x += left;
    }
    return made;
}

bool Layout::right_to_left(std::string_view utf8) {
    return runs_right_to_left(first_paragraph(utf8));
}

std::vector<double> Layout::carets(std::string_view utf8, const Family& family) {
    const std::u32string text = first_paragraph(utf8);
    std::vector<double> places(text.size() + 1, 0);
    if (family.empty() || text.empty()) return places;
    Paragraph paragraph = shaped(text, family);
    const Line line = Divider(paragraph, 0).lines().front();
    walk(paragraph, line, [&](std::size_t letter, double x) {
        const bool reversed = paragraph.order && paragraph.order->level(letter) % 2 != 0;
        const double end = x + paragraph.units[letter].advance;
        places[letter] = reversed ? end : x;
        if (letter + 1 == text.size()) places.back() = reversed ? x : end;
    });
    return places;
}

}  // namespace fettle::visuals
