#pragma once

#include <state/world_state.h>

// Friction, restitution, rolling resistance and surface speed of a contact, from its two surfaces.

namespace fettle::physics::detail {

/// Mixes the surfaces of the two shapes of a contact.
void remix(const ObjectState& objects, const WorldDef& settings, ContactRecord& contact);
/// Mixes the surfaces of all contacts of a shape.
void remix_shape(ObjectState& objects, const WorldDef& settings, uint32_t shape);

}  // namespace fettle::physics::detail
