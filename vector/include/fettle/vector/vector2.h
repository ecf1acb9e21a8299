#pragma once

#include <fettle/vector/scalar.h>

#include <type_traits>

namespace fettle {

/// A type of numbers that a vector is made of.
template <class T>
concept Number = std::is_arithmetic_v<T>;

/// A vector or a point in the plane, with components of type `T`. The physics library uses
/// `Vector2<float>` and the property tree `Vector2<double>`; both call it `Vec2`. The components
/// are 0 unless given. Every equation is written out with a fixed order of its operations, so every
/// compiler computes the same bits.
template <class T>
struct Vector2 {
    T x = 0;  ///< to the right
    T y = 0;  ///< upwards

    constexpr Vector2() = default;  ///< zero
    /// Any numbers; they are converted to `T`.
    template <Number X, Number Y>
    constexpr Vector2(X along_x, Y along_y)
        : x(static_cast<T>(along_x)), y(static_cast<T>(along_y)) {}
    /// Rounds to the nearest value of `T` when `T` has fewer digits.
    template <class U>
    explicit constexpr Vector2(const Vector2<U>& other)
        : x(static_cast<T>(other.x)), y(static_cast<T>(other.y)) {}

    /// Sum, difference, product and quotient, component by component.
    constexpr Vector2& operator+=(const Vector2& other) { return *this = *this + other; }
    constexpr Vector2& operator-=(const Vector2& other) { return *this = *this - other; }
    constexpr Vector2& operator*=(T factor) { return *this = factor * *this; }
    constexpr Vector2& operator/=(T divisor) { return *this = *this / divisor; }

    friend constexpr bool operator==(const Vector2&, const Vector2&) = default;
    /// Sum, difference, product and quotient, component by component.
    friend constexpr Vector2 operator+(Vector2 a, Vector2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vector2 operator-(Vector2 a, Vector2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vector2 operator-(Vector2 a) { return {-a.x, -a.y}; }
    friend constexpr Vector2 operator*(T factor, Vector2 a) { return {factor * a.x, factor * a.y}; }
    friend constexpr Vector2 operator*(Vector2 a, T factor) { return factor * a; }
    friend constexpr Vector2 operator/(Vector2 a, T divisor) {
        return {a.x / divisor, a.y / divisor};
    }

    /// The scalar product.
    constexpr T dot(Vector2 other) const { return x * other.x + y * other.y; }
    /// The z component of the cross product: positive if `other` lies counter-clockwise of this.
    constexpr T cross(Vector2 other) const { return x * other.y - y * other.x; }
    constexpr T length_squared() const { return x * x + y * y; }        ///< less work than `length`
    T length() const { return detail::square_root(length_squared()); }  ///< at least 0
    /// The vector of length 1 in this direction; a zero vector stays as it is.
    Vector2 normalized() const {
        const T norm = length();
        return norm > 0 ? *this / norm : *this;
    }

    /// The component along an axis, 0 for x and 1 for y.
    constexpr T& operator[](int axis) { return axis == 0 ? x : y; }
    /// The same, read-only.
    constexpr const T& operator[](int axis) const { return axis == 0 ? x : y; }

    /// x and y one after the other, for interfaces in C.
    T* data() { return &x; }
    const T* data() const { return &x; }

    // Component by component:
    /// The smaller components.
    constexpr Vector2 min(Vector2 b) const { return {b.x < x ? b.x : x, b.y < y ? b.y : y}; }
    /// The larger components.
    constexpr Vector2 max(Vector2 b) const { return {x < b.x ? b.x : x, y < b.y ? b.y : y}; }
    /// The products of the components.
    constexpr Vector2 times(Vector2 b) const { return {x * b.x, y * b.y}; }
    /// The quotients of the components.
    constexpr Vector2 over(Vector2 b) const { return {x / b.x, y / b.y}; }
    /// The absolute values of the components.
    Vector2 abs() const { return {detail::absolute(x), detail::absolute(y)}; }
    /// True if no component is below that of `low` or above that of `high`.
    constexpr bool within(Vector2 low, Vector2 high) const {
        return low.x <= x && x <= high.x && low.y <= y && y <= high.y;
    }
    /// The smaller component.
    constexpr T smallest() const { return y < x ? y : x; }
    /// The larger component.
    constexpr T largest() const { return x < y ? y : x; }
    /// False if a component is infinite or not a number.
    bool is_finite() const { return detail::finite(x) && detail::finite(y); }
};

}  // namespace fettle
