// Parts of one whole: they are collected, and drawn together with one border.

#include <draw/canvas.h>
#include <outlines/border_rings.h>

namespace fettle::app {

using property::Paint;

/// Returns whether a figure with this paint is to be collected. Draws the collected parts first if
/// they belong to another whole or have another paint.
bool Canvas::is_collected(const Paint& paint) {
    const bool same = collected_.whole == whole_ && collected_.paint.fill == paint.fill &&
                      collected_.paint.border == paint.border &&
                      collected_.paint.border_width == paint.border_width;
    if (!same) draw_collected();
    if (whole_ == 0) return false;
    // An opaque color without a border shows no seams, so each part is drawn by itself.
    if (!bordered(paint) && opaque(native(paint.fill))) return false;
    collected_.whole = whole_;
    collected_.paint = paint;
    return true;
}

void Canvas::collect() {
    scratch_.rings.clear();
    outline_.ring(0, scratch_.rings);
    collected_.parts.add(scratch_.rings);
}

void Canvas::draw_collected() {
    draw_polyline();
    if (collected_.parts.size() == 0) return;
    constexpr float too_small = 12;  // px; in a smaller whole the seams are not visible
    if (collected_.parts.size() > 1 && collected_.parts.extent() > too_small &&
        collected_.parts.find_seams())
        draw_joined(BorderRings::inside(collected_.paint));
    else
        draw_parts();
    collected_.parts.clear();
    collected_.whole = 0;
}

void Canvas::draw_joined(const BorderRings& rim) {
    if (rim.fill.a > 0) {
        scratch_.area.clear();
        for (std::size_t i = 0; i < collected_.parts.size(); ++i) {
            scratch_.rings.clear();
            collected_.parts.contour(i, rim.depth, scratch_.rings);
            scratch_.area.add(scratch_.rings);
        }
        draw_inside(Area::Rule::forward, rim.fill);
    }
    for (const Run& run : collected_.parts.border(rim.overlap))
        draw_border(rim, run.bends, run.closed);
}

void Canvas::draw_parts() {
    edge_ = Edge::touching;
    for (std::size_t i = 0; i < collected_.parts.size(); ++i) {
        const auto corners = collected_.parts.part(i);
        if (is_convex(corners)) {
            outline_.set(corners, 0);
            draw_outline(collected_.paint);
        } else {
            outline_.set_any(corners);
            draw_any_outline(collected_.paint);
        }
    }
}

}  // namespace fettle::app
