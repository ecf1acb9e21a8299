#pragma once

#include <state/world_state.h>

namespace fettle::physics::detail {

/// What a joint does in a step: `acting` on a dynamic body that is awake, or `asleep`, when it
/// keeps its impulses until a body wakes, or `idle`, when it has none.
enum class JointRole { idle, asleep, acting };
JointRole role_of(const ObjectState& objects, const JointRecord& joint);

void forget_impulses(ObjectState& objects, uint32_t joint);

}  // namespace fettle::physics::detail
