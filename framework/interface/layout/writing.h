#pragma once
// Text that fits a width.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/media.h>

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
};

/// The lines of `text`. Lines longer than `width` are divided at spaces (`wrap`) or end with "…".
std::vector<std::string> fitted(property::Media& media, const Lettering& lettering,
                                const std::string& text, double width, bool wrap);

/// The place of the `n`th character of a text in UTF-8, in bytes; its end if there are fewer.
std::size_t byte_of(std::string_view text, std::int64_t n);
/// Number of characters of a text in UTF-8.
std::int64_t characters(std::string_view text);

}  // namespace fettle::interface
