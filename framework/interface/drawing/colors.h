#pragma once
// Colors that follow from others.

#include <fettle/property/value.h>

namespace fettle::interface {

/// `share`: 0 is `a`, 1 is `b`.
inline property::Color mixed(property::Color a, property::Color b, double share) {
    const auto s = static_cast<float>(share);
    return {a.r + (b.r - a.r) * s, a.g + (b.g - a.g) * s, a.b + (b.b - a.b) * s,
            a.a + (b.a - a.a) * s};
}

/// Lighter while it has the mouse or the keyboard, darker while it is held.
inline property::Color touched(property::Color color, double hover, double press) {
    const property::Color light{1, 1, 1, color.a}, dark{0, 0, 0, color.a};
    return mixed(mixed(color, light, 0.10 * hover), dark, 0.22 * press);
}

/// Black or white, whichever can be read better on `background`.
inline property::Color readable_on(property::Color background) {
    const float light = 0.299f * background.r + 0.587f * background.g + 0.114f * background.b;
    return light > 0.6f ? property::Color{0.05f, 0.06f, 0.09f, 1} : property::Color{1, 1, 1, 1};
}

}  // namespace fettle::interface
