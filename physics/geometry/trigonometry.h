#pragma once

#include <geometry/vector.h>

#include <numbers>

// Sine, cosine and arc tangent without the C library, whose results differ between systems:
// simulations would differ with them.

namespace fettle::physics::detail {

inline constexpr float pi = std::numbers::pi_v<float>;
template <class Real>
inline constexpr Real two_pi = 2 * std::numbers::pi_v<Real>;

/// Cosine and sine of an angle (rad). The error is about one unit in the last place of a float.
/// NaN, and angles of more than 1e15 quarter turns, give no rotation.
Rotation rotation_of(double angle);

/// Angle of the vector (x, y) in -π … π; 0 for the zero vector. Error below 1e-7 rad.
double angle_of(double y, double x);

}  // namespace fettle::physics::detail
