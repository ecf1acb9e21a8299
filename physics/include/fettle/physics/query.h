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
        ~uint64_t{0};   ///< what it looks for: one of a shape's category bits must be in here
    int32_t group = 0;  ///< a shape of the same non-zero group: positive is seen, negative is not
    bool sensors = false;  ///< see sensors too
    /// Asked of each shape that the rest of the filter lets through; empty: all. It may read the
    /// world and ask other queries of it, but edit nothing in it: callbacks.h.
    std::function<bool(const Shape&)> accept = {};
};

struct RayHit {
    Shape shape;
    Vec2 point = Vec2::Zero();
    /// Of the surface, outward; against the motion where a cast shape overlaps it already.
    Vec2 normal = Vec2::Zero();
    float fraction = 0.0f;  ///< 0 at the start of the ray, 1 at its end
};

/// A place on a shape.
struct PointHit {
    Shape shape;
    Vec2 point = Vec2::Zero();   ///< on its surface; the point asked for where that is inside
    Vec2 normal = Vec2::Zero();  ///< of the surface, outward; of no length inside
    float distance = 0.0f;       ///< m; 0 inside
};

/// How far two shapes are from each other.
struct Separation {
    float distance = 0.0f;        ///< m; 0 where they overlap
    Vec2 point_a = Vec2::Zero();  ///< nearest to b, world, m
    Vec2 point_b = Vec2::Zero();  ///< nearest to a
    Vec2 normal = Vec2::Zero();   ///< from a to b; of no length where they overlap
};
/// Either may be of any world, or of no body: then its coordinates are those of the world.
Separation distance(const Shape& a, const Shape& b);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
