#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

namespace fettle::physics::detail {

/// Writes the awake bodies into the arrays of the solver, with what gravity and their forces do to
/// them in a sub-step of length `h`, and finds the hubs among them.
void gather_bodies(const ObjectState& objects, Columns& columns, const ActiveLists& active,
                   const WorldDef& settings, const Strips& strips, float h, BodyScratch& bodies,
                   Hubs& hubs, ThreadPool* threads);

}  // namespace fettle::physics::detail
