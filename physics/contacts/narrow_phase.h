#pragma once

#include <contacts/contact_list.h>
#include <sleep/sleep.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>
#include <wide/kernels.h>

// Computes the manifold of every awake contact in this step. Pairs of triangles and quadrilaterals
// are collected and collided sixteen at a time, the others one by one. Both write only the
// manifold, and list the pair if it needs more work. Then the listed pairs are processed in the
// order of the contacts: touches end, pairs end, and sleeping bodies that are about to be hit wake.

namespace fettle::physics::detail {

struct NarrowPhaseInput {
    ObjectState& objects;
    const Columns& columns;
    BroadPhaseState& boxes;
    ActiveLists& active;
    const WorldDef& settings;
    PairScratch& scratch;
    ContactList list;
    Activity activity;
    const WideKernels& kernels;
    ThreadPool* threads;
};

/// Also creates contacts of the new pairs.
void narrow_phase(const NarrowPhaseInput& input);

/// Computes the manifold of one contact. Points with the same features keep their impulses.
void update_manifold(const ObjectState& objects, const Columns& columns, const WorldDef& settings,
                     ContactRecord& contact);

/// Destroys the contacts of the pairs that ended in the narrow phase. They have no manifold, and no
/// stage in between reads them.
void end_pairs(const ContactList& list, PairScratch& scratch);

/// Computes the manifold of shapes that are not both plain convex. Most worlds have few such pairs.
/// `had_contact`: they were in contact before.
void collide_special_forms(const ObjectState& objects, const Columns& columns,
                           const WorldDef& settings, const ContactRecord& contact, float margin,
                           bool had_contact, Manifold& manifold);

}  // namespace fettle::physics::detail
