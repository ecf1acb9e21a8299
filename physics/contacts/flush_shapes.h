#pragma once

#include <contacts/narrow_phase.h>

// A shape that touches several shapes that lie flush beside each other is pushed by their common
// outline: collision/covered_outline.h.

namespace fettle::physics::detail {

/// True if one of the two bodies moves among several shapes, and the other one rests or is driven.
inline bool may_be_flush(const ObjectState& objects, const ContactRecord& c) {
    const BodyRecord &a = objects.bodies[c.body_a], &b = objects.bodies[c.body_b];
    const bool moves_a = a.mobility == Mobility::dynamic, moves_b = b.mobility == Mobility::dynamic;
    if (moves_a == moves_b || c.sensor) return false;
    return (moves_a ? a : b).lists.contact_count > 1;
}

/// Corrects the manifold of such a contact if other shapes lie flush beside the one that rests.
/// `before`: the points of the last step. Reads the forms and pairs of the shapes only, so the
/// order of the contacts does not matter.
void push_with_common_outline(const NarrowPhaseInput& in, uint32_t slot, const OldPoints& before);

/// After such a contact begins: manifolds of shapes beside it are not kept, since it may cover
/// them.
void drop_kept_beside(const NarrowPhaseInput& in, uint32_t slot);

}  // namespace fettle::physics::detail
