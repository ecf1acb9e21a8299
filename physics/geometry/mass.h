#pragma once

#include <geometry/vector.h>

#include <span>

namespace fettle::physics::detail {

/// Of a region of density one: area (m²), centroid, and polar second moment about the centroid
/// (m⁴).
struct AreaMoments {
    double area = 0.0;
    double center_x = 0.0;
    double center_y = 0.0;
    double moment = 0.0;
};

/// Moments of a convex counter-clockwise polygon grown by `radius` all round: one vertex and a
/// radius is a circle, two are a capsule. Exact: polygon + a rectangle on each edge + a sector at
/// each corner.
AreaMoments moments_of(std::span<const V2> vertices, float radius);

}  // namespace fettle::physics::detail
