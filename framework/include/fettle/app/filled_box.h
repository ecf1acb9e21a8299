#pragma once
// A box of one color, as layers draw it.

#include <cstdint>

#include <fettle/app/export.h>
#include <fettle/app/surface.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// Draws a box of one color on the surface. `x`, `y`, `w`, `h`: px, from the upper left corner.
inline void fill(Surface& surface, float x, float y, float w, float h, SurfaceColor c) {
    const SurfaceVertex corners[] = {{x, y, 0, 0, c.r, c.g, c.b, c.a},
                                     {x + w, y, 0, 0, c.r, c.g, c.b, c.a},
                                     {x + w, y + h, 0, 0, c.r, c.g, c.b, c.a},
                                     {x, y + h, 0, 0, c.r, c.g, c.b, c.a}};
    constexpr std::uint16_t order[] = {0, 1, 2, 0, 2, 3};
    surface.triangles(corners, order, 0, {0, 0, surface.width(), surface.height()});
}

}  // namespace fettle::app

FETTLE_APP_END
