#pragma once

#include <geometry/vector.h>

#include <span>

namespace fettle::physics::detail {

/// Moments of a region with density 1: area (m²), centroid, and polar second moment about the
/// centroid (m⁴).
struct AreaMoments {
    double area = 0.0;
    double center_x = 0.0;
    double center_y = 0.0;
    double moment = 0.0;
};

/// Moments of a convex counter-clockwise polygon that is enlarged by `radius` on all sides. One
/// vertex with a radius is a circle, two are a capsule. The result is exact: polygon + a rectangle
/// on each edge + a sector at each corner.
AreaMoments moments_of(std::span<const Vec2> vertices, float radius);

}  // namespace fettle::physics::detail
