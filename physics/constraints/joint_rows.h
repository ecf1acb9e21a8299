#pragma once

#include <constraints/joint_ends.h>

// The rows of joints. Each function returns the impulse to apply and adds it to the total.

namespace fettle::physics::detail {

/// A spring in the form of a row: Δλ = -m·(mass_scale·v + push·C) - impulse_scale·λ. The force is
/// -k·C - d·v with the position before the sub-step and the velocity after it. This conserves
/// energy while h·ω is small, so a spring swings with the frequency and the damping of its
/// settings. Above that (h·ω > ½), the stiffness increasingly uses the position after the sub-step.
/// This damps, and is stable for one spring of any stiffness. Each sub-step solves a spring once,
/// though, so springs in a row pass on what they push one after the other: from h·ω = 1.5 on, such
/// a row breaks apart. A stiffer spring therefore has the stiffness of `greatest_turn`.
struct Spring {
    static constexpr float greatest_turn = 1.25f;  ///< h·ω

    float push = 0.0f;
    float mass_scale = 0.0f;
    float impulse_scale = 1.0f;

    static Spring make(float hertz, float damping_ratio, float h) {
        const float turn = min(two_pi<float> * hertz * h, greatest_turn);  // h·ω
        const float implicit = clamp(turn - 0.5f, 0.0f, 1.0f);
        const float a = turn * (2.0f * damping_ratio + implicit * turn);
        const float rest = 1.0f / (1.0f + a);
        return {turn * turn / h * rest, a * rest, rest};
    }
    float impulse(float mass, float velocity, float error, float so_far) const {
        return -mass * (mass_scale * velocity + push * error) - impulse_scale * so_far;
    }
};

/// A row that keeps an error at 0. `velocity` is that of the error. `reaction`: the part of the
/// impulse with which the row answers a limit or a motor; it does not yield to that. Returns the
/// change of `impulse`.
template <bool biased>
float push_rigid(float& impulse, float mass, float velocity, float error, const Softness& soft,
                 float reaction = 0.0f) {
    float change = -mass * velocity;
    if constexpr (biased)
        change = -mass * soft.mass_scale * (velocity + soft.bias_rate * error) -
                 soft.impulse_scale * (impulse - reaction);
    impulse += change;
    return change;
}

/// A row that pushes in one direction only: it prevents `room` from becoming negative. `velocity`
/// is the time derivative of the room. Returns the change of `impulse`. What is missing of the room
/// comes back at a limited speed: that for `greatest_gap`. `greatest`: the maximum impulse.
template <bool biased>
float push_limit(float& impulse, float mass, float velocity, float room, const JointStep& step,
                 float greatest_gap, float greatest = infinity) {
    float bias = 0.0f, mass_scale = 1.0f, impulse_scale = 0.0f;
    if (room > 0.0f) {
        bias = room * step.inverse_h;  // the room may close completely, but not more
    } else if (biased) {
        const Softness soft = step.softness_up_to(greatest_gap, room);
        bias = soft.bias_rate * room;
        mass_scale = soft.mass_scale;
        impulse_scale = soft.impulse_scale;
    }
    const float wanted = -mass * mass_scale * (velocity + bias) - impulse_scale * impulse;
    const float total = clamp(impulse + wanted, 0.0f, greatest);
    const float change = total - impulse;
    impulse = total;
    return change;
}

/// A row that drives a velocity to `speed`. `greatest` is the maximum impulse. Returns the change.
///
/// A motor that holds a heavy limb by a light bone needs many passes until its impulse is that of
/// the load. So the impulse lags behind the load, like a spring without damping, and a ragdoll
/// whose joints have friction trembles forever. Therefore the impulse with which the next sub-step
/// begins falls by more than the change, when it falls. A motor that a limit of its joint stops, or
/// whose maximum falls, falls by the change alone: otherwise its load would drop and be pushed back
/// again and again.
inline float push_motor(float& impulse, float mass, float velocity, float speed, float greatest,
                        bool stopped = false) {
    const float total = clamp(impulse - mass * (velocity - speed), -greatest, greatest);
    const float further = stopped || std::abs(total) == greatest ? 0.0f : 3.0f;
    const float change = total - impulse;
    impulse = total;
    if (change * total < 0.0f)
        impulse = total > 0.0f ? max(total + further * change, 0.0f)
                               : min(total + further * change, 0.0f);
    return change;
}

/// Two rows that hold a point: the inverse of K = M_a⁻¹ + M_b⁻¹ + I_a⁻¹·r_a⊥ r_a⊥ᵀ +
/// I_b⁻¹·r_b⊥ r_b⊥ᵀ.
struct PointMass {
    float xx = 0.0f, xy = 0.0f, yy = 0.0f;

    static PointMass make(const JointEnds& e, const SolverBody& a, const SolverBody& b) {
        const float ia = a.inverse_inertia, ib = b.inverse_inertia;
        const float xx = e.inverse_a.x + e.inverse_b.x + ia * e.lever_a.y * e.lever_a.y +
                         ib * e.lever_b.y * e.lever_b.y;
        const float yy = e.inverse_a.y + e.inverse_b.y + ia * e.lever_a.x * e.lever_a.x +
                         ib * e.lever_b.x * e.lever_b.x;
        const float xy = -ia * e.lever_a.x * e.lever_a.y - ib * e.lever_b.x * e.lever_b.y;
        const float inverse = e.share * inverse_or_zero(xx * yy - xy * xy);
        return {inverse * yy, -inverse * xy, inverse * xx};
    }
    Vec2 operator*(Vec2 v) const { return {xx * v.x + xy * v.y, xy * v.x + yy * v.y}; }
};

}  // namespace fettle::physics::detail
