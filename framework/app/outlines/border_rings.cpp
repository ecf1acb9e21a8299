#include <outlines/border_rings.h>

#include <algorithm>

namespace fettle::app {

using property::Paint;

sf::Color native(property::Color color, float opacity) {
    const auto channel = [](float value) {
        // Rounds to the nearest: the value is not negative. std::lround is a call of the library.
        // NOLINTNEXTLINE(bugprone-incorrect-roundings)
        return static_cast<std::uint8_t>(255 * std::clamp(value, 0.0f, 1.0f) + 0.5f);
    };
    return {channel(color.r), channel(color.g), channel(color.b), channel(color.a * opacity)};
}

bool bordered(const Paint& paint) {
    const bool drawn = paint.border.a > 0 && paint.border_width > 0;
    return drawn && !(paint.border == paint.fill && opaque(native(paint.fill)));
}

BorderRings BorderRings::inside(const Paint& paint) {
    BorderRings rim;
    rim.fill = native(paint.fill);
    if (!bordered(paint)) {
        if (opaque(rim.fill)) {
            rim.add_halo(rim.fill);
            rim.add(0, rim.fill);
            rim.add(0.5f, rim.fill);  // covers the steps at the edge of the inside
            rim.depth = 0.25f;
        } else {
            rim.add(-0.5f, clear(rim.fill));
            rim.add(0.5f, rim.fill);
            rim.depth = 0.5f;
        }
        return rim;
    }
    // A border thinner than a pixel is drawn one pixel wide and paler.
    const float width = std::max(paint.border_width, 1.0f);
    const sf::Color border = native(paint.border, std::min(paint.border_width, 1.0f));
    // An opaque border covers the steps of the inside and overlaps of its own sides.
    if (opaque(border)) {
        rim.add_halo(border);
        rim.add(0, border);
        rim.add(width - halo_correction - 0.5f, border);
        rim.add(width - halo_correction + 0.5f, clear(border));
        rim.depth = 0.5f * (width - halo_correction);
        rim.overlap = width;
    } else {
        rim.add(-0.5f, clear(border));
        rim.add(0.5f, border);
        if (width > 1) rim.add(width - 0.5f, border);
        rim.add(width + 0.5f, rim.fill.a > 0 ? rim.fill : clear(border));
        rim.depth = width + 0.5f;
    }
    return rim;
}

BorderRings BorderRings::on_both_sides(const Paint& paint) {
    BorderRings rim;
    rim.fill = native(paint.fill);
    const bool seen = bordered(paint);
    // Without a visible border, a line of the fill color smooths the steps of the inside.
    if (!seen && !opaque(rim.fill)) return rim;
    const float width = seen ? std::max(paint.border_width, 1.0f) : 1.0f;
    const sf::Color line =
        seen ? native(paint.border, std::min(paint.border_width, 1.0f)) : rim.fill;
    const float half = 0.5f * width, fade = seen ? 0.5f : 0.25f;
    rim.add(-half - fade, clear(line));
    rim.add(-half + fade, line);
    rim.add(half - fade, line);
    rim.add(half + fade, clear(line));
    return rim;
}

}  // namespace fettle::app
