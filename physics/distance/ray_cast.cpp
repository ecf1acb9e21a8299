// Rays through shapes.

#include <collision/ellipse.h>
#include <collision/extreme_points.h>
#include <collision/outline_piece.h>
#include <distance/distance.h>

namespace fettle::physics::detail {
namespace {

float distance_to_edge(Vec2 a, Vec2 b, Vec2 p) {
    return std::sqrt(squared_distance_to_edge(a, b, p));
}

/// True if the line of a ray passes between the ends of an edge that faces it. The rounding error
/// of the ends is included, because a ray must not pass between two edges at a corner, or between
/// two shapes that stand side by side. It does not grow with the length of the ray: a ray of a
/// million meters meets what a short one does.
bool crosses_edge(const Convex& shape, int edge, Vec2 p, Vec2 d) {
    const Vec2 a = shape.vertices[edge], b = shape.vertices[edge + 1 < shape.count ? edge + 1 : 0];
    const Vec2 from = p - shape.radius * shape.normals[edge];
    const auto size = [](Vec2 v) { return std::fabs(v.x) + std::fabs(v.y); };
    const float slack = 5e-7f * size(d) * (size(p) + size(a));
    return cross(d, a - from) >= -slack && cross(d, b - from) <= slack;
}

void cast_circle(Vec2 center, float radius, Vec2 p, Vec2 d, Probe& best) {
    if (!(radius > 0.0f)) return;
    // |p + t·d - c|² = r². The parameter is measured from the point of the line nearest to the
    // center, which avoids cancellation at large distances.
    const float l = length(d);
    if (!(l > 0.0f)) return;
    const Vec2 u = (1.0f / l) * d;
    const float along = dot(center - p, u);
    const Vec2 nearest = p + along * u - center;
    const float half = radius * radius - length_squared(nearest);
    if (half < 0.0f) return;
    const float back = std::sqrt(half), t = (along - back) / l;
    if (t < 0.0f || t > 1.0f || t >= best.fraction) return;
    best.fraction = t;
    // Not from the point of the ray, which may be rounded to any side of the center.
    const Vec2 across = {-u.y, u.x};
    best.normal = normalized(dot(nearest, across) * across - back * u);
}

}  // namespace

float signed_distance(const Convex& shape, Vec2 p) {
    if (shape.count == 1) return length(p - shape.vertices[0]) - shape.radius;
    if (shape.count > most_small_vertices) {
        const auto [edge, apart] =
            deepest_edge(Facets(shape), p, [&](Vec2 n) { return dot(n, p); });
        if (apart <= 0.0f) return apart - shape.radius;
        const int next = edge + 1 < shape.count ? edge + 1 : 0;
        return distance_to_edge(shape.vertices[edge], shape.vertices[next], p) - shape.radius;
    }
    float outside = -1e30f;
    for (int i = 0; i < shape.count; ++i) {
        outside = max(outside, dot(shape.normals[i], p) - shape.offsets[i]);
    }
    if (outside <= 0.0f && shape.count > 2) return outside - shape.radius;
    float distance = 1e30f;
    for (int i = 0; i < shape.count; ++i) {
        const int next = i + 1 < shape.count ? i + 1 : 0;
        distance = min(distance, distance_to_edge(shape.vertices[i], shape.vertices[next], p));
    }
    return distance - shape.radius;
}

namespace {

/// Casts a ray through a polygon with many vertices. Seen along the ray, the near side of the
/// outline extends from the leftmost vertex to the rightmost; bisection finds the edge that the
/// line meets.
Probe cast_large(const Convex& shape, Vec2 p, Vec2 d) {
    const Vec2 left = {-d.y, d.x};
    const float line = dot(left, p);
    const int n = shape.count, leftmost = farthest_vertex(shape, left);
    const int edges = (farthest_vertex(shape, -left) - leftmost + n) % n;
    const auto vertex = [&](int k) { return shape.vertices[(leftmost + k) % n]; };
    const auto normal = [&](int k) { return shape.normals[(leftmost + k) % n]; };
    int low = 0, high = edges;  // first edge that ends right of the line
    while (low < high) {
        const int middle = (low + high) / 2;
        if (dot(left, vertex(middle + 1) + shape.radius * normal(middle)) <= line)
            high = middle;
        else
            low = middle + 1;
    }
    Probe best;
    const Vec2 v = vertex(low), outwards = normal(low);
    if (low == edges || line > dot(left, v + shape.radius * outwards)) {
        cast_circle(v, shape.radius, p, d, best);
        return best;
    }
    const float speed = dot(outwards, d);
    const float t = (dot(outwards, v - p) + shape.radius) / speed;
    if (speed < 0.0f && t >= 0.0f && t <= 1.0f) best = {t, outwards};
    return best;
}

}  // namespace

Probe cast_segment(const Convex& shape, Vec2 p, Vec2 d) {
    Probe best;
    if ((shape.count > 2 || shape.radius > 0.0f) && signed_distance(shape, p) < 0.0f) return best;
    if (shape.count > most_small_vertices) return cast_large(shape, p, d);
    for (int i = 0; i < shape.count && shape.count > 1; ++i) {
        const Vec2 n = shape.normals[i];
        const float speed = dot(n, d);
        if (!(speed < 0.0f)) continue;
        const float t = (shape.offsets[i] + shape.radius - dot(n, p)) / speed;
        if (t < 0.0f || t > 1.0f || t >= best.fraction) continue;
        if (crosses_edge(shape, i, p, d)) best = {t, n};
    }
    for (int i = 0; i < shape.count; ++i) cast_circle(shape.vertices[i], shape.radius, p, d, best);
    return best;
}

namespace {

/// The ellipse is transformed to a unit circle. Lines stay lines, and fractions do not change.
Probe cast_ellipse(const EllipseForm& e, Vec2 p, Vec2 d) {
    const Vec2 across = {-e.axis.y, e.axis.x};
    const auto to_circle = [&](Vec2 v) {
        return Vec2{dot(v, e.axis) / e.first, dot(v, across) / e.second};
    };
    const Vec2 start = to_circle(p - e.center);
    Probe best;
    if (length_squared(start) < 1.0f) return best;
    cast_circle({}, 1.0f, start, to_circle(d), best);
    if (best.fraction <= 1.0f) {
        const Vec2 n = best.normal;
        best.normal = normalized((n.x / e.first) * e.axis + (n.y / e.second) * across);
    }
    return best;
}

Probe cast_piece(const OutlinePiece& piece, Vec2 p, Vec2 d) {
    const Convex& form = piece.form;
    Probe best;
    if (!piece.one_sided() && signed_distance(form, p) < 0.0f) return best;
    for (int i = 0; i < form.count; ++i) {
        const Vec2 n = form.normals[i];
        const float speed = dot(n, d);
        if (piece.is_inner(i) || !(speed < 0.0f)) continue;
        const float t = (form.offsets[i] - dot(n, p)) / speed;
        if (t < 0.0f || t > 1.0f || t >= best.fraction) continue;
        if (crosses_edge(form, i, p, d)) best = {t, n};
    }
    return best;
}

}  // namespace

float reach(const Solid& shape, Vec2 direction) {
    if (shape.kind == FormKind::ellipse) {
        const EllipseForm e = ellipse_of(shape.form);
        return dot(e.center, direction) + e.reach(direction);
    }
    const Vec2 d = shape.kind == FormKind::large ? unrotate(shape.rotation, direction) : direction;
    return dot(shape.form.vertices[farthest_vertex(shape.form, d)], d) + shape.form.radius;
}

Box4 box_of(const Solid& shape) {
    const auto side = [&](Vec2 direction) { return reach(shape, direction); };
    return {{-side({-1.0f, 0.0f}), -side({0.0f, -1.0f})}, {side({1.0f, 0.0f}), side({0.0f, 1.0f})}};
}

float signed_distance(const Solid& shape, Vec2 p) {
    if (shape.kind == FormKind::large) p = unrotate(shape.rotation, p);
    return shape.kind == FormKind::ellipse ? nearest_on_rim(ellipse_of(shape.form), p).distance
                                           : signed_distance(shape.form, p);
}

Probe cast_segment(const Solid& shape, Vec2 p, Vec2 d) {
    if (shape.kind == FormKind::ellipse) return cast_ellipse(ellipse_of(shape.form), p, d);
    if (shape.kind == FormKind::piece) return cast_piece(OutlinePiece(shape), p, d);
    if (shape.kind == FormKind::large) {
        Probe probe =
            cast_segment(shape.form, unrotate(shape.rotation, p), unrotate(shape.rotation, d));
        probe.normal = rotate(shape.rotation, probe.normal);
        return probe;
    }
    return cast_segment(shape.form, p, d);
}

}  // namespace fettle::physics::detail
