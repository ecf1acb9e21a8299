#include <joints/gear_joint.h>

//     C = θ_b - ratio·θ_a - phase,   Ċ = ω_b - ratio·ω_a,   K = I_b⁻¹ + ratio²·I_a⁻¹
//
// The ratio of two wheels that mesh is -r_a/r_b; of two that a belt joins, r_a/r_b. An impulse
// turns b by λ and a by -ratio·λ, and so is not equal and opposite: the axles take the rest, as in
// a gear box. Angles count from the world and over any number of turns: from the states, not from
// their small difference.

namespace fettle::physics::detail {

void GearConstraint::prepare(const Data& data, const JointFrame& frame, const JointStep&,
                             const SolverBody& a, const SolverBody& b) {
    ratio = data.ratio;
    mass = inverse_or_zero(b.inverse_inertia + ratio * ratio * a.inverse_inertia);
    start = float(frame.angle_b - double(ratio) * frame.angle_a - double(data.phase));
}

void GearConstraint::mesh(SolverBody& a, SolverBody& b, float p) const {
    a.angular_velocity -= a.inverse_inertia * ratio * p;
    b.angular_velocity += b.inverse_inertia * p;
}

template <bool biased>
void GearConstraint::hold(SolverBody& a, SolverBody& b, const JointStep& step) {
    const float error = start + (b.turn - ratio * a.turn);
    const float velocity = b.angular_velocity - ratio * a.angular_velocity;
    mesh(a, b, push_rigid<biased>(impulses.angle, mass, velocity, error, step));
}

void GearConstraint::solve(SolverBody& a, SolverBody& b, const JointStep& step) {
    hold<true>(a, b, step);
}

void GearConstraint::relax(SolverBody& a, SolverBody& b, const JointStep& step) {
    hold<false>(a, b, step);
}

}  // namespace fettle::physics::detail
