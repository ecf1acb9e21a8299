#include <joints/mouse_joint.h>

// A soft point (C = p_b - p_a, both coordinates) whose impulse has a greatest length. It is a
// force, not a constraint: the relax pass leaves it alone. The levers stay those of the step's
// begin, which brakes the turning a little: what is dragged comes to hang still.

namespace fettle::physics::detail {

void MouseConstraint::prepare(const Data& data, const JointFrame&, const JointStep& step,
                              const SolverBody& a, const SolverBody& b) {
    greatest = data.max_force * step.h;
    softness = make_softness(data.hertz, data.damping_ratio, step.h);
    // A slack joint pulls nothing.
    if (data.hertz > 0.0f) mass = PointMass::make(ends, a, b);
}

void MouseConstraint::warm_start(SolverBody& a, SolverBody& b) const {
    ends.push(a, b, impulses.pull);
}

void MouseConstraint::solve(SolverBody& a, SolverBody& b, const JointStep&) {
    const V2 gap = ends.gap(a, b) + cross(b.turn, ends.lever_b);
    const V2 velocity = ends.velocity(a, b) + softness.bias_rate * gap;
    const V2 wanted = -softness.mass_scale * (mass * velocity);
    V2 total = impulses.pull + (wanted - softness.impulse_scale * impulses.pull);
    const float size = length(total);
    if (size > greatest) total = (greatest / size) * total;
    ends.push(a, b, total - impulses.pull);
    impulses.pull = total;
}

}  // namespace fettle::physics::detail
