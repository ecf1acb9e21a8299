#include <layout/writing.h>

#include <fettle/property/line_breaks.h>

namespace fettle::interface {

namespace {

std::string cut(property::Media& media, const Lettering& lettering, const std::string& line,
                double width) {
    if (lettering.width(media, line) <= width) return line;
    static const std::string dots = "…";
    // The longest beginning that fits, found by halving.
    std::int64_t fits = 0, too_long = characters(line);
    while (fits + 1 < too_long) {
        const std::int64_t middle = (fits + too_long) / 2;
        const std::string tried = line.substr(0, byte_of(line, middle)) + dots;
        (lettering.width(media, tried) <= width ? fits : too_long) = middle;
    }
    return line.substr(0, byte_of(line, fits)) + dots;
}

/// A piece that is longer than the width is cut.
void wrap_line(property::Media& media, const Lettering& lettering, const std::string& line,
               double width, std::vector<std::string>& to) {
    std::string now;
    bool begun = false;
    for (const Piece& piece : pieces(line)) {
        const std::string longer = now + (piece.after_space ? " " : "") + piece.text;
        if (begun && lettering.width(media, longer) <= width) {
            now = longer;
            continue;
        }
        if (!now.empty()) to.push_back(now);
        now = cut(media, lettering, piece.text, width);
        begun = !now.empty();
    }
    to.push_back(now);
}

/// The lines from number `first` on, which are a paragraph, go on in its direction: a line alone
/// would have that of its own first letter. Unicode has invisible marks for this.
void keep_direction(property::Media& media, const std::string& paragraph, std::size_t first,
                    std::vector<std::string>& lines) {
    const bool right_to_left = media.right_to_left(paragraph);
    for (std::size_t i = first + 1; i < lines.size(); ++i)
        if (media.right_to_left(lines[i]) != right_to_left)
            lines[i].insert(0, right_to_left ? "\u200f" : "\u200e");
}

}  // namespace

Lettering Lettering::of(const Widget& widget) {
    return {.font = widget.style.font.empty() ? widget.arranged.look_of->font : widget.style.font,
            .size = widget.style.font_size.value_or(widget.arranged.look_of->font_size)};
}

double Lettering::width(property::Media& media, std::string_view text) const {
    return text.empty() ? 0 : media.text_size(text, style()).x;
}

std::vector<Piece> pieces(const std::string& line) {
    std::vector<Piece> all{{}};
    char32_t before = 0;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t next = property::next_code_point(line, at);
        const char32_t c = property::code_point_at(line, at);
        if (c == U' ')
            all.push_back({.text = {}, .after_space = true});
        else if (before != 0 && property::may_divide(before, c))
            all.push_back({.text = line.substr(at, next - at)});
        else
            all.back().text.append(line, at, next - at);
        before = c == U' ' ? 0 : c;
        at = next;
    }
    return all;
}

std::vector<std::string> fitted(property::Media& media, const Lettering& lettering,
                                const std::string& text, double width, bool wrap) {
    std::vector<std::string> lines;
    // More lines than any screen shows need not be measured.
    constexpr std::size_t most = 2000;
    std::size_t at = 0;
    while (at <= text.size() && !text.empty() && lines.size() < most) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (lettering.width(media, line) <= width) {
            lines.push_back(line);
        } else if (wrap) {
            const std::size_t first = lines.size();
            wrap_line(media, lettering, line, width, lines);
            keep_direction(media, line, first, lines);
        } else {
            lines.push_back(cut(media, lettering, line, width));
        }
        at = end + 1;
    }
    return lines;
}

}  // namespace fettle::interface
