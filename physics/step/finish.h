#pragma once

#include <contacts/contact_list.h>
#include <state/step_scratch.h>
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
    FinishScratch& scratch;
    PairScratch& pairs;  ///< contains the pairs that end
    ContactList list;
    UserFilter filter;
    bool callbacks;  ///< the user has callbacks that may disable contacts
    StepStatistics& statistics;
    ThreadPool* threads;
};

/// Returns the number of bodies that have rested long enough to sleep.
uint32_t finish_bodies(const FinishInput& input, float dt);

// Parts of `finish_bodies`.

/// Stops the bodies that have to wait until the others are finished.
void stop_fast_bodies(const FinishInput& input);
/// Places the shapes of a body, and gives new fat boxes to shapes that left theirs.
void finish_shapes(const FinishInput& input, uint32_t body, Rotation q, FinishedPiece& piece);
/// Processes a body that moved far compared with its thickness. Most bodies are stopped by fixed
/// shapes only, so any thread may compute the result. A body waits if it may hit a bullet or if the
/// user's filter must be called.
void stop_or_list(const FinishInput& input, const FastBody& fast, FinishedPiece& piece);

}  // namespace fettle::physics::detail
