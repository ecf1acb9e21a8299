#pragma once

#include <geometry/vector.h>

// Sine, cosine and arc tangent of our own: the C library's differ between systems, and with them
// every simulation.

namespace fettle::physics::detail {

inline constexpr float pi = 3.14159265358979f;

/// Cosine and sine of an angle (rad), correct to about one unit in the last place of a float.
Rotation rotation_of(double angle);

/// Angle of the vector (x, y) in -π … π; 0 for the zero vector. Error below 1e-7 rad.
double angle_of(double y, double x);

}  // namespace fettle::physics::detail
