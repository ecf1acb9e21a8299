#pragma once

#include <collision/solid.h>
#include <geometry/motion.h>

// Nearest points, distances, rays and sweeps. For two shapes, `offset` is the center of mass of b
// minus that of a.

namespace fettle::physics::detail {

Nearest nearest_points(const Convex& a, const Convex& b, Vec2 offset);
Nearest nearest_points(const Solid& a, const Solid& b, Vec2 offset);

/// The point of the edge from a to b that is nearest to p.
inline Vec2 nearest_on_edge(Vec2 a, Vec2 b, Vec2 p) {
    return a + nearest_fraction(b - a, p - a) * (b - a);
}
inline float squared_distance_to_edge(Vec2 a, Vec2 b, Vec2 p) {
    return length_squared(p - nearest_on_edge(a, b, p));
}

/// 0 when they overlap.
float distance(const Convex& a, const Convex& b, Vec2 offset);

/// A moving shape.
struct Sweep {
    Solid shape;
    Motion motion;
    float extent = 0.0f;  ///< farthest point from the center of mass
};

/// The time, from `start` to 1, until which two shapes keep at least the distance `gap`, by
/// conservative advancement. 1 if they never come nearer, `start` if they are nearer then.
float time_of_impact(const Sweep& a, const Sweep& b, float gap, float start = 0.0f);
/// The unit vector from `a` to `b` at time `t`; zero if they overlap.
Vec2 direction_between(const Sweep& a, const Sweep& b, float t);
/// The time of impact with a half-plane that is solid where normal·p <= depth.
float time_of_impact(const Sweep& sweep, Vec2 normal, WorldCoordinate depth, float gap,
                     float start = 0.0f);

/// Distance from a point to the surface of a shape, negative inside; `p` relative to the shape's
/// center of mass.
float signed_distance(const Convex& shape, Vec2 p);
float signed_distance(const Solid& shape, Vec2 p);

/// Distance of the farthest point of a shape along a unit vector from the center of mass of its
/// body.
float reach(const Solid& shape, Vec2 direction);
/// The box around a shape, relative to the center of mass of its body.
Box4 box_of(const Solid& shape);

struct Probe {
    float fraction = 2.0f;  ///< more than 1: missed
    Vec2 normal;
};

/// The point where the segment from `p` along `d` enters the shape. Starting inside is a miss.
Probe cast_segment(const Convex& shape, Vec2 p, Vec2 d);
/// A piece is entered only through its part of the outline, a segment of a chain only from its
/// front.
Probe cast_segment(const Solid& shape, Vec2 p, Vec2 d);

/// A part of a shape: its area (m²), and its centroid relative to the center of mass of the body.
struct AreaPart {
    double area = 0.0;
    Vec2 centroid;
};

/// The part of a shape with normal·p < depth; p is relative to the center of mass of its body.
/// Exact also for circles, capsules and rounded polygons. `normal` is a unit vector.
AreaPart part_below(const Convex& shape, Vec2 normal, double depth);
AreaPart part_below(const Solid& shape, Vec2 normal, double depth);

}  // namespace fettle::physics::detail
