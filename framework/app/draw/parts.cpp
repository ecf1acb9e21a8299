// Parts of one whole: they are collected, and drawn together with one border.

#include <draw/canvas.h>
#include <outlines/rim.h>

namespace fettle::app {

using property::Paint;

/// Returns whether a figure with this paint is to be collected. Draws the collected parts first if
/// they belong to another whole or have another paint.
bool Canvas::is_collected(const Paint& paint) {
    const bool same = joined_whole_ == whole_ && joined_paint_.fill == paint.fill &&
                      joined_paint_.border == paint.border &&
                      joined_paint_.border_width == paint.border_width;
    if (!same) draw_collected();
    if (whole_ == 0) return false;
    // An opaque color without a border shows no seams, so each part is drawn by itself.
    if (!bordered(paint) && opaque(native(paint.fill))) return false;
    joined_whole_ = whole_;
    joined_paint_ = paint;
    return true;
}

void Canvas::collect() {
    rings_.clear();
    outline_.ring(0, rings_);
    joined_.add(rings_);
}

void Canvas::draw_collected() {
    if (joined_.size() == 0) return;
    constexpr float too_small = 12;  // px; in a smaller whole the seams are not visible
    if (joined_.size() > 1 && joined_.extent() > too_small && joined_.find_seams())
        draw_joined(Rim::inside(joined_paint_));
    else
        draw_parts();
    joined_.clear();
    joined_whole_ = 0;
}

void Canvas::draw_joined(const Rim& rim) {
    if (rim.fill.a > 0) {
        area_.clear();
        for (std::size_t i = 0; i < joined_.size(); ++i) {
            rings_.clear();
            joined_.contour(i, rim.depth, rings_);
            area_.add(rings_);
        }
        draw_inside(Area::Rule::forward, rim.fill);
    }
    for (const Run& run : joined_.border(rim.overlap)) draw_rim(rim, run.bends, run.closed);
}

void Canvas::draw_parts() {
    edge_ = Edge::touching;
    for (std::size_t i = 0; i < joined_.size(); ++i) {
        const auto corners = joined_.part(i);
        if (is_convex(corners)) {
            outline_.set(corners, 0);
            draw_outline(joined_paint_);
        } else {
            outline_.set_any(corners);
            draw_any_outline(joined_paint_);
        }
    }
}

}  // namespace fettle::app
