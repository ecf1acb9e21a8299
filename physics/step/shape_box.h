#pragma once

#include <state/world_state.h>

#include <span>

namespace fettle::physics::detail {

/// The box of a shape at its pose. Unlike those of the broad phase, it is as precise as positions
/// are.
Aabb box_of_shape(const ObjectState& objects, const Columns& columns, std::span<const Box4> boxes,
                  uint32_t shape);

}  // namespace fettle::physics::detail
