#pragma once
// Draws a layout with a painter.

#include <fettle/property/painter.h>

#include <letters/layout.h>

namespace fettle::visuals {

/// `size`: of the font, in the units of the painter. `corner`: the top left corner of the layout,
/// with y down also where the painter has y up. `outline`: draws only the line around the letters,
/// so wide to each side of their rims, as a part of the size.
void draw_letters(property::Painter& painter, const Layout& layout, double size,
                  const property::Vec2& corner, property::Color color, double outline = 0);

}  // namespace fettle::visuals
