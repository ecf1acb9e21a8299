#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>

namespace fettle::physics::detail {

/// Holds the bodies that have sunk deep into something fixed where they are. Must be called between
/// the solver and `finish_bodies`.
void hold_sunk(const ObjectState& objects, const Columns& columns, const WorldDef& settings,
               const ContactScratch& contacts, BodyScratch& bodies);

}  // namespace fettle::physics::detail
