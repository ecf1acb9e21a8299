#include <joints/rail.h>

// The axis u and its perpendicular n turn with body a. With d = p_b - p_a and R = r_a + d, the arm
// from the center of a to the anchor of b:
//
//     s = u·d,   ṡ = u·(v_b - v_a) + (r_b×u)·ω_b - (R×u)·ω_a      translation
//     C = n·d,   Ċ = n·(v_b - v_a) + (r_b×n)·ω_b - (R×n)·ω_a      across, to be 0
//
// since u̇ = ω_a×u adds ω_a·(u×d) to the plain difference of the anchors' velocities, which is what
// makes the arm of a reach to b. The effective mass of a row is 1 / (uᵀ(M_a⁻¹ + M_b⁻¹)u +
// I_a⁻¹(R×u)² + I_b⁻¹(r_b×u)²). Along the axis act a spring to a target, a motor that is a velocity
// with a greatest force, and limits.

namespace fettle::physics::detail {

void Line::aim(const JointEnds& ends, V2 towards, V2 arm, const SolverBody& a,
               const SolverBody& b) {
    direction = towards;
    lever_a = cross(arm, towards);
    lever_b = cross(ends.lever_b, towards);
    mass = inverse_or_zero(ends.inverse_along(towards) + a.inverse_inertia * lever_a * lever_a +
                           b.inverse_inertia * lever_b * lever_b);
}

void Line::push(const JointEnds& ends, SolverBody& a, SolverBody& b, float p) const {
    a.velocity = a.velocity - p * scaled(ends.inverse_a, direction);
    a.angular_velocity -= a.inverse_inertia * lever_a * p;
    b.velocity = b.velocity + p * scaled(ends.inverse_b, direction);
    b.angular_velocity += b.inverse_inertia * lever_b * p;
}

void Rail::prepare(const RailSettings& settings, RailImpulses& impulses, JointEnds& ends,
                   const JointFrame& frame, const JointStep& step, const SolverBody& a,
                   const SolverBody& b) {
    start_axis = rotate(frame.a, normalized(settings.axis));
    upper = settings.upper;
    lower = min(settings.lower, upper);  // where they cross, the upper one counts
    motor_speed = settings.motor_speed;
    greatest_motor = settings.max_motor_force * step.h;
    target = settings.target;
    springy = settings.hertz > 0.0f;
    driven = settings.max_motor_force > 0.0f;
    limited = lower > -infinity || upper < infinity;
    if (springy) spring = Spring::make(settings.hertz, settings.damping_ratio, step.h);
    // What no longer acts starts at nothing when it acts again.
    if (!springy) impulses.spring = 0.0f;
    if (!driven) impulses.motor = 0.0f;
    if (!limited) impulses.lower = impulses.upper = 0.0f;
    follow(ends, a, b);
}

void Rail::follow(JointEnds& ends, const SolverBody& a, const SolverBody& b) {
    ends.follow(a, b);
    const V2 axis = turned(start_axis, a.turn), normal = {-axis.y, axis.x};
    const V2 gap = ends.gap(a, b);
    translation = dot(axis, gap);
    offset = dot(normal, gap);
    along.aim(ends, axis, ends.lever_a + gap, a, b);
    across.aim(ends, normal, ends.lever_a + gap, a, b);
}

void Rail::push_both(const RailImpulses& impulses, const JointEnds& ends, SolverBody& a,
                     SolverBody& b) const {
    along.push(ends, a, b, impulses.along());
    across.push(ends, a, b, impulses.across);
}

template <bool biased>
void Rail::solve_along(RailImpulses& impulses, const JointEnds& ends, SolverBody& a, SolverBody& b,
                       const JointStep& step) const {
    auto velocity = [&] { return along.velocity(a, b); };
    if (biased && springy) {
        const float change =
            spring.impulse(along.mass, velocity(), translation - target, impulses.spring);
        impulses.spring += change;
        along.push(ends, a, b, change);
    }
    if (driven) {
        along.push(ends, a, b,
                   push_motor(impulses.motor, along.mass, velocity(), motor_speed, greatest_motor));
    }
    if (lower > -infinity) {
        along.push(
            ends, a, b,
            push_limit<biased>(impulses.lower, along.mass, velocity(), translation - lower, step));
    }
    if (upper < infinity) {
        along.push(ends, a, b,
                   -push_limit<biased>(impulses.upper, along.mass, -velocity(), upper - translation,
                                       step));
    }
}

template <bool biased>
void Rail::solve_across(RailImpulses& impulses, const JointEnds& ends, SolverBody& a, SolverBody& b,
                        const JointStep& step) const {
    const float change =
        push_rigid<biased>(impulses.across, across.mass, across.velocity(a, b), offset, step);
    across.push(ends, a, b, change);
}

template void Rail::solve_along<true>(RailImpulses&, const JointEnds&, SolverBody&, SolverBody&,
                                      const JointStep&) const;
template void Rail::solve_along<false>(RailImpulses&, const JointEnds&, SolverBody&, SolverBody&,
                                       const JointStep&) const;
template void Rail::solve_across<true>(RailImpulses&, const JointEnds&, SolverBody&, SolverBody&,
                                       const JointStep&) const;
template void Rail::solve_across<false>(RailImpulses&, const JointEnds&, SolverBody&, SolverBody&,
                                        const JointStep&) const;

}  // namespace fettle::physics::detail
