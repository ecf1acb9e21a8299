#include <joints/motor_joint.h>

// The velocity of anchor b as body a sees it, which turns, is driven to (u, w):
//
//     Ċ = v_b + ω_b×r_b - v_a - ω_a×(r_a + d) - u,   Ċ_θ = ω_b - ω_a - w,   d = p_b - p_a,
//
// (the arm of a reaches to anchor b: both bodies are pushed at the same point) each with an impulse
// that is no greater than max_force·h and max_torque·h. With a stiffness, the offset from a (which
// turns with it) and the angle are springs besides, within the same limits: then it is a position
// that is driven. A force alone, it is no part of the relax pass while it is a spring.

namespace fettle::physics::detail {

void MotorConstraint::prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                              const SolverBody& a, const SolverBody& b) {
    speed = rotate(frame.a, data.linear_velocity);
    offset = rotate(frame.a, data.linear_offset);
    turn_speed = data.angular_velocity;
    angle = data.angular_offset;
    angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
    greatest_force = data.max_force * step.h;
    greatest_torque = data.max_torque * step.h;
    springy = data.hertz > 0.0f;
    if (springy) spring = Spring::make(data.hertz, data.damping_ratio, step.h);
    if (angular_mass == 0.0f) impulses.torque = 0.0f;
    follow(a, b);
}

void MotorConstraint::warm_start(SolverBody& a, SolverBody& b) const {
    ends.push(a, b, impulses.force);
    detail::twist(a, b, impulses.torque);
}

/// Turns the levers with the bodies; from anchor a to anchor b.
V2 MotorConstraint::follow(const SolverBody& a, const SolverBody& b) {
    ends.follow(a, b);
    const V2 gap = ends.gap(a, b);
    ends.lever_a = ends.lever_a + gap;
    return gap;
}

void MotorConstraint::drive(SolverBody& a, SolverBody& b, bool springs) {
    const V2 gap = follow(a, b);
    const float turning = b.angular_velocity - a.angular_velocity - turn_speed;
    float torque = -angular_mass * turning;
    if (springs) {
        torque =
            spring.impulse(angular_mass, turning, ends.angle_now(a, b) - angle, impulses.torque);
    }
    const float turned_by = clamp(impulses.torque + torque, -greatest_torque, greatest_torque);
    detail::twist(a, b, turned_by - impulses.torque);
    impulses.torque = turned_by;

    const V2 moving = ends.velocity(a, b) - turned(speed, a.turn);
    const PointMass mass = PointMass::make(ends, a, b);
    V2 total = impulses.force - mass * moving;
    if (springs) {
        const V2 error = gap - turned(offset, a.turn);
        total = (1.0f - spring.impulse_scale) * impulses.force -
                mass * (spring.mass_scale * moving + spring.push * error);
    }
    const float size = length(total);
    if (size > greatest_force) total = (greatest_force / size) * total;
    ends.push(a, b, total - impulses.force);
    impulses.force = total;
}

void MotorConstraint::solve(SolverBody& a, SolverBody& b, const JointStep&) {
    drive(a, b, springy);
}

void MotorConstraint::relax(SolverBody& a, SolverBody& b, const JointStep&) {
    if (springy) return;
    drive(a, b, false);
}

}  // namespace fettle::physics::detail
