#pragma once
// Text that fits a width.

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/media.h>
#include <fettle/property/utf8.h>

#include <widgets/widget.h>

namespace fettle::interface {

/// The font and the size that a widget's text has.
struct Lettering {
    std::string font;
    double size = 16;  // px of the layout
    static Lettering of(const Widget& widget);
    property::TextStyle style() const { return {.font = font, .size = size}; }
    double line_height() const { return 1.35 * size; }
    double width(property::Media& media, std::string_view text) const;
    /// As Media::carets.
    std::vector<double> carets(property::Media& media, std::string_view text) const {
        return media.carets(text, style());
    }
};

/// The place of the caret before character number `n`; that at the end if there are fewer.
inline double caret_at(const std::vector<double>& carets, std::int64_t n) {
    return carets[std::min(static_cast<std::size_t>(std::max<std::int64_t>(n, 0)),
                           carets.size() - 1)];
}

/// A part of a line inside of which it is not divided.
struct Piece {
    std::string text{};
    bool after_space = false;  // a space is before it, which vanishes where the line is divided
};
/// The parts between the spaces, and between characters where property::may_divide allows it.
std::vector<Piece> pieces(const std::string& line);

/// The lines of `text`. Lines longer than `width` are divided (`wrap`) or end with "…".
std::vector<std::string> fitted(property::Media& media, const Lettering& lettering,
                                const std::string& text, double width, bool wrap);

/// The place of the `n`th character of a text in UTF-8, in bytes; its end if there are fewer.
inline std::size_t byte_of(std::string_view text, std::int64_t n) {
    return property::code_point_offset(text,
                                       static_cast<std::size_t>(std::max<std::int64_t>(n, 0)));
}
/// Number of characters of a text in UTF-8.
inline std::int64_t characters(std::string_view text) {
    return static_cast<std::int64_t>(property::code_point_count(text));
}

}  // namespace fettle::interface
