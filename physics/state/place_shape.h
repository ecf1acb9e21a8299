#pragma once

#include <state/world_state.h>

#include <span>

namespace fettle::physics::detail {

/// After an edit of the shape or its body: computes all that depends on the geometry and the pose.
/// `q` and `angle`: of the body.
void place_shape(ObjectState& objects, std::span<Box4> boxes, uint32_t shape, Rotation q,
                 float angle);

/// After a motion of the body: writes the rotated vertices of the shape, relative to the center of
/// mass of its body, and its box.
void move_shape(ObjectState& objects, std::span<Box4> boxes, uint32_t shape, Rotation q,
                float angle);

/// The radius of the largest circle about the centroid of the shape that is inside the shape, m. 0:
/// a segment without rounding, or a piece of a chain.
float inner_radius(const ObjectState& objects, uint32_t shape);

/// The fat box of a moving shape is larger than its box by this, m.
float fat_margin(const Box4& box);

}  // namespace fettle::physics::detail
