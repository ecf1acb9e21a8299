#pragma once

#include <state/world_state.h>

namespace fettle::physics::detail {

/// The manifold of shapes that are not both plain convex. Most worlds have few such pairs. `held`:
/// they were in contact before.
void collide_unusual(const ObjectState& objects, const Columns& columns, const WorldDef& settings,
                     const ContactRecord& contact, float margin, bool held, Manifold& manifold);

}  // namespace fettle::physics::detail
