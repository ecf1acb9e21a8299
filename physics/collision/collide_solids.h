#pragma once

#include <collision/solid.h>

namespace fettle::physics::detail {

/// Like `collide` for two convex shapes, for shapes of any kind but the border. `had_contact`: the
/// shapes were in contact already, which matters at the back of a one-sided segment.
void collide(const Solid& a, const Solid& b, Vec2 offset, float margin, bool had_contact,
             Manifold& manifold);

/// Contact points of a two-sided segment and a shape that is on one side of it, as `collide`; the
/// normal points away from the segment. `side`: the normal of an earlier contact of the two. The
/// shape is pushed to this side until it is behind the segment with all of its points.
void collide_on_side(const Solid& segment, const Solid& other, Vec2 side, Vec2 offset, float margin,
                     Manifold& manifold);

/// Converts the manifold of b and a into that of a and b.
void swap_shapes(Manifold& manifold);

}  // namespace fettle::physics::detail
