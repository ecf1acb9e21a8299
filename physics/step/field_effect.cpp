#include <step/field_effect.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// The greatest resistance, in the share of the velocity that it would remove in a step. It stops a
/// body, and rounding is still small.
constexpr double greatest_resistance = 1e9;

/// Solves `m` x = `x`. The eigenvalues of `m` are at least 1, and so are its pivots but for
/// rounding.
void solve(std::array<Twist, 3>& m, Twist& x) {
    for (size_t i = 0; i < 3; ++i) {
        m[i][i] = std::max(m[i][i], 1.0);
        for (size_t k = i + 1; k < 3; ++k) {
            const double factor = m[k][i] / m[i][i];
            for (size_t j = i; j < 3; ++j) m[k][j] -= factor * m[i][j];
            x[k] -= factor * x[i];
        }
    }
    for (size_t i = 3; i-- > 0;) {
        for (size_t k = i + 1; k < 3; ++k) x[i] -= m[i][k] * x[k];
        x[i] /= m[i][i];
    }
}

}  // namespace

void FieldEffect::at(Vec2 arm, Vec2 force) {
    force_[0] += double(force.x);
    force_[1] += double(force.y);
    force_[2] += double(cross(arm, force));
}

void FieldEffect::resist(Vec2 arm, double resistance, Vec2 velocity) {
    resist_along({1.0f, 0.0f}, arm, resistance, velocity.x);
    resist_along({0.0f, 1.0f}, arm, resistance, velocity.y);
}

void FieldEffect::resist_along(Vec2 n, Vec2 arm, double resistance, float speed) {
    const Twist along = {double(n.x), double(n.y), double(cross(arm, n))};
    for (size_t i = 0; i < 3; ++i) {
        resistance_[i] -= resistance * double(speed) * along[i];
        for (size_t k = 0; k < 3; ++k) by_velocity_[i][k] += resistance * along[i] * along[k];
    }
}

void FieldEffect::resist_turn(double resistance, float spin) {
    resistance_[2] -= resistance * double(spin);
    by_velocity_[2][2] += resistance;
}

Twist FieldEffect::change(Twist change, const Twist& inverse, double dt) const {
    double greatest = 0.0;
    for (size_t i = 0; i < 3; ++i) {
        change[i] = inverse[i] > 0.0 ? change[i] + dt * inverse[i] * force_[i] : 0.0;
        greatest = std::max(greatest, dt * inverse[i] * by_velocity_[i][i]);
    }
    if (!(greatest > 0.0)) return change;
    const double scale = dt * std::min(1.0, greatest_resistance / greatest);
    // In velocities times the root of the mass, the matrix is symmetric.
    std::array<Twist, 3> m;
    Twist x;
    for (size_t i = 0; i < 3; ++i) {
        double against = resistance_[i];
        for (size_t k = 0; k < 3; ++k) {
            against -= by_velocity_[i][k] * change[k];
            m[i][k] = scale * std::sqrt(inverse[i] * inverse[k]) * by_velocity_[i][k];
        }
        m[i][i] += 1.0;
        x[i] = scale * std::sqrt(inverse[i]) * against;
    }
    solve(m, x);
    for (size_t i = 0; i < 3; ++i) change[i] += std::sqrt(inverse[i]) * x[i];
    return change;
}

}  // namespace fettle::physics::detail
