#pragma once

#include <state/world_state.h>

// Which bodies many joints may crowd: solver/joints/crowded_joints.h. What decides about it changes
// by edits only, so a step computes nothing for the other bodies.

namespace fettle::physics::detail {

/// Bodies whose joints have a lower strength are not crowded. A node of a grid has 2.
inline constexpr float least_strength = 2.5f, strength_of_grid = 2.0f;
/// Bodies with fewer joints are not crowded.
inline constexpr uint32_t least_crowding = 3;

/// Whether the strength of the joints of a body may exceed `least_strength` in some pose of the
/// bodies. It depends on the joints, and on the masses of all their bodies.
bool may_be_crowded(const ObjectState& objects, uint32_t body);

}  // namespace fettle::physics::detail
