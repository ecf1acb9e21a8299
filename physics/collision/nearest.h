#pragma once

#include <collision/solid.h>

namespace fettle::physics::detail {

/// The points of two shapes that are nearest to each other, from the center of mass of a.
struct Nearest {
    float distance = 0.0f;  ///< 0 where they overlap: then the points are the same, inside both
    V2 on_a, on_b;
    V2 normal;  ///< from a to b; of no length where they overlap
};

/// `offset` is the center of mass of b minus that of a.
Nearest nearest_points(const Convex& a, const Convex& b, V2 offset);
Nearest nearest_points(const Solid& a, const Solid& b, V2 offset);

}  // namespace fettle::physics::detail
