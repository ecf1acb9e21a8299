#include <joints/pulley_joint.h>

// With l the distance from a wheel g to its anchor p and u = (p - g)/l, the rope only pulls:
//
//     room = length - l_a - ratio·l_b >= 0,   d(room)/dt = -u_a·ṗ_a - ratio·u_b·ṗ_b,
//     K = k_a + ratio²·k_b,   k = uᵀM⁻¹u + I⁻¹(r×u)².
//
// A tension λ pulls a by -λu_a and b by -ratio·λu_b: a block and tackle of `ratio` parts at b.

namespace fettle::physics::detail {
namespace {

void follow_side(PulleyConstraint::Side& side, V2 lever, const SolverBody& body) {
    const V2 rope = side.start + body.shift + lever;
    side.length = length(rope);
    // An anchor at its wheel hangs from the direction it came from, or pulls nothing.
    if (side.length > 1e-6f) side.direction = (1.0f / side.length) * rope;
    side.lever = cross(lever, side.direction);
}

float inverse_of(const PulleyConstraint::Side& side, V2 inverse_mass, const SolverBody& body) {
    return dot(side.direction, scaled(inverse_mass, side.direction)) +
           body.inverse_inertia * side.lever * side.lever;
}

void pull_side(const PulleyConstraint::Side& side, V2 inverse_mass, SolverBody& body, float p) {
    body.velocity = body.velocity - p * scaled(inverse_mass, side.direction);
    body.angular_velocity -= body.inverse_inertia * side.lever * p;
}

float lengthening(const PulleyConstraint::Side& side, const SolverBody& body) {
    return dot(side.direction, body.velocity) + side.lever * body.angular_velocity;
}

}  // namespace

void PulleyConstraint::prepare(const Data& data, const JointFrame& frame, const JointStep&,
                               const SolverBody& a, const SolverBody& b) {
    ratio = data.ratio;
    length = data.length;
    side_a.start = frame.center_a - data.ground_a;
    side_b.start = frame.center_b - data.ground_b;
    follow(a, b);
}

void PulleyConstraint::follow(const SolverBody& a, const SolverBody& b) {
    ends.follow(a, b);
    follow_side(side_a, ends.lever_a, a);
    follow_side(side_b, ends.lever_b, b);
    mass = inverse_or_zero(inverse_of(side_a, ends.inverse_a, a) +
                           ratio * ratio * inverse_of(side_b, ends.inverse_b, b));
}

void PulleyConstraint::pull(SolverBody& a, SolverBody& b, float tension) const {
    pull_side(side_a, ends.inverse_a, a, tension);
    pull_side(side_b, ends.inverse_b, b, ratio * tension);
}

template <bool biased>
void PulleyConstraint::hold(SolverBody& a, SolverBody& b, const JointStep& step) {
    follow(a, b);
    const float room = length - side_a.length - ratio * side_b.length;
    const float velocity = -lengthening(side_a, a) - ratio * lengthening(side_b, b);
    pull(a, b, push_limit<biased>(impulses.tension, mass, velocity, room, step));
}

template void PulleyConstraint::hold<true>(SolverBody&, SolverBody&, const JointStep&);
template void PulleyConstraint::hold<false>(SolverBody&, SolverBody&, const JointStep&);

}  // namespace fettle::physics::detail
