#pragma once

#include <collision/solid.h>

namespace fettle::physics::detail {

/// Distance from a point to the surface of a shape, negative inside; `p` relative to the shape's
/// center of mass.
float signed_distance(const Convex& shape, V2 p);
float signed_distance(const Solid& shape, V2 p);

/// How far a shape reaches along a unit vector from the center of mass of its body.
float reach(const Solid& shape, V2 direction);

struct Probe {
    float fraction = 2.0f;  ///< more than 1: missed
    V2 normal;
};

/// Where the segment from `p` along `d` enters the shape. A start inside is a miss.
Probe cast_segment(const Convex& shape, V2 p, V2 d);
/// A piece is entered through its part of the outline only, a segment of a chain from its front.
Probe cast_segment(const Solid& shape, V2 p, V2 d);

}  // namespace fettle::physics::detail
