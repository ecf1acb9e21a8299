#pragma once

#include <fettle/physics/types.h>
#include <geometry/vector.h>

namespace fettle::physics::detail {

/// A side of the bounds of a world, solid where normal·p <= depth.
struct BorderPlane {
    Vec2 normal;
    WorldCoordinate depth = 0;
};

inline BorderPlane border_plane(const Aabb& bounds, uint32_t side) {
    if (side == 0) return {{1.0f, 0.0f}, bounds.min.x};
    if (side == 1) return {{-1.0f, 0.0f}, -bounds.max.x};
    if (side == 2) return {{0.0f, 1.0f}, bounds.min.y};
    return {{0.0f, -1.0f}, -bounds.max.y};
}

}  // namespace fettle::physics::detail
