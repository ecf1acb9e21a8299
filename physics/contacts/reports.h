#pragma once

#include <fettle/physics/contact.h>
#include <fettle/physics/events.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

#include <optional>

// What the user hears of contacts besides that they begin and end.

namespace fettle::physics::detail {

/// The contact as a hit, if it met faster than the threshold (m/s). `extra`: of a contact that has
/// one, else null. All of it is known without hit events too, so that asking for them changes
/// nothing.
std::optional<ContactHitEvent> hit_of(const ObjectState& objects, const Columns& columns,
                                      float threshold, uint32_t contact, const ContactExtra* extra);

/// Adds the hits of the wide contacts in `scratch.told`, in the order of the acting contacts.
void report_wide_hits(const ObjectState& objects, const Columns& columns, float threshold,
                      ContactScratch& scratch, ThreadPool* threads, Events& events);

/// Contacts that began to touch in an earlier step.
void report_persisting(const ObjectState& objects, const Columns& columns,
                       const ActiveLists& active, uint32_t step, int substeps, Events& events);

/// `substep`: the length of the last sub-step, s; 0: there was none.
Contact view_of(const ObjectState& objects, const Columns& columns, float substep,
                const ContactRecord& contact);

// How hard the shapes of a contact meet.

/// Between the points of the manifold, world axes.
V2 middle_of(const ObjectState& objects, const ContactRecord& contact);

/// m/s. Until the poses are finished, the states hold the velocities before the step.
float approach_speed(const ObjectState& objects, const Columns& columns,
                     const ContactRecord& contact, V2 point);

/// Impulse per speed of approach: the effective mass along the normal, 1 / (n·M⁻¹·n), times one
/// plus the restitution.
float impact_mass(const ObjectState& objects, const ContactRecord& contact, V2 point);

}  // namespace fettle::physics::detail
