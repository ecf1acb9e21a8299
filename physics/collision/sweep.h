#pragma once

#include <collision/solid.h>

namespace fettle::physics::detail {

/// Distance between two shapes, 0 where they overlap; `offset` is the center of mass of b minus
/// that of a.
float distance(const Convex& a, const Convex& b, V2 offset);
float distance(const Solid& a, const Solid& b, V2 offset);

/// A moving shape: where its center of mass starts, how far it goes and turns. `end` is the shape
/// as it is rotated at the end of the motion.
struct Sweep {
    Solid end;
    V2 start;
    V2 shift;
    float turn = 0.0f;
    float extent = 0.0f;  ///< farthest point from the center of mass
};

/// The fraction of the motion, 0 … 1, up to which the shape keeps at least `gap` from `obstacle`
/// (center of mass at `center`), by conservative advancement. 1 if it never gets that near; 0 if it
/// starts nearer.
float time_of_impact(const Sweep& sweep, const Solid& obstacle, V2 center, float gap);

}  // namespace fettle::physics::detail
