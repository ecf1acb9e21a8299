#pragma once

#include <constraints/springs.h>

#include <cmath>

// The rows of joints. Each function returns the impulse to apply and adds it to the total.

namespace fettle::physics::detail {

/// Two rows that hold a point: K⁻¹, times the share of a crowded joint.
struct PointMass {
    float xx = 0.0f, xy = 0.0f, yy = 0.0f;

    static PointMass make(const JointEnds& e, const SolverBody& a, const SolverBody& b) {
        const PointInverse k = PointInverse::make(e, a, b);
        const float inverse = e.share * inverse_or_zero(k.xx * k.yy - k.xy * k.xy);
        return {inverse * k.yy, -inverse * k.xy, inverse * k.xx};
    }
    Vec2 operator*(Vec2 v) const { return {xx * v.x + xy * v.y, xy * v.x + yy * v.y}; }
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

}  // namespace fettle::physics::detail
