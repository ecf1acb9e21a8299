#pragma once
// How widgets share the free length of a row or a column.

#include <string>

#include <widgets/widget.h>

namespace fettle::interface {

/// `axis`: 0 for the width, 1 for the height.
inline bool fills(const Widget& widget, int axis) {
    return widget.placing.fill == "both" || widget.placing.fill == (axis == 0 ? "width" : "height");
}

/// The share of the free length that the widget gets; 0: none.
inline double growth(const Widget& widget, int axis) {
    return widget.placing.grow > 0 ? widget.placing.grow : fills(widget, axis) ? 1 : 0;
}

/// The share of the free length that lies before a widget with this `align` or `justify`.
inline double share_before(const std::string& where) {
    return where == "center" ? 0.5 : where == "end" ? 1 : 0;
}

/// Whether it may be narrower than its text where there is little room.
inline bool may_shrink(const Widget& widget) {
    const bool text =
        widget.kind == Kind::button || widget.kind == Kind::toggle || widget.kind == Kind::label;
    return text && !(widget.placing.size.x > 0);
}

}  // namespace fettle::interface
