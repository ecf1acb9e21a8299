#pragma once

#include <fettle/physics/export.h>
#include <fettle/vector/vector2.h>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// All numbers in the library are single precision and in SI units (m, m/s, N, ...), angles in
/// radians.
using Vec2 = Vector2<float>;

#ifdef FETTLE_PHYSICS_DOUBLE

/// A point of the world, m, in double precision. The difference of two points is a `Vec2`: it is
/// taken in double precision and then rounded, so it is precise wherever both points are. A `Vec2`
/// converts to a point by itself. The other direction is explicit, `Vec2(point)`, because it
/// rounds.
struct Position {
    double x = 0.0;  ///< to the right, m
    double y = 0.0;  ///< upwards, m

    constexpr Position() = default;  ///< the origin
    /// Any numbers; they are converted to double.
    template <Number X, Number Y>
    constexpr Position(X along_x, Y along_y)
        : x(static_cast<double>(along_x)), y(static_cast<double>(along_y)) {}
    /// The same point, without rounding.
    constexpr Position(const Vec2& point) : x(double{point.x}), y(double{point.y}) {}
    /// Rounds to single precision.
    explicit constexpr operator Vec2() const { return {x, y}; }

    /// Moves the point.
    constexpr Position& operator+=(const Vec2& by) { return *this = *this + by; }
    /// Moves the point back.
    constexpr Position& operator-=(const Vec2& by) { return *this = *this - by; }

    friend constexpr bool operator==(const Position&, const Position&) = default;
    /// The point moved by a vector.
    friend constexpr Position operator+(const Position& p, const Vec2& by) {
        return {p.x + double{by.x}, p.y + double{by.y}};
    }
    /// The point moved back by a vector.
    friend constexpr Position operator-(const Position& p, const Vec2& by) {
        return {p.x - double{by.x}, p.y - double{by.y}};
    }
    /// The vector from `b` to `a`.
    friend constexpr Vec2 operator-(const Position& a, const Position& b) {
        return {a.x - b.x, a.y - b.y};
    }

    /// The coordinate along an axis, 0 for x and 1 for y.
    constexpr double& operator[](int axis) { return axis == 0 ? x : y; }
    /// The same, read-only.
    constexpr const double& operator[](int axis) const { return axis == 0 ? x : y; }

    /// The smaller coordinates.
    constexpr Position min(const Position& b) const {
        return {b.x < x ? b.x : x, b.y < y ? b.y : y};
    }
    /// The larger coordinates.
    constexpr Position max(const Position& b) const {
        return {x < b.x ? b.x : x, y < b.y ? b.y : y};
    }
    /// True if no coordinate is below that of `low` or above that of `high`.
    constexpr bool within(const Position& low, const Position& high) const {
        return low.x <= x && x <= high.x && low.y <= y && y <= high.y;
    }
    /// False if a coordinate is infinite or not a number.
    bool is_finite() const { return fettle::detail::finite(x) && fettle::detail::finite(y); }
};
/// One coordinate of a point of the world, m.
using WorldCoordinate = double;

#else

/// A point of the world, m. With the build option FETTLE_PHYSICS_DOUBLE it has double precision,
/// and only the difference of two points is a `Vec2`.
using Position = Vec2;
/// One coordinate of a point of the world, m.
using WorldCoordinate = float;

#endif

}  // namespace fettle::physics

FETTLE_PHYSICS_END
