#pragma once

#include <contacts/contact_list.h>
#include <fettle/physics/contact.h>
#include <fettle/physics/events.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

#include <optional>

// Reports on contacts to the user, other than begin and end of touches.

namespace fettle::physics::detail {

/// The hit event of the contact if the approach was faster than the threshold (m/s). `extra`: data
/// of special contacts, otherwise null. All input also exists without hit events, so requesting
/// them does not change the simulation.
std::optional<ContactHitEvent> hit_of(const Touching& touching, float threshold, uint32_t contact,
                                      const ContactExtra* extra);

/// Adds the hits of the wide contacts in `scratch.reported`, in the order of the acting contacts.
void report_wide_hits(const Touching& touching, float threshold, ContactScratch& scratch,
                      ThreadPool* threads);

/// Reports contacts that began to touch in an earlier step.
void report_persisting(const ObjectState& objects, const Columns& columns,
                       const ActiveLists& active, uint32_t step, int substeps, Events& events);

/// The contact for the user. `substep`: length of the last sub-step, s; 0: there was none.
Contact view_of(const ObjectState& objects, const Columns& columns, float substep,
                const ContactRecord& contact);

// Point, speed and effective mass of an impact.

/// Middle of the points of the manifold, world axes.
Position middle_of(const ObjectState& objects, const ContactRecord& contact);

/// Separation of the nearest point of a manifold, m.
float nearest_separation(const Manifold& manifold);

/// Speed along the normal, m/s. Until the poses are finished, the states contain the velocities
/// before the step.
float approach_speed(const ObjectState& objects, const Columns& columns,
                     const ContactRecord& contact, const Position& point);

/// The same when the shapes meet there: until then, forces act on them over this separation, m. To
/// be called after the solver.
float meeting_speed(const Touching& touching, const ContactRecord& contact, const Position& point,
                    float separation);

/// The impulse that ends the approach of the points that meet; with the restitution, if they
/// approach faster than the threshold.
float impact_impulse(const Touching& touching, const ContactRecord& contact);

}  // namespace fettle::physics::detail
