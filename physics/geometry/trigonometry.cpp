#include <geometry/trigonometry.h>

#include <cstdint>

namespace fettle::physics::detail {
namespace {

constexpr double half_pi = 1.57079632679489661923;

/// Taylor series up to x¹¹ and x¹². For |x| <= π/4 the error is below 1e-11, less than the
/// resolution of a float.
double sine_series(double x) {
    const double z = x * x;
    return x * (1.0 + z * (-1.0 / 6 + z * (1.0 / 120 + z * (-1.0 / 5040 +
                                                            z * (1.0 / 362880 - z / 39916800.0)))));
}

double cosine_series(double x) {
    const double z = x * x;
    return 1.0 + z * (-0.5 + z * (1.0 / 24 +
                                  z * (-1.0 / 720 + z * (1.0 / 40320 +
                                                         z * (-1.0 / 3628800 + z / 479001600.0)))));
}

/// Arc tangent for |t| <= tan(π/16). The error of the series up to t¹³ is below 1e-11 there.
double arc_tangent_series(double t) {
    const double z = t * t;
    return t * (1.0 +
                z * (-1.0 / 3 +
                     z * (1.0 / 5 + z * (-1.0 / 7 + z * (1.0 / 9 + z * (-1.0 / 11 + z / 13.0))))));
}

}  // namespace

Rotation rotation_of(double angle) {
    // The nearest quarter turn gives the quadrant. A double hardly resolves the direction of larger
    // angles.
    const double quarters = angle * (1.0 / half_pi);
    if (!(quarters > -1e15 && quarters < 1e15)) return {};
    const int64_t quadrant = int64_t(quarters + (quarters >= 0.0 ? 0.5 : -0.5));
    const double rest = angle - double(quadrant) * half_pi;
    const float s = float(sine_series(rest));
    const float c = float(cosine_series(rest));
    switch (quadrant & 3) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

double angle_of(double y, double x) {
    const double ax = x < 0.0 ? -x : x;
    const double ay = y < 0.0 ? -y : y;
    const double large = ax > ay ? ax : ay;
    const double small = ax > ay ? ay : ax;
    if (!(large > 0.0)) return 0.0;
    // atan t = atan c + atan((t - c) / (1 + t c)) with c = tan π/8 or tan π/4 reduces 0 … 1 to the
    // range of the series.
    constexpr double tan_eighth = 0.41421356237309504880;
    const double t = small / large;
    double angle = 0.0;
    if (t <= 0.19891236737965800691) {
        angle = arc_tangent_series(t);
    } else if (t <= 0.66817863791929891999) {
        angle = half_pi / 4 + arc_tangent_series((t - tan_eighth) / (1.0 + t * tan_eighth));
    } else {
        angle = half_pi / 2 + arc_tangent_series((t - 1.0) / (1.0 + t));
    }
    if (ay > ax) angle = half_pi - angle;
    if (x < 0.0) angle = 2.0 * half_pi - angle;
    return y < 0.0 ? -angle : angle;
}

}  // namespace fettle::physics::detail
