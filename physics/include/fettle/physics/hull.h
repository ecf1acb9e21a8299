#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <span>
#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Whether points have a convex hull.
enum class HullStatus : uint8_t {
    ok,              ///< they have
    too_few_points,  ///< fewer than three distinct points
    collinear,       ///< all on one line (within 1e-5 of their extent)
    not_finite       ///< NaN or infinity among the coordinates
};

/// The message for a user, e.g. "all vertices lie on one line".
const char* describe(HullStatus status);

/// Convex hull, counter-clockwise, starting at the lowest of the leftmost points. The input may be
/// in any order; duplicates, points inside and points on an edge are dropped. `hull` is written
/// only if the status is `ok`.
HullStatus convex_hull(std::span<const Vec2> points, std::vector<Vec2>& hull);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
