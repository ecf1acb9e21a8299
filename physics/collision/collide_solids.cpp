#include <collision/collide_solids.h>
#include <collision/ellipse.h>
#include <collision/extreme_points.h>
#include <collision/large_polygon.h>
#include <collision/outline_piece.h>
#include <collision/turned_copy.h>

#include <utility>

namespace fettle::physics::detail {

void swap_shapes(Manifold& m) {
    m.normal = -m.normal;
    for (int k = 0; k < m.count; ++k) {
        ManifoldPoint& p = m.points[k];
        std::swap(p.anchor_a, p.anchor_b);
        p.feature = uint16_t(p.feature << 8 | p.feature >> 8);
    }
}

namespace {

void collide_ellipse(const Solid& ellipse, const Solid& other, Vec2 offset, float margin,
                     Manifold& m) {
    const EllipseForm form = ellipse_of(ellipse.form);
    const bool both = other.kind == FormKind::ellipse;
    const EllipseGap gap = both ? gap_between(form, ellipse_of(other.form), offset)
                                : gap_between(form, other.form, offset);
    m.count = 0;
    m.corner = 0.0f;
    const float radius = both ? 0.0f : other.form.radius;
    const float separation = gap.separation - radius;
    if (separation > margin) return;
    const int feature = gap.edge >= 0 ? gap.edge : 128 + (gap.vertex & 127);
    m.set_point(gap.normal, gap.on_ellipse + (0.5f * separation) * gap.normal, offset, separation,
                uint32_t(feature & 255));
}

/// Collides two shapes if one is an ellipse or a piece.
void collide_mixed(const Solid& a, const Solid& b, Vec2 offset, float margin, bool had_contact,
                   Manifold& m) {
    if (a.kind == FormKind::piece) {
        collide_piece(a, b, offset, margin, had_contact, m);
    } else if (b.kind == FormKind::piece) {
        collide_piece(b, a, -offset, margin, had_contact, m);
        swap_shapes(m);
    } else if (a.kind == FormKind::ellipse) {
        collide_ellipse(a, b, offset, margin, m);
    } else {
        collide_ellipse(b, a, -offset, margin, m);
        swap_shapes(m);
    }
}

/// Like `collide_mixed`, but the other shape is a large polygon. Computed in the frame of its
/// vertices.
void collide_mixed_with_large(const Solid& a, const Solid& b, Vec2 offset, float margin,
                              bool had_contact, Manifold& m) {
    const bool large_a = a.kind == FormKind::large;
    const Solid& large = large_a ? a : b;
    const Rotation q = large.rotation;
    TurnedCopy turned(large_a ? b : a);
    const Solid plain = {large.form}, &other = turned.by({q.c, -q.s});
    collide_mixed(large_a ? plain : other, large_a ? other : plain, unrotate(q, offset), margin,
                  had_contact, m);
    m.normal = rotate(q, m.normal);
    for (int k = 0; k < m.count; ++k) {
        m.points[k].anchor_a = rotate(q, m.points[k].anchor_a);
        m.points[k].anchor_b = rotate(q, m.points[k].anchor_b);
    }
}

}  // namespace

void collide(const Solid& a, const Solid& b, Vec2 offset, float margin, bool had_contact,
             Manifold& m) {
    const auto is_plain = [](const Solid& s) {
        return s.kind == FormKind::convex || s.kind == FormKind::large;
    };
    const bool large = a.kind == FormKind::large || b.kind == FormKind::large;
    if (is_plain(a) && is_plain(b)) {
        if (large)
            collide_large(a, b, offset, margin, m);
        else
            collide(a.form, b.form, offset, margin, m);
        return;
    }
    if (large)
        collide_mixed_with_large(a, b, offset, margin, had_contact, m);
    else
        collide_mixed(a, b, offset, margin, had_contact, m);
}

void collide_on_side(const Solid& segment, const Solid& other, Vec2 side, Vec2 offset, float margin,
                     Manifold& m) {
    const Convex& form = segment.form;
    const int first = dot(form.normals[0], side) >= 0.0f ? 0 : 1;
    const Vec2 normal = form.normals[first];
    // The surface on this side, as a segment of a chain with free ends.
    const Vec2 out = form.radius * normal;
    const Vec2 vertices[] = {form.vertices[first] + out, form.vertices[1 - first] + out};
    const Vec2 normals[] = {normal, -normal};
    const float offsets[] = {dot(normal, vertices[0]), -dot(normal, vertices[0])};
    const Vec2 limits[] = {{}, normal, normal, {}};
    Solid sheet;
    sheet.form = {vertices, normals, offsets, 2, 0.0f};
    sheet.kind = FormKind::piece;
    sheet.limits = limits;
    sheet.normals = normals;
    collide(sheet, other, offset, margin, true, m);
}

}  // namespace fettle::physics::detail
