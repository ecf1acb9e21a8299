#include <joints/revolute_joint.h>

// Two rows hold the point, solved as one block since the inertia couples them:
//
//     C = p_b - p_a,   Ċ = v_b + ω_b×r_b - v_a - ω_a×r_a,   λ = -K⁻¹·(Ċ + bias)   (`PointMass`).
//
// K is that of the levers as they are in each pass: with the K of the step's begin, light links
// that whip about under a heavy load gain energy. The rows about the angle θ = θ_b - θ_a -
// reference have Ċ = ω_b - ω_a and the effective mass 1/(I_a⁻¹ + I_b⁻¹): a spring to the target, a
// motor that is a velocity with a greatest torque, and limits θ - lower >= 0, upper - θ >= 0. They
// come first, and the point has the last word: what it misses is seen at once.

namespace fettle::physics::detail {

void RevoluteConstraint::prepare(const Data& data, const JointFrame&, const JointStep& step,
                                 const SolverBody& a, const SolverBody& b) {
    angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
    const bool turns = angular_mass > 0.0f;
    reference = data.reference_angle;
    target = data.target_angle;
    upper = data.upper_angle;
    lower = min(data.lower_angle, upper);  // where they cross, the upper one counts
    motor_speed = data.motor_speed;
    greatest_motor = data.max_motor_torque * step.h;
    springy = turns && data.hertz > 0.0f;
    driven = turns && data.max_motor_torque > 0.0f;
    limited = turns && (lower > -infinity || upper < infinity);
    if (springy) spring = Spring::make(data.hertz, data.damping_ratio, step.h);
    // What no longer acts starts at nothing when it acts again.
    if (!springy) impulses.spring = 0.0f;
    if (!driven) impulses.motor = 0.0f;
    if (!limited) impulses.lower = impulses.upper = 0.0f;
    mass = PointMass::make(ends, a, b);
}

void RevoluteConstraint::warm_start(SolverBody& a, SolverBody& b) const {
    ends.push(a, b, impulses.point);
    detail::twist(a, b, twist());
}

template <bool biased>
void RevoluteConstraint::solve_angle(SolverBody& a, SolverBody& b, const JointStep& step) {
    auto velocity = [&] { return b.angular_velocity - a.angular_velocity; };
    const float angle = ends.angle_now(a, b) - reference;
    if (biased && springy) {
        const float change =
            spring.impulse(angular_mass, velocity(), angle - target, impulses.spring);
        impulses.spring += change;
        detail::twist(a, b, change);
    }
    if (driven) {
        detail::twist(
            a, b,
            push_motor(impulses.motor, angular_mass, velocity(), motor_speed, greatest_motor));
    }
    if (!limited) return;
    if (lower > -infinity) {
        detail::twist(
            a, b,
            push_limit<biased>(impulses.lower, angular_mass, velocity(), angle - lower, step));
    }
    if (upper < infinity) {
        detail::twist(
            a, b,
            -push_limit<biased>(impulses.upper, angular_mass, -velocity(), upper - angle, step));
    }
}

void RevoluteConstraint::solve(SolverBody& a, SolverBody& b, const JointStep& step) {
    if (springy || driven || limited) solve_angle<true>(a, b, step);
    // The bodies are where the last relax pass, or the begin of the step, has seen them.
    const Softness& soft = step.rigid;
    const V2 velocity = ends.velocity(a, b) + soft.bias_rate * ends.gap(a, b);
    const V2 change = -soft.mass_scale * (mass * velocity) - soft.impulse_scale * impulses.point;
    impulses.point = impulses.point + change;
    ends.push(a, b, change);
}

void RevoluteConstraint::relax(SolverBody& a, SolverBody& b, const JointStep& step) {
    if (driven || limited) solve_angle<false>(a, b, step);
    ends.follow(a, b);
    mass = PointMass::make(ends, a, b);
    const V2 change = -(mass * ends.velocity(a, b));
    impulses.point = impulses.point + change;
    ends.push(a, b, change);
}

}  // namespace fettle::physics::detail
