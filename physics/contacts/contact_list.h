#pragma once

#include <contacts/touching.h>
#include <state/world_state.h>

// The life of a contact: a pair of shapes is kept while their fat boxes overlap, and gets a
// manifold in each step in which one of the two bodies is awake.

namespace fettle::physics::detail {

/// What contacts are entered in.
struct ContactList {
    Touching touching;
    PairSet& pairs;
    ActiveLists& active;
};

void create_contact(const ContactList& list, const WorldDef& settings, uint32_t shape_a,
                    uint32_t shape_b);
void destroy_contact(const ContactList& list, uint32_t contact);
void destroy_contacts_of_shape(const ContactList& list, uint32_t shape);  ///< and of its parts
void destroy_contacts_of_body(const ContactList& list, uint32_t body);

/// Mixes the surfaces of the two shapes of a contact.
void remix(const ObjectState& objects, const WorldDef& settings, ContactRecord& contact);
void remix_shape(ObjectState& objects, const WorldDef& settings, uint32_t shape);

}  // namespace fettle::physics::detail
