#pragma once

#include <solver/joint_passes.h>

// Rods, ropes, pulleys and the ends of slides that pull a body against something fixed: a player
// who reels in a hook below a roof, a crate whose winch goes on at a beam. The wider the gap of the
// joint, the harder it pulls, and a contact yields in proportion to its load: from some
// centimeters on the body was pulled into the obstacle, and through it. An obstacle does not
// yield, so the joint does: it pulls as for a small gap, as long as contacts bear its pull.

namespace fettle::physics::detail {

/// True if a joint pulls one of its bodies so hard that an obstacle may be in its way.
inline bool may_be_obstructed(Vec2 force, const SolverBody& a, const SolverBody& b, float h) {
    constexpr float speed = 2.0f;  // m/s, of one sub-step
    const float change = h * max(a.inverse_mass, b.inverse_mass);
    return change * change * length_squared(force) > speed * speed;
}

/// Limits the gap for which a joint pulls, if contacts with what is fixed or kinematic bear most of
/// its pull. The ends of the joints must be prepared.
void yield_to_obstacles(const JointSource& source, const JointStep& step, JointScratch& joints);

}  // namespace fettle::physics::detail
