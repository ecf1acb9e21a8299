#include <world/world_data.h>

// Contacts of shapes that are not plain convex forms. Few pairs of most worlds: the narrow phase
// asks once whether it has to come here.

namespace fettle::physics::detail {

void WorldData::collide_unusual(const ContactRecord& c, float margin, Manifold& m) const {
    // Of a pair, the border is always the first.
    const BorderPlane plane = border_plane(c.shape_a);
    collide_half_plane(plane.normal, plane.depth, convex(c.shape_b), bodies[c.body_b].center,
                       margin, m);
}

}  // namespace fettle::physics::detail
