#include <collision/clip.h>
#include <collision/large_polygon.h>

#include <utility>

namespace fettle::physics::detail {
namespace {

/// A convex polygon or circle in world axes; its vertices may be rotated or not.
class TurnedFacets {
  public:
    explicit TurnedFacets(const Solid& solid)
        : form_(solid.form), q_(solid.kind == FormKind::large ? solid.rotation : Rotation{}) {}

    int count() const { return form_.count; }
    float radius() const { return form_.radius; }
    float offset(int edge) const { return form_.offsets[edge]; }
    Vec2 vertex(int i) const { return rotate(q_, form_.vertices[i]); }
    Vec2 normal(int i) const { return rotate(q_, form_.normals[i]); }
    int next(int i) const { return i + 1 < form_.count ? i + 1 : 0; }
    int previous(int i) const { return i > 0 ? i - 1 : form_.count - 1; }
    int farthest(Vec2 direction) const { return farthest_vertex(form_, unrotate(q_, direction)); }
    Vec2 middle() const { return 0.5f * (vertex(0) + vertex(form_.count / 2)); }

    /// One edge of the polygon, as a segment.
    struct Excerpt {
        Vec2 vertices[2], normals[2];
        float offsets[2];
        Convex form;
        Excerpt(const TurnedFacets& from, int edge)
            : vertices{from.vertex(edge), from.vertex(from.next(edge))},
              normals{from.normal(edge), -from.normal(edge)},
              offsets{from.offset(edge), -from.offset(edge)},
              form{vertices, normals, offsets, 2, from.radius()} {}
        Excerpt(const Excerpt&) = delete;
        Excerpt& operator=(const Excerpt&) = delete;
    };

  private:
    const Convex& form_;
    Rotation q_;
};

EdgeGap deepest_edge_between(const TurnedFacets& a, const TurnedFacets& b, Vec2 offset) {
    return deepest_edge(a, b.middle() + offset,
                        [&](Vec2 n) { return dot(n, b.vertex(b.farthest(-n)) + offset); });
}

void set_point(Vec2 p, Vec2 q, Vec2 normal, float distance, float radius_a, float radius_b,
               Vec2 offset, float margin, Manifold& m) {
    const float separation = distance - radius_a - radius_b;
    if (separation > margin) return;
    const Vec2 middle = 0.5f * (p + radius_a * normal + q - radius_b * normal);
    m.set_point(normal, middle, offset, separation, 0);
}

void collide_circle(const TurnedFacets& a, Vec2 center, float radius, Vec2 offset, float margin,
                    Manifold& m) {
    const EdgeGap axis = deepest_edge(a, center, [&](Vec2 n) { return dot(n, center); });
    if (axis.separation > a.radius() + radius + margin) return;
    const Vec2 n = a.normal(axis.edge);
    const Vec2 v1 = a.vertex(axis.edge), v2 = a.vertex(a.next(axis.edge));
    const bool before = dot(center - v1, v2 - v1)<0.0f, after = dot(center - v2, v2 - v1)> 0.0f;
    if (axis.separation > 1e-7f && (before || after)) {
        const Vec2 p = before ? v1 : v2;
        const float distance = length(center - p);
        set_point(p, center, (1.0f / distance) * (center - p), distance, a.radius(), radius, offset,
                  margin, m);
        m.corner = distance;
    } else {
        set_point(center - axis.separation * n, center, n, axis.separation, a.radius(), radius,
                  offset, margin, m);
    }
}

void collide_polygons(const TurnedFacets& a, const TurnedFacets& b, Vec2 offset, float margin,
                      Manifold& m) {
    const float reach = a.radius() + b.radius() + margin;
    const EdgeGap on_a = deepest_edge_between(a, b, offset);
    if (on_a.separation > reach) return;
    const EdgeGap on_b = deepest_edge_between(b, a, -offset);
    if (on_b.separation > reach) return;
    const bool flipped = on_b.separation > on_a.separation + face_preference;
    const TurnedFacets &reference = flipped ? b : a, &other = flipped ? a : b;
    const Vec2 to_other = flipped ? -offset : offset;
    const EdgeGap axis = flipped ? on_b : on_a;
    const TurnedFacets::Excerpt edge(reference, axis.edge);
    const TurnedFacets::Excerpt facing(other, incident_edge_of(other, edge.normals[0]));
    float s, t;
    if (axis.separation > face_preference &&
        nearest_ends(edge.vertices[0], edge.vertices[1], facing.vertices[0] + to_other,
                     facing.vertices[1] + to_other, s, t)) {
        const Vec2 p = edge.vertices[s == 0.0f ? 0 : 1];
        const Vec2 q = facing.vertices[t == 0.0f ? 0 : 1] + to_other;
        const float distance = length(q - p);
        if (std::fabs(cross(edge.normals[0], q - p)) > 1e-3f * distance) {
            // Corners of thick shapes without rounding may still pass each other.
            constexpr float thin = 20.0f * seam;
            const float shorter = min(length_squared(edge.vertices[1] - edge.vertices[0]),
                                      length_squared(facing.vertices[1] - facing.vertices[0]));
            if (a.radius() + b.radius() == 0.0f && shorter > thin * thin) return;
            const Vec2 normal = (1.0f / distance) * (q - p);
            const Vec2 on_a_side = flipped ? q + offset : p, on_b_side = flipped ? p + offset : q;
            set_point(on_a_side, on_b_side, flipped ? -normal : normal, distance, a.radius(),
                      b.radius(), offset, margin, m);
            m.corner = distance;
            return;
        }
    }
    // The ends of the edges identify a point from step to step, because the edges themselves change
    // when the polygon rolls.
    const FacingEdges edges(edge.form, 0, facing.form, 0, to_other);
    if (!edges.are_a_seam()) edges.clip(flipped, margin, offset, m);
}

/// Nearest points of two segments.
Nearest between_edges(const TurnedFacets::Excerpt& e, const TurnedFacets::Excerpt& f, Vec2 offset) {
    const Vec2 q1 = f.vertices[0] + offset, q2 = f.vertices[1] + offset;
    float s, t;
    nearest_ends(e.vertices[0], e.vertices[1], q1, q2, s, t);
    Nearest found;
    found.on_a = e.vertices[0] + s * (e.vertices[1] - e.vertices[0]);
    found.on_b = q1 + clamp(t, 0.0f, 1.0f) * (q2 - q1);
    found.distance = length(found.on_b - found.on_a);
    return found;
}

Nearest to_point(const TurnedFacets& a, Vec2 point) {
    const EdgeGap axis = deepest_edge(a, point, [&](Vec2 n) { return dot(n, point); });
    Nearest found;
    found.on_a = found.on_b = point;
    if (axis.separation <= 0.0f) return found;
    const Vec2 v1 = a.vertex(axis.edge), along = a.vertex(a.next(axis.edge)) - v1;
    found.on_a = v1 + nearest_fraction(along, point - v1) * along;
    found.distance = length(point - found.on_a);
    return found;
}

Nearest between_polygons(const TurnedFacets& a, const TurnedFacets& b, Vec2 offset) {
    const EdgeGap on_a = deepest_edge_between(a, b, offset),
                  on_b = deepest_edge_between(b, a, -offset);
    Nearest best;
    if (max(on_a.separation, on_b.separation) <= 0.0f) {
        best.on_a = best.on_b =
            0.5f * (a.vertex(a.farthest(b.middle() + offset - a.middle())) + offset + b.middle());
        return best;
    }
    const bool flipped = on_b.separation > on_a.separation;
    const int edge_a = flipped ? incident_edge_of(a, b.normal(on_b.edge)) : on_a.edge;
    const int edge_b = flipped ? on_b.edge : incident_edge_of(b, a.normal(on_a.edge));
    best.distance = infinity;
    for (int i : {a.previous(edge_a), edge_a, a.next(edge_a)}) {
        for (int k : {b.previous(edge_b), edge_b, b.next(edge_b)}) {
            const Nearest found =
                between_edges(TurnedFacets::Excerpt(a, i), TurnedFacets::Excerpt(b, k), offset);
            if (found.distance < best.distance) best = found;
        }
    }
    return best;
}

}  // namespace

void collide_large(const Solid& a, const Solid& b, Vec2 offset, float margin, Manifold& m) {
    m.count = 0;
    m.corner = 0.0f;
    const TurnedFacets form_a(a), form_b(b);
    if (b.form.count == 1) {
        collide_circle(form_a, b.form.vertices[0] + offset, b.form.radius, offset, margin, m);
    } else if (a.form.count == 1) {
        collide_circle(form_b, a.form.vertices[0] - offset, a.form.radius, -offset, margin, m);
        m.normal = -m.normal;
        std::swap(m.points[0].anchor_a, m.points[0].anchor_b);
    } else {
        collide_polygons(form_a, form_b, offset, margin, m);
    }
}

void collide_large_half_plane(Vec2 normal, float depth, const Solid& b, Vec2 center_b, float margin,
                              Manifold& m) {
    const TurnedFacets form(b);
    const int deepest = form.farthest(-normal);
    const Vec2 vertices[3] = {form.vertex(form.previous(deepest)), form.vertex(deepest),
                              form.vertex(form.next(deepest))};
    collide_half_plane(normal, depth, {vertices, nullptr, nullptr, 3, form.radius()}, center_b,
                       margin, m);
}

Nearest nearest_to_large(const Solid& a, const Solid& b, Vec2 offset) {
    const TurnedFacets form_a(a), form_b(b);
    Nearest found;
    if (b.form.count == 1) {
        found = to_point(form_a, b.form.vertices[0] + offset);
    } else if (a.form.count == 1) {
        found = to_point(form_b, a.form.vertices[0] - offset);
        std::swap(found.on_a, found.on_b);
        found.on_a = found.on_a + offset;
        found.on_b = found.on_b + offset;
    } else {
        found = between_polygons(form_a, form_b, offset);
    }
    const float apart = found.distance - a.form.radius - b.form.radius;
    if (!(apart > 0.0f)) {
        found.distance = 0.0f;
        found.on_a = found.on_b = 0.5f * (found.on_a + found.on_b);
        return found;
    }
    found.normal = normalized(found.on_b - found.on_a);
    found.distance = apart;
    found.on_a = found.on_a + a.form.radius * found.normal;
    found.on_b = found.on_b - b.form.radius * found.normal;
    return found;
}

PlainCopy::PlainCopy(const Solid& from) : plain_(from) {
    if (from.kind != FormKind::large) return;
    for (int i = 0; i < from.form.count; ++i) {
        vertices_.push_back(rotate(from.rotation, from.form.vertices[i]));
        normals_.push_back(rotate(from.rotation, from.form.normals[i]));
    }
    plain_.kind = FormKind::convex;
    plain_.form.vertices = vertices_.data();
    plain_.form.normals = normals_.data();
}

}  // namespace fettle::physics::detail
