#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/shape.h>

#include <functional>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Which shapes a query sees.
struct QueryFilter {
    uint64_t category =
        ~uint64_t{0};  ///< what the query is: a shape's mask must accept one of these bits
    uint64_t mask =
        ~uint64_t{0};      ///< what it looks for: one of a shape's category bits must be in here
    bool sensors = false;  ///< see sensors too
    std::function<bool(const Shape&)> accept = {};  ///< empty: all
};

struct RayHit {
    Shape shape;
    Vec2 point = Vec2::Zero();
    Vec2 normal = Vec2::Zero();  ///< of the surface, outward
    float fraction = 0.0f;       ///< 0 at the start of the ray, 1 at its end
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
