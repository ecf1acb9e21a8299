#pragma once
// The dashes of a line.

#include <optional>
#include <span>
#include <vector>

#include <fettle/property/painter.h>

namespace fettle::visuals {

/// A straight piece of a line, with a half circle of this radius at either end.
struct Piece {
    property::Vec2 from, to;
    double rounding = 0;
};

/// The dashes in the visible area of the painter. `length`: of each dash with its ends, and of the
/// gaps. Nothing if they are too short, or too many, to be told apart.
std::optional<std::vector<Piece>> dashes(const property::Painter& painter,
                                         std::span<const property::Vec2> points, double length,
                                         double width);

}  // namespace fettle::visuals
