#pragma once

#include <fettle/physics/events.h>
#include <state/world_state.h>

#include <vector>

// When shapes begin and end to touch, and the events of it. A chain or a concave polygon touches as
// one: a shape that goes on from one of its parts to the next neither leaves nor arrives.

namespace fettle::physics::detail {

/// What a touch that begins or ends changes, and where its events go.
struct Touching {
    ObjectState& objects;
    const Columns& columns;
    Events& events;  ///< of the step, or of the edits since
    /// Touches of an outline's parts that ended in this step; null between steps, when the event of
    /// an end does not wait for the touch of another part.
    std::vector<ContactRecord>* parted;
    uint32_t step;  ///< the last digits of its number
};

void set_touching(const Touching& touching, uint32_t contact, bool begins);
/// The touches of outlines that ended in this step without going on to another part.
void report_parted(const Touching& touching);

/// A part of an outline is one of the two shapes.
bool is_of_outline(const ObjectState& objects, const ContactRecord& contact);
/// True for one of the touching contacts of two shapes, however many of their parts touch.
bool reports_for_pair(const ObjectState& objects, uint32_t contact);

}  // namespace fettle::physics::detail
