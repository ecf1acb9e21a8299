#pragma once

#include <collision/solid.h>

namespace fettle::physics::detail {

/// Like `collide` for two convex shapes, for shapes of any kind but the border. `held`: the shapes
/// were in contact already, which matters at the back of a one-sided segment.
void collide(const Solid& a, const Solid& b, Vec2 offset, float margin, bool held,
             Manifold& manifold);

}  // namespace fettle::physics::detail
