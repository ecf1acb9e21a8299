// Nearest points and distances of two shapes.

#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <collision/turned_copy.h>
#include <distance/distance.h>

#include <utility>

namespace fettle::physics::detail {
namespace {

/// Crossing segments may contain no vertex of each other; then their nearest point is the crossing.
bool segments_cross(const Convex& a, const Convex& b, Vec2 offset, Vec2& at) {
    if (a.count != 2 || b.count != 2) return false;
    const Vec2 p = a.vertices[0], d = a.vertices[1] - p;
    const Vec2 q = b.vertices[0] + offset, e = b.vertices[1] - b.vertices[0];
    const float k = cross(d, e);
    if (k == 0.0f) return false;
    const float t = cross(q - p, e) / k, s = cross(q - p, d) / k;
    at = p + t * d;
    return t >= 0.0f && t <= 1.0f && s >= 0.0f && s <= 1.0f;
}

struct Pair {
    float squared = 1e30f;
    Vec2 vertex, edge;
};

/// The nearest pair of a vertex of `points` and a point on an edge of `shape`. `to_shape`: position
/// of `shape` relative to `points`.
Pair vertex_and_edge(const Convex& points, const Convex& shape, Vec2 to_shape) {
    Pair best;
    for (int i = 0; i < points.count; ++i) {
        for (int k = 0; k < shape.count; ++k) {
            const Vec2 a = shape.vertices[k] + to_shape;
            const Vec2 b = shape.vertices[k + 1 < shape.count ? k + 1 : 0] + to_shape;
            const Vec2 on_edge = nearest_on_edge(a, b, points.vertices[i]);
            const float squared = length_squared(points.vertices[i] - on_edge);
            if (squared < best.squared) best = {squared, points.vertices[i], on_edge};
        }
    }
    return best;
}

}  // namespace

Nearest nearest_points(const Convex& a, const Convex& b, Vec2 offset) {
    const Pair from_a = vertex_and_edge(a, b, offset), from_b = vertex_and_edge(b, a, -offset);
    Nearest found;
    if (from_a.squared <= from_b.squared) {
        found.on_a = from_a.vertex;
        found.on_b = from_a.edge;
    } else {
        found.on_a = from_b.edge + offset;
        found.on_b = from_b.vertex + offset;
    }
    const Vec2 gap = found.on_b - found.on_a;
    const float apart = length(gap) - a.radius - b.radius;
    Vec2 crossing;
    if (segments_cross(a, b, offset, crossing)) {
        found.on_a = found.on_b = crossing;
        return found;
    }
    if (!(apart > 0.0f) || !(distance(a, b, offset) > 0.0f)) {
        found.on_a = found.on_b = 0.5f * (found.on_a + found.on_b);
        return found;
    }
    found.normal = normalized(gap);
    found.distance = apart;
    found.on_a = found.on_a + a.radius * found.normal;
    found.on_b = found.on_b - b.radius * found.normal;
    return found;
}

Nearest nearest_points(const Solid& a, const Solid& b, Vec2 offset) {
    const bool round_a = a.kind == FormKind::ellipse, round_b = b.kind == FormKind::ellipse;
    if (!round_a && !round_b) {
        const bool many = a.form.count > most_small_vertices || b.form.count > most_small_vertices;
        return many ? nearest_to_large(a, b, offset) : nearest_points(a.form, b.form, offset);
    }
    if (!round_a) {
        Nearest found = nearest_points(b, a, -offset);
        std::swap(found.on_a, found.on_b);
        found.on_a = found.on_a + offset;
        found.on_b = found.on_b + offset;
        found.normal = -found.normal;
        return found;
    }
    if (b.kind == FormKind::large) {
        // Computed in the frame of the polygon's vertices.
        const Rotation q = b.rotation;
        TurnedCopy turned(a);
        Nearest found = nearest_points(turned.by({q.c, -q.s}), {b.form}, unrotate(q, offset));
        for (Vec2* v : {&found.on_a, &found.on_b, &found.normal}) *v = rotate(q, *v);
        return found;
    }
    const EllipseForm ellipse = ellipse_of(a.form);
    const EllipseGap gap = round_b ? gap_between(ellipse, ellipse_of(b.form), offset)
                                   : gap_between(ellipse, b.form, offset);
    const float radius = round_b ? 0.0f : b.form.radius;
    Nearest found;
    found.on_a = gap.on_ellipse;
    found.on_b = gap.on_other - radius * gap.normal;
    if (gap.separation > radius) {
        found.distance = gap.separation - radius;
        found.normal = gap.normal;
    } else {
        found.on_a = found.on_b = 0.5f * (found.on_a + found.on_b);
    }
    return found;
}

}  // namespace fettle::physics::detail
