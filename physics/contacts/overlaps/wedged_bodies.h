#pragma once

#include <contacts/contact_list.h>

// Wedged bodies. If two bodies overlap so far that two of their contacts push in opposite
// directions, each contact pushes the bodies deeper into the other one. No velocity meets both.
// Each pass adds to the impulses of both, and they turn the bodies as soon as the two do not lie on
// one line: an ellipse in the opening of a U gained five times its energy in three steps. No load
// of a stack needs these impulses, since they act between the same two bodies. So the deeper one of
// the two contacts does not act while the other one opposes it, which pushes the bodies apart.
// Welded bodies count as one: a ball between two of them is wedged in the same way. No velocity
// meets a contact between two welded bodies either, so it does not act if it is deep.

namespace fettle::physics::detail {

/// True if a contact is deep enough to be compared with others, or was skipped in the last step.
inline bool may_be_wedged(const ContactRecord& c) {
    constexpr float least = -0.02f;  // m
    const Manifold& m = c.manifold;
    return m.points[0].separation < least || (m.count == 2 && m.points[1].separation < least) ||
           c.skipped == Skipped::wedged;
}

/// Skips the contact, or one that opposes it, if its two bodies are wedged; for this step.
void part_wedged(const Touching& touching, uint32_t contact);

/// True if two dynamic bodies are pressed into each other, also if the contact is skipped.
bool is_pressed(const ObjectState& objects, const ContactRecord& contact);

/// True if the contact acts, is deep, and rigid joints hold both bodies at something that does not
/// move. The joints and the contact may then press against each other: `find_jammed`.
bool is_pinned(const ObjectState& objects, const ContactRecord& contact);

}  // namespace fettle::physics::detail
