#pragma once
// Maps of the plane: moves, turns, scales, and their combinations.

#include <cmath>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Maps a point p to p.x * x + p.y * y + origin.
struct Transform {
    Vec2 x{1, 0};       ///< what is added for each unit of x
    Vec2 y{0, 1};       ///< what is added for each unit of y
    Vec2 origin{0, 0};  ///< where (0, 0) comes to

    /// Adds a vector.
    static Transform moved(const Vec2& by) { return {.origin = by}; }
    /// `angle`: radians, counter-clockwise.
    static Transform turned(double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        return {Vec2(c, s), Vec2(-s, c), Vec2(0, 0)};
    }
    /// Multiplies both coordinates.
    static Transform scaled(const Vec2& by) { return {Vec2(by.x, 0), Vec2(0, by.y)}; }
    /// Turned first, then moved.
    static Transform placed(const Vec2& position, double angle) {
        Transform made = turned(angle);
        made.origin = position;
        return made;
    }

    /// The point to which a point comes.
    Vec2 operator()(const Vec2& p) const { return direction(p) + origin; }
    /// A difference of two points: the origin has no effect.
    Vec2 direction(const Vec2& d) const { return d.x * x + d.y * y; }
    /// First `inner`, then this one.
    Transform operator*(const Transform& inner) const {
        return {direction(inner.x), direction(inner.y), (*this)(inner.origin)};
    }
    /// The area of a mapped square of one by one; negative if the map mirrors.
    double area() const { return x.x * y.y - x.y * y.x; }
    /// The factor of lengths; for different factors in two directions, their geometric mean.
    double scale() const { return std::sqrt(std::abs(area())); }
    bool is_identity() const {
        return x == Vec2(1, 0) && y == Vec2(0, 1) && origin == Vec2(0, 0);
    }  ///< whether all points stay
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
