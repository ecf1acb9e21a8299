#pragma once

#include <fettle/physics/types.h>

#include <cmath>

// Functions of vectors, rotations and boxes in the form of equations: `dot(a, b)` is `a.dot(b)`.

namespace fettle::physics::detail {

inline float dot(Vec2 a, Vec2 b) {
    return a.dot(b);
}
inline float cross(Vec2 a, Vec2 b) {
    return a.cross(b);
}
/// ω × r in the plane.
inline Vec2 cross(float w, Vec2 r) {
    return {-w * r.y, w * r.x};
}
/// A quarter turn clockwise: the outward normal of a counter-clockwise edge, the tangent of a
/// normal.
inline Vec2 right_perp(Vec2 a) {
    return {a.y, -a.x};
}
inline float length_squared(Vec2 a) {
    return a.length_squared();
}
inline float length(Vec2 a) {
    return a.length();
}
/// The unit vector; the zero vector has no direction and is returned unchanged.
inline Vec2 normalized(Vec2 a) {
    const float l = length(a);
    return l > 1e-20f ? (1.0f / l) * a : Vec2{};
}
inline float min(float a, float b) {
    return a < b ? a : b;
}
inline float max(float a, float b) {
    return a > b ? a : b;
}
inline float clamp(float v, float low, float high) {
    return v < low ? low : (v > high ? high : v);
}

/// The fraction of a segment at which it is nearest to a point. `along` leads from its start to its
/// end, `to_point` from its start to the point.
inline float nearest_fraction(Vec2 along, Vec2 to_point) {
    const float whole = length_squared(along);
    return whole > 0.0f ? clamp(dot(to_point, along) / whole, 0.0f, 1.0f) : 0.0f;
}

/// Limits infinities, and replaces NaN by zero: the state stays finite for any forces and masses.
inline float bounded(float v, float limit) {
    if (v > limit) return limit;
    if (v < -limit) return -limit;
    return v == v ? v : 0.0f;
}
inline Vec2 bounded(Vec2 v, float limit) {
    return {bounded(v.x, limit), bounded(v.y, limit)};
}

/// A rotation as cosine and sine.
struct Rotation {
    float c = 1.0f;
    float s = 0.0f;
};
inline Vec2 rotate(Rotation q, Vec2 v) {
    return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
}
inline Vec2 unrotate(Rotation q, Vec2 v) {
    return {q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x};
}

/// An axis-aligned box of plain floats.
struct Box4 {
    Vec2 low;
    Vec2 high;
};
/// A box that overlaps no box.
inline constexpr Box4 no_box = {{1e38f, 1e38f}, {-1e38f, -1e38f}};

inline bool overlap(const Box4& a, const Box4& b) {
    // Bitwise and, so that the four comparisons need no branches.
    return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) &
           (b.low.y <= a.high.y);
}
inline bool contains(const Box4& outer, const Box4& inner) {
    return (outer.low.x <= inner.low.x) & (outer.low.y <= inner.low.y) &
           (inner.high.x <= outer.high.x) & (inner.high.y <= outer.high.y);
}
inline Box4 unite(const Box4& a, const Box4& b) {
    return {{min(a.low.x, b.low.x), min(a.low.y, b.low.y)},
            {max(a.high.x, b.high.x), max(a.high.y, b.high.y)}};
}
inline Box4 grow(const Box4& a, float margin) {
    return {{a.low.x - margin, a.low.y - margin}, {a.high.x + margin, a.high.y + margin}};
}
inline float perimeter(const Box4& a) {
    return 2.0f * ((a.high.x - a.low.x) + (a.high.y - a.low.y));
}

// Points of the world, which have double precision with FETTLE_PHYSICS_DOUBLE. Boxes have single
// precision always. They are rounded outwards, so that no overlap is missed.

#ifdef FETTLE_PHYSICS_DOUBLE
inline constexpr bool double_positions = true;
/// n·p.
inline double dot(Vec2 n, const Position& p) {
    return double{n.x} * p.x + double{n.y} * p.y;
}
inline double bounded(double v, float limit) {
    if (v > double{limit}) return double{limit};
    if (v < -double{limit}) return -double{limit};
    return v == v ? v : 0.0;
}
inline Position bounded(const Position& p, float limit) {
    return {bounded(p.x, limit), bounded(p.y, limit)};
}
/// The greatest float that is not above `v`.
inline float rounded_down(double v) {
    const auto nearest = float(v);
    return double{nearest} > v ? std::nextafter(nearest, -INFINITY) : nearest;
}
/// The smallest float that is not below `v`.
inline float rounded_up(double v) {
    return -rounded_down(-v);
}
inline Vec2 rounded_down(const Position& p) {
    return {rounded_down(p.x), rounded_down(p.y)};
}
inline Vec2 rounded_up(const Position& p) {
    return {rounded_up(p.x), rounded_up(p.y)};
}
inline Position middle(const Position& a, const Position& b) {
    return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
}
/// An upper bound of the error when the coordinates are rounded to single precision.
inline float rounding_of(const Position& p) {
    return std::numeric_limits<float>::epsilon() * float(std::fmax(std::fabs(p.x), std::fabs(p.y)));
}
#else
inline constexpr bool double_positions = false;
inline Vec2 middle(Vec2 a, Vec2 b) {
    return 0.5f * (a + b);
}
constexpr float rounding_of(Vec2) {
    return 0.0f;
}
inline Vec2 rounded_down(Vec2 p) {
    return p;
}
inline Vec2 rounded_up(Vec2 p) {
    return p;
}
#endif

/// The box from one corner to the other.
inline Box4 box_of(const Position& low, const Position& high) {
    return {rounded_down(low), rounded_up(high)};
}
inline Box4 box_of(const Aabb& box) {
    return box_of(box.min, box.max);
}
inline bool overlap(const Aabb& a, const Aabb& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}
/// Enlarges a box so that it contains another one.
inline void add_box(Aabb& all, const Aabb& other) {
    all = {all.min.min(other.min), all.max.max(other.max)};
}
/// A box around a point, given relative to the point.
inline Box4 box_around(const Position& point, const Box4& relative) {
    return box_of(point + relative.low, point + relative.high);
}

}  // namespace fettle::physics::detail
