#include <letters/writing.h>

#include <algorithm>
#include <cmath>

namespace fettle::visuals {

using property::Vec2;

void draw_letters(property::Painter& painter, const Layout& layout, double size, const Vec2& corner,
                  property::Color color, double outline) {
    constexpr double least = 1;  // px; smaller letters cannot be seen
    const double pixels = size * painter.pixels_per_unit();
    if (!(pixels >= least) || !std::isfinite(pixels)) return;
    const double down = painter.on_screen() ? 1 : -1;
    for (const PlacedGlyph& each : layout.glyphs) {
        const Letter* const letter = each.font->letter(each.glyph, pixels, outline);
        if (letter == nullptr) continue;
        const auto width = static_cast<double>(letter->picture.width());
        const auto height = static_cast<double>(letter->picture.height());
        const double pixel = size / letter->size;  // of the letter
        const double left = corner.x + size * each.x + pixel * letter->left;
        const double top = corner.y + size * each.y + pixel * letter->top;
        const double begin = down * top, end = down * (top + pixel * height);
        const property::Color tint = letter->colored ? property::Color{1, 1, 1, color.a} : color;
        painter.picture(letter->picture, {0, 0, width, height}, {left, std::min(begin, end)},
                        {left + pixel * width, std::max(begin, end)}, tint, true);
    }
}

}  // namespace fettle::visuals
