#pragma once

#include <collision/solid.h>

namespace fettle::physics::detail {

/// A part of a shape: its area (m²) and its centroid, from the center of mass of the body.
struct AreaPart {
    double area = 0.0;
    V2 centroid;
};

/// The part of a shape with normal·p < depth, p from the center of mass of its body. Exact for
/// circles, capsules and rounded polygons alike. `normal` is a unit vector.
AreaPart part_below(const Convex& shape, V2 normal, double depth);
AreaPart part_below(const Solid& shape, V2 normal, double depth);

}  // namespace fettle::physics::detail
