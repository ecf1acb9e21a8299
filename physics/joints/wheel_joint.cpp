#include <joints/wheel_joint.h>

// A point of b on a line of a (`Rail`), with the suspension as the spring along it, and a motor
// about the axle: Ċ = ω_b - ω_a - speed with at most max_motor_torque, effective mass
// 1/(I_a⁻¹ + I_b⁻¹).

namespace fettle::physics::detail {

void WheelConstraint::prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                              const SolverBody& a, const SolverBody& b) {
    rail.prepare(data.rail, impulses.rail, ends, frame, step, a, b);
    angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
    driven = angular_mass > 0.0f && data.max_motor_torque > 0.0f;
    motor_speed = data.motor_speed;
    greatest_motor = data.max_motor_torque * step.h;
    if (!driven) impulses.motor = 0.0f;
}

void WheelConstraint::warm_start(SolverBody& a, SolverBody& b) const {
    rail.push_both(impulses.rail, ends, a, b);
    detail::twist(a, b, impulses.motor);
}

void WheelConstraint::drive(SolverBody& a, SolverBody& b) {
    if (!driven) return;
    detail::twist(a, b,
                  push_motor(impulses.motor, angular_mass, b.angular_velocity - a.angular_velocity,
                             motor_speed, greatest_motor));
}

void WheelConstraint::solve(SolverBody& a, SolverBody& b, const JointStep& step) {
    drive(a, b);
    rail.follow(ends, a, b);
    if (rail.acts_along()) rail.solve_along<true>(impulses.rail, ends, a, b, step);
    rail.solve_across<true>(impulses.rail, ends, a, b, step);
}

void WheelConstraint::relax(SolverBody& a, SolverBody& b, const JointStep& step) {
    drive(a, b);
    rail.follow(ends, a, b);
    if (rail.limited) rail.solve_along<false>(impulses.rail, ends, a, b, step);
    rail.solve_across<false>(impulses.rail, ends, a, b, step);
}

}  // namespace fettle::physics::detail
