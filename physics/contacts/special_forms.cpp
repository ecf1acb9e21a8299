// Manifolds of shapes that are not both plain convex.

#include <collision/collide_solids.h>
#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <contacts/border.h>
#include <contacts/narrow_phase.h>

namespace fettle::physics::detail {
namespace {

struct HalfPlane {
    Vec2 normal;
    float depth = 0.0f;
};
/// A half-plane and the center of a body, both relative to the same origin.
struct BesideHalfPlane {
    HalfPlane plane;
    Vec2 center;
};

/// The half-plane relative to the origin of the world; in double precision, relative to the center
/// of the body.
BesideHalfPlane relative_to(const BorderPlane& border, const Position& center) {
    if (double_positions)
        return {{border.normal, float(border.depth - dot(border.normal, center))}, {}};
    return {{border.normal, float(border.depth)}, Vec2(center)};
}

void collide_ellipse_half_plane(const HalfPlane& plane, const EllipseForm& ellipse, Vec2 center,
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

void collide_special_forms(const ObjectState& objects, const Columns& columns,
                           const WorldDef& settings, const ContactRecord& c, float margin,
                           bool had_contact, Manifold& m) {
    const Solid b = solid_of(objects, columns, c.shape_b);
    if (objects.forms[c.shape_a].kind == FormKind::border) {  // the border is always shape a
        const BorderPlane border = border_plane(*settings.bounds, c.shape_a);
        const auto [plane, center_b] = relative_to(border, objects.bodies[c.body_b].center);
        if (b.kind == FormKind::ellipse)
            collide_ellipse_half_plane(plane, ellipse_of(b.form), center_b, margin, m);
        else if (b.kind == FormKind::large)
            collide_large_half_plane(plane.normal, plane.depth, b, center_b, margin, m);
        else
            collide_half_plane(plane.normal, plane.depth, b.form, center_b, margin, m);
        return;
    }
    const Solid a = solid_of(objects, columns, c.shape_a);
    collide(a, b, objects.bodies[c.body_b].center - objects.bodies[c.body_a].center, margin,
            had_contact, m);
}

}  // namespace fettle::physics::detail
