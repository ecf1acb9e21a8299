#pragma once
// How widgets share the free length of a row or a column.

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

}  // namespace fettle::interface
