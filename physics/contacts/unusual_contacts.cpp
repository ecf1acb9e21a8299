// Manifolds of shapes that are not both plain convex.

#include <collision/collide_solids.h>
#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <contacts/border.h>
#include <contacts/narrow_phase.h>

namespace fettle::physics::detail {
namespace {

void collide_ellipse_half_plane(const BorderPlane& plane, const EllipseForm& ellipse, Vec2 center,
                                float margin, Manifold& m) {
    const Vec2 deepest = ellipse.support(-plane.normal);
    const float separation = dot(plane.normal, deepest + center) - plane.depth;
    m.count = 0;
    m.corner = 0.0f;
    if (separation > margin) return;
    m.normal = plane.normal;
    const Vec2 anchor = deepest - (0.5f * separation) * plane.normal;
    m.points[0] = {anchor + center, anchor, separation, 0.0f, 0.0f, 0};
    m.count = 1;
}

}  // namespace

void collide_unusual(const ObjectState& objects, const Columns& columns, const WorldDef& settings,
                     const ContactRecord& c, float margin, bool held, Manifold& m) {
    const Vec2 center_b = objects.bodies[c.body_b].center;
    const Solid b = solid_of(objects, columns, c.shape_b);
    if (objects.forms[c.shape_a].kind == FormKind::border) {  // the border is always shape a
        const BorderPlane plane = border_plane(*settings.bounds, c.shape_a);
        if (b.kind == FormKind::ellipse)
            collide_ellipse_half_plane(plane, ellipse_of(b.form), center_b, margin, m);
        else if (b.kind == FormKind::large)
            collide_large_half_plane(plane.normal, plane.depth, b, center_b, margin, m);
        else
            collide_half_plane(plane.normal, plane.depth, b.form, center_b, margin, m);
        return;
    }
    const Solid a = solid_of(objects, columns, c.shape_a);
    collide(a, b, center_b - objects.bodies[c.body_a].center, margin, held, m);
}

}  // namespace fettle::physics::detail
