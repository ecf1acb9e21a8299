#pragma once

#include <constraints/joint_ends.h>
#include <state/joint_kind.h>

#include <span>
#include <vector>

// Bodies that are far from their joint.
//
// A contact turns a small body about its own center. But if a joint holds it at a lever r that is
// much longer than the body, it can hardly turn so: the other body would have to follow with the
// inertia μ·r², where μ is the reduced mass of both. One sweep over contacts and joints does not
// converge to that motion: a crate of 0.6 m that fell on a corner turned at 15 rad/s for a
// sub-step, which moved an anchor 30 m from it by 2 m, and the force of the joint, whose line had
// moved as far, turned it faster in the next one. So such a body turns as if its moment of inertia
// were at least μ·r²/100. The motion of both bodies together hardly changes, because it has about
// μ·r².
//
// Where a joint corrects the angle of such a body, what is far from it moves with the lever. So its
// speed has a limit, too.

namespace fettle::physics::detail {

/// How many times the inertia of a body may be less than that of what a joint holds at it.
constexpr float greatest_lever_ratio = 100.0f;

/// An angle is corrected more slowly if something is farther from the body than this, m.
constexpr float near_reach = 1.0f;

/// From the center of body a at the start of the step to the place where a joint pushes it.
/// `at_b`: that is the anchor of b, as for a joint on a rail.
inline Vec2 start_arm(const JointEnds& ends, bool at_b) {
    return at_b ? ends.apart + ends.start_b : ends.start_a;
}

/// True if a joint holds one of its bodies at a long lever.
inline bool has_long_lever(const JointEnds& ends, bool at_b, const SolverBody& a,
                           const SolverBody& b) {
    const float of_a = a.inverse_inertia * length_squared(start_arm(ends, at_b));
    const float of_b = b.inverse_inertia * length_squared(ends.start_b);
    return max(of_a, of_b) > greatest_lever_ratio * (a.inverse_mass + b.inverse_mass);
}

/// What the long levers of its joints ask of a body.
struct LeverNeeds {
    float inertia = 0.0f;  ///< at least, kg m²
    float reach = 0.0f;    ///< the longest lever, m
};

/// The needs of the solver's bodies.
std::vector<LeverNeeds> needs_of_levers(const JointSource& source, JointScratch& joints,
                                        std::span<const SolverBody> bodies);

}  // namespace fettle::physics::detail
