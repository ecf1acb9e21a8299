#pragma once
// Text over a picture of any colors.

#include <string_view>

#include <fettle/property/painter.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Draws a text with a dark outline, so that it can be read on any background. Lengths are meters.
inline void draw_label(Painter& painter, const Vec2& position, std::string_view text, double height,
                       Color color) {
    const double pixel = 1 / painter.pixels_per_unit();
    const Color outline{0.04f, 0.05f, 0.07f, color.a};
    for (const Vec2 offset : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)})
        painter.text(position + pixel * offset, text, height, outline);
    painter.text(position, text, height, color);
}

}  // namespace fettle::property

FETTLE_PROPERTY_END
