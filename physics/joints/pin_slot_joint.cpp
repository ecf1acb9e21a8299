#include <joints/pin_slot_joint.h>

// `Rail` alone: across the slot the pin is held, along it spring, motor and limits act, and nothing
// is said about the angle. A groove is given by its two ends instead: the axis is the line between
// them and the limits are 0 and its length |end - begin|.

namespace fettle::physics::detail {

void PinSlotConstraint::prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                                const SolverBody& a, const SolverBody& b) {
    rail.prepare(data.rail, impulses.rail, ends, frame, step, a, b);
}

void GrooveConstraint::prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                               const SolverBody& a, const SolverBody& b) {
    const V2 run = data.end - frame.anchor_a;
    RailSettings settings;
    settings.lower = 0.0f;
    settings.upper = length(run);
    // Ends at the same point hold the pin there: any direction serves.
    if (settings.upper > 1e-6f) settings.axis = run;
    rail.prepare(settings, impulses.rail, ends, frame, step, a, b);
}

void PinSlotConstraint::warm_start(SolverBody& a, SolverBody& b) const {
    rail.push_both(impulses.rail, ends, a, b);
}

void PinSlotConstraint::solve(SolverBody& a, SolverBody& b, const JointStep& step) {
    rail.follow(ends, a, b);
    if (rail.acts_along()) rail.solve_along<true>(impulses.rail, ends, a, b, step);
    rail.solve_across<true>(impulses.rail, ends, a, b, step);
}

void PinSlotConstraint::relax(SolverBody& a, SolverBody& b, const JointStep& step) {
    rail.follow(ends, a, b);
    if (rail.driven || rail.limited) rail.solve_along<false>(impulses.rail, ends, a, b, step);
    rail.solve_across<false>(impulses.rail, ends, a, b, step);
}

}  // namespace fettle::physics::detail
