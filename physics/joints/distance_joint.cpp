#include <joints/distance_joint.h>

// With d = p_b - p_a between the anchors and n = d/|d|, all rows have the same Jacobian:
//
//     C = |d| - length,   Ċ = n·(v_b + ω_b×r_b - v_a - ω_a×r_a),
//     K = m_a⁻¹ + m_b⁻¹ + I_a⁻¹·(r_a×n)² + I_b⁻¹·(r_b×n)²,   effective mass 1/K.
//
// Rod: C = 0, softly. Spring: a force along n. Limits: |d| - min >= 0 and max - |d| >= 0, each with
// an impulse that only pushes its way. The axis is found anew in each pass: a pendulum follows its
// circle.

namespace fettle::physics::detail {

void DistanceConstraint::prepare(const Data& data, const JointFrame&, const JointStep& step,
                                 const SolverBody& a, const SolverBody& b) {
    upper = data.max_length;
    lower = min(data.min_length, upper);  // where they cross, the upper one counts
    rigid = data.hertz == infinity;
    springy = !rigid && data.hertz > 0.0f;
    length = rigid ? clamp(data.length, lower, upper) : data.length;
    limited = !rigid && (lower > 0.0f || upper < infinity);
    if (springy) spring = Spring::make(data.hertz, data.damping_ratio, step.h);
    // What no longer acts starts at nothing when it acts again.
    if (!rigid && !springy) impulses.along = 0.0f;
    if (!limited) impulses.lower = impulses.upper = 0.0f;
    follow(a, b);
}

/// Turns the levers and the axis with the bodies; the distance.
float DistanceConstraint::follow(const SolverBody& a, const SolverBody& b) {
    ends.follow(a, b);
    const V2 d = ends.gap(a, b);
    const float distance = physics::detail::length(d);
    // Points that coincide keep the axis they had, or take any.
    if (distance > 1e-9f) axis = (1.0f / distance) * d;
    if (axis.x == 0.0f && axis.y == 0.0f) axis = {0.0f, 1.0f};
    lever_a = cross(ends.lever_a, axis);
    lever_b = cross(ends.lever_b, axis);
    mass = inverse_or_zero(ends.inverse_along(axis) + a.inverse_inertia * lever_a * lever_a +
                           b.inverse_inertia * lever_b * lever_b);
    return distance;
}

float DistanceConstraint::velocity(const SolverBody& a, const SolverBody& b) const {
    return dot(axis, b.velocity - a.velocity) +
           (lever_b * b.angular_velocity - lever_a * a.angular_velocity);
}

void DistanceConstraint::push_along(SolverBody& a, SolverBody& b, float p) const {
    a.velocity = a.velocity - p * scaled(ends.inverse_a, axis);
    a.angular_velocity -= a.inverse_inertia * lever_a * p;
    b.velocity = b.velocity + p * scaled(ends.inverse_b, axis);
    b.angular_velocity += b.inverse_inertia * lever_b * p;
}

void DistanceConstraint::warm_start(SolverBody& a, SolverBody& b) const {
    push_along(a, b, impulses.along + impulses.lower - impulses.upper);
}

void DistanceConstraint::solve(SolverBody& a, SolverBody& b, const JointStep& step) {
    const float distance = follow(a, b);
    const float error = distance - length;
    float change = 0.0f;
    if (springy) {
        change = spring.impulse(mass, velocity(a, b), error, impulses.along);
    } else if (rigid) {
        const Softness& soft = step.rigid;
        change = -mass * soft.mass_scale * (velocity(a, b) + soft.bias_rate * error) -
                 soft.impulse_scale * impulses.along;
    }
    impulses.along += change;
    push_along(a, b, change);
    if (limited) solve_limits<true>(a, b, distance, step);
}

void DistanceConstraint::relax(SolverBody& a, SolverBody& b, const JointStep& step) {
    if (!rigid && !limited) return;
    const float distance = follow(a, b);
    if (rigid) {
        const float change = -mass * velocity(a, b);
        impulses.along += change;
        push_along(a, b, change);
    }
    if (limited) solve_limits<false>(a, b, distance, step);
}

template <bool biased>
void DistanceConstraint::solve_limits(SolverBody& a, SolverBody& b, float distance,
                                      const JointStep& step) {
    if (lower > 0.0f) {
        push_along(
            a, b, push_limit<biased>(impulses.lower, mass, velocity(a, b), distance - lower, step));
    }
    if (upper < infinity) {
        push_along(
            a, b,
            -push_limit<biased>(impulses.upper, mass, -velocity(a, b), upper - distance, step));
    }
}

}  // namespace fettle::physics::detail
