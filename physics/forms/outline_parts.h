#pragma once

#include <geometry/mass.h>
#include <geometry/vector.h>

#include <cstdint>
#include <span>
#include <vector>

namespace fettle::physics::detail {

/// The convex parts of an outline in sequence. The values of a part are its vertices and, behind
/// them, two unit normals for each vertex: those of the edges of the whole outline before and after
/// it, zero at a free end.
struct OutlineParts {
    std::vector<Vec2> values;
    std::vector<uint32_t> counts;  ///< number of vertices of each part
};

/// The segments of a chain.
OutlineParts chain_parts(std::span<const Vec2> points, bool closed);
/// Convex polygons that together are a simple polygon of any orientation.
OutlineParts concave_parts(std::span<const Vec2> points);

// Moments of the whole outline. They are exact and do not depend on the division into parts.
AreaMoments chain_moments(std::span<const Vec2> points);
AreaMoments concave_moments(std::span<const Vec2> outline);

}  // namespace fettle::physics::detail
