#pragma once

#include <state/world_state.h>

// What the rules about bodies that overlap read of a contact.

namespace fettle::physics::detail {

/// How deep the shapes are in each other, m; negative if they are apart. The manifold must have
/// points.
inline float overlap_of(const Manifold& m) {
    const float first = m.points[0].separation;
    return -(m.count == 2 ? min(first, m.points[1].separation) : first);
}

/// The normal of the contact, towards `body`.
inline Vec2 normal_towards(uint32_t body, const ContactRecord& c) {
    return body == c.body_b ? c.manifold.normal : -c.manifold.normal;
}

}  // namespace fettle::physics::detail
