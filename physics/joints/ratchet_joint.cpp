#include <joints/ratchet_joint.h>

#include <cmath>

// With θ = ±(θ_b - θ_a - reference), positive the way that is free, a pawl falls behind every tooth
// that passes: caught = tooth·⌊θ/tooth⌋, and never less than it was; a tooth of 0 is a continuous
// ratchet, caught = θ. From there on θ - caught >= 0 is a limit that only pushes one way, with the
// effective mass 1/(I_a⁻¹ + I_b⁻¹). Where the pawl is, is part of the state.

namespace fettle::physics::detail {

void RatchetConstraint::prepare(const Data& data, const JointFrame&, const JointStep&,
                                const SolverBody& a, const SolverBody& b) {
    way = data.backwards ? -1.0f : 1.0f;
    reference = data.reference_angle;
    mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
    const float angle = way * (ends.angle - reference);
    float tooth = angle;
    if (data.tooth > 0.0f) {
        // Lying at a tooth, it may be pressed under it a little by what it holds.
        const float slack = min(0.01f, 0.1f * data.tooth);
        const float passed = data.tooth * std::floor((angle + slack) / data.tooth);
        // Teeth too small to be counted are as good as none.
        if (std::isfinite(passed)) tooth = passed;
    }
    if (!impulses.engaged || tooth > impulses.caught) impulses.caught = tooth;
    impulses.engaged = true;
}

template <bool biased>
void RatchetConstraint::hold(SolverBody& a, SolverBody& b, const JointStep& step) {
    const float room = way * (ends.angle_now(a, b) - reference) - impulses.caught;
    const float velocity = way * (b.angular_velocity - a.angular_velocity);
    const float change = push_limit<biased>(impulses.pawl, mass, velocity, room, step);
    detail::twist(a, b, way * change);
}

template void RatchetConstraint::hold<true>(SolverBody&, SolverBody&, const JointStep&);
template void RatchetConstraint::hold<false>(SolverBody&, SolverBody&, const JointStep&);

}  // namespace fettle::physics::detail
