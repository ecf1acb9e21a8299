#pragma once

#include <geometry/trigonometry.h>

#include <cstdint>

// The bodies of the solver, and the softness of the constraints between them.

namespace fettle::physics::detail {

/// The part of a body that constraints read and write, 32 bytes. Index 0 is the fixed body, which
/// represents every fixed or sleeping body.
struct alignas(32) SolverBody {
    Vec2 velocity;
    float angular_velocity = 0.0f;
    float inverse_mass = 0.0f;
    Vec2 shift;         ///< of the center of mass since the start of the step, m
    float turn = 0.0f;  ///< since the start of the step, rad
    float inverse_inertia = 0.0f;
};
static_assert(sizeof(SolverBody) == 32);

/// False for a body that no impulse moves.
inline bool moves(const SolverBody& body) {
    return body.inverse_mass > 0.0f || body.inverse_inertia > 0.0f;
}

/// Square of the radius of gyration of a body, m²; a large number for one that does not rotate.
inline float gyration_of(const SolverBody& b) {
    return b.inverse_mass > 0.0f && b.inverse_inertia > 0.0f ? b.inverse_mass / b.inverse_inertia
                                                             : 1e30f;
}

/// The effect of gravity, forces and damping on a body in one sub-step: v ← (v + change) · keep.
struct alignas(16) SolverForce {
    Vec2 change;
    float turn_change = 0.0f;
    float no_change = 0.0f;  ///< always 0: fills the vector of velocities and mass
    Vec2 keep = {1.0f, 1.0f};
    float turn_keep = 1.0f;
    float keep_all = 1.0f;
    /// Velocity before the warm start of contacts, after that of joints.
    Vec2 before;
    float turn_before = 0.0f;
    float unused = 0.0f;
};

/// The inverse of a mass; 0 for a body that nothing moves.
inline float inverse_or_zero(float k) {
    return k > 0.0f ? 1.0f / k : 0.0f;
}

/// d·(M_a⁻¹ + M_b⁻¹)·d for a direction d. `inverse_a`, `inverse_b`: inverse masses along x and y.
inline float inverse_along(Vec2 d, Vec2 inverse_a, Vec2 inverse_b) {
    return d.x * d.x * (inverse_a.x + inverse_b.x) + d.y * d.y * (inverse_a.y + inverse_b.y);
}

/// Coefficients of a soft constraint.
struct Softness {
    float bias_rate = 0.0f;
    float mass_scale = 1.0f;
    float impulse_scale = 0.0f;
};

/// `hertz` 0 is rigid without position correction. With ω = 2π·hertz and sub-step h: a1 = 2ζ + hω,
/// a2 = hω·a1 (E. Catto, "Soft Constraints", GDC 2011).
inline Softness make_softness(float hertz, float damping_ratio, float h) {
    if (!(hertz > 0.0f)) return {0.0f, 1.0f, 0.0f};
    const float omega = two_pi<float> * hertz;
    const float a1 = 2.0f * damping_ratio + h * omega;
    const float a2 = h * omega * a1;
    const float a3 = 1.0f / (1.0f + a2);
    return {omega / a1, a2 * a3, a3};
}

}  // namespace fettle::physics::detail
