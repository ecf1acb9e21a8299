#pragma once

#include <fettle/physics/events.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

#include <optional>

// Hits: touching contacts that met faster than the threshold, with their impulse.

namespace fettle::physics::detail {

/// `threshold`: m/s; `extra`: of a contact that has one, else null. It follows from what the step
/// knows without hit events, so that asking for them changes nothing.
std::optional<ContactHitEvent> hit_of(const ObjectState& objects, const Columns& columns,
                                      float threshold, uint32_t contact, const ContactExtra* extra);

/// Of the wide contacts in `scratch.told`, in the order of the acting contacts.
void report_wide_hits(const ObjectState& objects, const Columns& columns, float threshold,
                      ContactScratch& scratch, ThreadPool* threads, Events& events);

}  // namespace fettle::physics::detail
