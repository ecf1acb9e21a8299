#pragma once

#include <state/world_state.h>

// How hard the shapes of a contact meet.

namespace fettle::physics::detail {

/// Between the points of the manifold, world axes.
V2 middle_of(const ObjectState& objects, const ContactRecord& contact);

/// m/s. Until the poses are finished, the states hold the velocities before the step.
float approach_speed(const ObjectState& objects, const Columns& columns,
                     const ContactRecord& contact, V2 point);

/// Impulse per speed of approach: the effective mass along the normal, 1 / (n·M⁻¹·n), times one
/// plus the restitution.
float impact_mass(const ObjectState& objects, const ContactRecord& contact, V2 point);

}  // namespace fettle::physics::detail
