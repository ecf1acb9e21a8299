#pragma once

#include <fettle/physics/definitions.h>
#include <geometry/vector.h>

#include <span>

namespace fettle::physics::detail {

/// The largest rounding that fits into the box. Sides and rounding are set one after the other, in
/// any order, so a rounding that is too large is stored and limited here instead of being refused.
float fitting_rounding(const Box& box);

/// Corners of a box without its rounding. The core always has an area, so it stays a polygon.
void box_corners(const Box& box, Vec2* out);

/// Returns `to`, or, if it is too near to `from`, a point beside `from`: the ends of a segment are
/// set one after the other, too, and a segment whose ends are equal gets a minimal length.
Vec2 kept_apart(Vec2 to, Vec2 from);

/// The outward normals of the edges of a counter-clockwise polygon; those of both sides of a
/// segment. A single vertex has none.
void write_normals(std::span<const Vec2> vertices, Vec2* normals);

}  // namespace fettle::physics::detail
