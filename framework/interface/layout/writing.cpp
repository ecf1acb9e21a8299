#include <layout/writing.h>

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

/// A line divided at spaces. A word that is longer than the width is cut.
void wrap_line(property::Media& media, const Lettering& lettering, const std::string& line,
               double width, std::vector<std::string>& to) {
    std::string now;
    std::size_t at = 0;
    do {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        const std::string word = line.substr(at, end - at);
        const std::string longer = now.empty() ? word : now + " " + word;
        if (!now.empty() && lettering.width(media, longer) > width) {
            to.push_back(now);
            now = cut(media, lettering, word, width);
        } else {
            now = now.empty() ? cut(media, lettering, word, width) : longer;
        }
        at = end + 1;
    } while (at <= line.size());
    to.push_back(now);
}

}  // namespace

Lettering Lettering::of(const Widget& widget) {
    return {.font = widget.style.font.empty() ? widget.arranged.look_of->font : widget.style.font,
            .size = widget.style.font_size.value_or(widget.arranged.look_of->font_size)};
}

double Lettering::width(property::Media& media, std::string_view text) const {
    return text.empty() ? 0 : media.text_size(text, style()).x;
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
        if (lettering.width(media, line) <= width)
            lines.push_back(line);
        else if (wrap)
            wrap_line(media, lettering, line, width, lines);
        else
            lines.push_back(cut(media, lettering, line, width));
        at = end + 1;
    }
    return lines;
}

}  // namespace fettle::interface
