#pragma once

#include <constraints/stiffness.h>
#include <contacts/contact_list.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

// Contacts that are solved one at a time: if a body is locked along an axis, if surfaces roll, move
// or are curved, if they approach so fast that they bounce, or if no color was left. Constraints
// are written once per step in the order of their nodes, and their impulses are read back.
// Contacts that only pass an impact on have such constraints too, but their group solves them.

namespace fettle::physics::detail {

/// `ratio`: length of this sub-step divided by that of the last one; scales the impulses.
void prepare_serial(const ObjectState& objects, const Columns& columns, const BodyScratch& bodies,
                    ContactScratch& scratch, const ContactStiffness& stiffness, float dt,
                    float ratio, ThreadPool* threads);

/// Stores the impulses of the serial contacts, and reports hits and touches that begin or end.
/// (Impulses of wide contacts are stored when their block is solved.)
void store_contacts(ContactScratch& contacts, const Touching& touching, float hit_threshold,
                    ThreadPool* threads);

}  // namespace fettle::physics::detail
