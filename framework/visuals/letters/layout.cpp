#include <letters/layout.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fettle/property/line_breaks.h>
#include <fettle/property/utf8.h>

namespace fettle::visuals {
namespace {

constexpr double tab_stop = 2, least_tab = 0.3;

/// Puts letters into lines.
class Setter {
  public:
    Setter(const Family& family, double wrap) : family_(family), wrap_(wrap) {
        lines_.push_back({});
    }

    void add(char32_t c) {
        if (c == U'\n') return new_line();
        if (c == U'\r') return;
        Line& line = lines_.back();
        if (c == U'\t') {
            line.end = tab_stop * std::ceil((line.end + least_tab) / tab_stop - 1e-6);
            before_ = 0;
            mark_break(line);
            return;
        }
        if (before_ != 0 && property::may_divide(before_, c)) mark_break(line);
        if (c == property::zero_width_space) {
            before_ = c;
            before_font_ = nullptr;
            return;
        }
        Font& font = family_.with(c);
        if (before_ != 0 && before_font_ == &font) line.end += font.kerning(before_, c);
        line.letters.push_back({&font, c, line.end, 0});
        line.end += font.advance(c);
        before_ = c;
        before_font_ = &font;
        if (c == U' ')
            mark_break(line);
        else
            line.width = line.end;
        if (wrap_ > 0 && line.width > wrap_) wrap();
    }

    Layout finish(Align align) const {
        Layout made;
        for (const Line& line : lines_) made.width = std::max(made.width, line.width);
        made.height = Layout::line_height * static_cast<double>(lines_.size());
        const double share = align == Align::left ? 0 : align == Align::center ? 0.5 : 1;
        // The letters are in the middle of the height of their line.
        const Font& font = family_.main();
        const double baseline = 0.5 * (Layout::line_height + font.ascent() - font.descent());
        double top = 0;
        for (const Line& line : lines_) {
            const double left = share * (made.width - line.width);
            for (PlacedLetter letter : line.letters) {
                letter.x += left;
                letter.y = top + baseline;
                made.letters.push_back(letter);
            }
            top += Layout::line_height;
        }
        return made;
    }

  private:
    struct Line {
        std::vector<PlacedLetter> letters;
        double end = 0;    // of the pen
        double width = 0;  // without spaces at the end
        // The last place where it may be divided.
        std::size_t break_letters = 0;
        double break_width = 0, break_end = 0;
        bool can_break = false;
    };
    void new_line() {
        lines_.emplace_back();
        before_ = 0;
    }
    static void mark_break(Line& line) {
        line.break_letters = line.letters.size();
        line.break_width = line.width;
        line.break_end = line.end;
        line.can_break = true;
    }
    /// Moves the letters after the last break to a new line. A word that is longer than the line
    /// stays in one piece.
    void wrap() {
        Line& line = lines_.back();
        if (!line.can_break) return;
        Line next;
        for (std::size_t i = line.break_letters; i < line.letters.size(); ++i) {
            next.letters.push_back(line.letters[i]);
            next.letters.back().x -= line.break_end;
        }
        next.end = line.end - line.break_end;
        next.width = line.width - line.break_end;
        line.letters.resize(line.break_letters);
        line.width = line.break_width;
        lines_.push_back(std::move(next));
    }

    const Family& family_;
    double wrap_;
    std::vector<Line> lines_;
    char32_t before_ = 0;
    const Font* before_font_ = nullptr;
};

}  // namespace

Layout Layout::of(std::string_view utf8, const Family& family, Align align, double wrap) {
    if (family.empty() || utf8.empty()) return {};
    Setter setter(family, wrap);
    // A letter has at most four bytes; the last one may be cut, which decodes to U+FFFD.
    std::size_t left = most_letters;
    for (const char32_t c : property::decode_utf8(utf8.substr(0, 4 * most_letters))) {
        if (left-- == 0) break;
        setter.add(c);
    }
    return setter.finish(align);
}

}  // namespace fettle::visuals
