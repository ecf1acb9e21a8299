#pragma once
// The dashes of a line.

#include <optional>
#include <span>
#include <vector>

#include <fettle/property/thick_line.h>

namespace fettle::visuals {

/// The dashes in the visible area of the painter. `length`: of each dash with its ends, and of the
/// gaps. Nothing if they are too short, or too many, to be told apart.
std::optional<std::vector<property::LinePiece>> dashes(const property::Painter& painter,
                                                       std::span<const property::Vec2> points,
                                                       double length, double width);

}  // namespace fettle::visuals
