#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>

// Decides which contacts are solved one at a time because of possible or actual motions of their
// bodies.

namespace fettle::physics::detail {

/// True if one of the bodies is locked along an axis. Most worlds have no such body: then no record
/// is read.
inline bool on_locked_axis(const ObjectState& objects, const BodyScratch& bodies,
                           const ContactRecord& contact) {
    if (!bodies.axes_locked) return false;
    const BodyRecord &a = objects.bodies[contact.body_a], &b = objects.bodies[contact.body_b];
    return a.flags.locked_x || a.flags.locked_y || b.flags.locked_x || b.flags.locked_y;
}

/// The path of the cores around a corner.
Corner corner_of(const ObjectState& objects, const ContactRecord& contact);

/// True if the contact passes a corner so fast that its path bends noticeably within the step.
/// False for two circles, which meet in slow heaps, and for corners without rounding, which have no
/// path around them.
bool passes_corner(const ObjectState& objects, const BodyScratch& bodies,
                   const ContactRecord& contact, float dt);

}  // namespace fettle::physics::detail
