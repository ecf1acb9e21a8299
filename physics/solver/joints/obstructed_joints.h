#pragma once

#include <solver/joints/joint_passes.h>

#include <cmath>

// Joints that push a body against something fixed: a player who reels in a hook below a roof, a
// crate whose winch goes on at a beam, a lift whose motor presses a crate against a ceiling. A
// contact yields in proportion to its load. The wider the gap of a joint, the harder it pulls, and
// a motor may have any strength: bodies were pressed into the obstacle, and through it. An obstacle
// does not yield, so the joint does: obstacles bear no more of its push than makes a contact yield
// by a small distance.

namespace fettle::physics::detail {

/// A joint pulls a body against an obstacle as for a gap of this width, m: with at most some 140
/// times the weight of its body, which sinks into the obstacle by about as much. One whose two ends
/// are held pulls with less under `soft_step`: `JointEnds::greatest_pull`.
inline constexpr float obstructed_gap = 0.01f;

/// True if a joint pulls one of its bodies so hard that an obstacle may be in its way.
inline bool may_be_obstructed(Vec2 force, const SolverBody& a, const SolverBody& b, float h) {
    constexpr float speed = 2.0f;  // m/s, of one sub-step
    const float change = h * max(a.inverse_mass, b.inverse_mass);
    return change * change * length_squared(force) > speed * speed;
}

/// True if a motor may push so hard. What is between it and the obstacle may be much lighter than
/// the bodies of its joint. A torque counts by the velocity at the radius of gyration.
inline bool may_press(const Drive& drive, const SolverBody& a, const SolverBody& b) {
    constexpr float speed = 0.02f;  // m/s, of one sub-step
    const auto mobility = [&](const SolverBody& body) {
        return body.inverse_mass * (drive.turns ? body.inverse_inertia : body.inverse_mass);
    };
    return drive.impulse * drive.impulse * max(mobility(a), mobility(b)) > speed * speed;
}

/// True if a rope pulls two bodies that move, and an obstacle may hold one of them.
inline bool may_be_held(const ObjectState& objects, const JointRecord& joint, const Pull& pull,
                        const SolverBody& a, const SolverBody& b) {
    const auto touches = [&](uint32_t body) {
        return objects.bodies[body].lists.first_contact != none;
    };
    return pull.only_pulls && a.inverse_mass > 0.0f && b.inverse_mass > 0.0f &&
           length_squared(joint.force) > 0.0f &&
           (touches(joint.bodies[0]) || touches(joint.bodies[1]));
}

/// Between a rope and an obstacle that moves, or that the rope is drawn to, there may be no
/// solution from the first step on: a ball on a lift would have to be beside its rope's hook at
/// once. Under `direct`, whose rows yield to nothing, that took forces without bound.
inline bool may_have_no_solution(const BodyScratch& bodies, Solver solver) {
    return solver == Solver::direct && bodies.driven;
}

/// Limits the gaps for which joints pull and the impulses of motors, if contacts with what is fixed
/// or kinematic bear most of them. The ends of the joints must be prepared.
/// Appends the bodies that are held between a joint and an obstacle to `strained`.
void yield_to_obstacles(const JointSource& source, const JointStep& step, JointScratch& joints,
                        Solver solver, std::vector<uint32_t>& strained);

}  // namespace fettle::physics::detail
