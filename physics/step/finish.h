#pragma once

#include <contacts/contact_list.h>
#include <sleep/sleep.h>
#include <state/limits.h>
#include <state/step_scratch.h>
#include <state/velocity_sums.h>
#include <state/world_state.h>
#include <threads/pool.h>

// The stages after the solver: poses, rotated vertices, boxes, and moving fast bodies back to their
// first hit. Each piece of the bodies has lists of remaining work, which are then processed in the
// order of the pieces.

namespace fettle::physics::detail {

struct FinishInput {
    ObjectState& objects;
    Columns& columns;
    BroadPhaseState& boxes;
    const ActiveLists& active;
    const WorldDef& settings;
    const BodyScratch& bodies;
    int substeps;  ///< of this step
    FinishScratch& scratch;
    PairScratch& pairs;  ///< contains the pairs that end
    ContactList list;
    Activity activity;
    Events& later;  ///< events of the next step
    UserFilter filter;
    UserDecision decision;  ///< about contacts that begin within the step
    bool skips;             ///< contacts that touch may not act: callbacks, crushed bodies
    StepStatistics& statistics;
    ThreadPool* threads;
    std::span<VelocitySums> sums;  ///< for accounts
};

/// Returns the number of bodies that have rested long enough to sleep.
uint32_t finish_bodies(const FinishInput& input, float dt);

// Parts of `finish_bodies`.

/// The motion of a body of the solver in this step.
inline Vec2 shift_of(const SolverBody& b) {
    return {bounded(b.shift.x, 1e6f), bounded(b.shift.y, 1e6f)};
}
inline float turn_of(const SolverBody& b) {
    return bounded(b.turn, 1e3f);
}
/// A motion through the whole step, to a center of mass and the pose of the vertices.
inline Motion motion_to(const Position& center, Vec2 shift, float turn) {
    return {.from = center - shift, .velocity = shift, .angle = -turn, .turn = turn};
}
/// A body that moves less cannot move past the range of a speculative contact, nor with more than
/// half of its thickness through a thin obstacle. A body that is thinner than this range, and is
/// pressed against a surface, would still get behind it in a few slow steps: its contact pushes one
/// end and then the other, and the middle moves on.
inline float near_motion(const BodyRecord& body) {
    if (body.thickness < speculative_margin) return max(0.05f * body.thickness, 0.0002f);
    return max(0.5f * body.thickness, speculative_margin);
}

/// The greatest way of a point of a body with this motion, beyond what its thickness bears, m.
inline float way_of(const BodyRecord& body, Vec2 shift, float turn) {
    return length(shift) + std::fabs(turn) * (body.extent - body.thickness);
}
inline float way_of(const BodyRecord& body, const Motion& motion) {
    return way_of(body, motion.velocity, motion.turn);
}
/// Less relative motion brings no body to an obstacle with which it had no contact.
inline float least_hit_motion(const BodyRecord& body) {
    return min(near_motion(body), speculative_margin);
}
/// A kinematic body that moves less than this is not compared with bodies that are not fast.
inline float least_driven_motion(const BodyRecord& kinematic) {
    return min(near_motion(kinematic), 0.5f * speculative_margin);
}

/// Places the shapes of a body, and gives new fat boxes to shapes that left theirs.
void finish_shapes(const FinishInput& input, uint32_t body, Rotation q, FinishedPiece& piece);
/// Updates the trees and lists after one body was placed.
void follow_placed(const FinishInput& input, const FinishedPiece& piece);

// continuous_collision.cpp

/// Lists the awake kinematic bodies. Must be called before bodies are finished.
void list_driven_bodies(const FinishInput& input);
/// Processes a body that moved far compared with its thickness. Any thread may stop it at fixed
/// shapes. It waits if it may meet moving bodies or sensors, or if the user's filter must be
/// called.
void stop_or_list(const FinishInput& input, uint32_t body, Vec2 shift, float turn,
                  FinishedPiece& piece);
/// Processes the bodies that had to wait until the others are finished.
void stop_fast_bodies(const FinishInput& input);

}  // namespace fettle::physics::detail
