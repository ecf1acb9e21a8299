#pragma once

#include <state/world_state.h>

// Which pairs of shapes may collide.

namespace fettle::physics::detail {

/// The filter that the user has set, if any.
struct UserFilter {
    const void* world = nullptr;
    bool (*agrees)(const void* world, uint32_t shape_a, uint32_t shape_b) = nullptr;

    explicit operator bool() const { return agrees != nullptr; }
    bool operator()(uint32_t a, uint32_t b) const { return !agrees || agrees(world, a, b); }
};

bool filters_agree(const ObjectState& objects, uint32_t shape_a, uint32_t shape_b);
/// A joint keeps its two bodies from colliding. Not with the world: the border belongs to it, and
/// what hangs in the world still collides with the border.
bool keeps_apart(const JointRecord& joint);
bool joint_forbids_contact(const ObjectState& objects, uint32_t body_a, uint32_t body_b);
bool may_collide(const ObjectState& objects, const UserFilter& filter, uint32_t shape_a,
                 uint32_t shape_b);

}  // namespace fettle::physics::detail
