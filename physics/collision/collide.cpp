#include <collision/clip.h>

#include <utility>

// Separating axes and clipping. For two convex polygons, the axis of least overlap is the normal of
// one of their edges (D. Gregorius, "The Separating Axis Test between Convex Polyhedra", GDC 2013;
// in the plane there are no cross products of edges). This edge is the reference. The most
// anti-parallel edge of the other polygon is clipped against its ends. Pairs of vertex and edge
// identify the points from step to step.

namespace fettle::physics::detail {
namespace {

struct Axis {
    int edge = 0;
    float separation = -1e30f;  // of the cores, without radii
};

/// The edge of `a` with the greatest separation from `b`. `offset` is the origin of b relative to
/// a's.
Axis deepest_axis(const Convex& a, const Convex& b, Vec2 offset) {
    Axis best;
    for (int i = 0; i < a.count; ++i) {
        const Vec2 n = a.normals[i];
        float nearest = dot(n, b.vertices[0]);
        for (int j = 1; j < b.count; ++j) nearest = min(nearest, dot(n, b.vertices[j]));
        const float separation = nearest + dot(n, offset) - a.offsets[i];
        if (separation > best.separation) best = {i, separation};
    }
    return best;
}

/// One point with the normal along the line between `p` on a and `q` on b.
void single_point(Vec2 p, Vec2 q, Vec2 fallback, const Convex& a, const Convex& b, Vec2 offset,
                  float margin, uint16_t feature, Manifold& m) {
    const Vec2 d = q - p;
    const float distance = length(d);
    const float separation = distance - a.radius - b.radius;
    if (separation > margin) return;
    const Vec2 normal = distance > 1e-9f ? (1.0f / distance) * d : fallback;
    const Vec2 surface_a = p + a.radius * normal;
    const Vec2 surface_b = q - b.radius * normal;
    m.set_point(normal, 0.5f * (surface_a + surface_b), offset, separation, feature);
    m.corner = distance;
}

/// Circle (one vertex) against any shape.
void collide_circle(const Convex& a, const Convex& circle, Vec2 offset, float margin, Manifold& m) {
    const Vec2 c = circle.vertices[0] + offset;
    if (a.count == 1) {
        single_point(a.vertices[0], c, {0.0f, 1.0f}, a, circle, offset, margin, 0, m);
        return;
    }
    Axis best;
    for (int i = 0; i < a.count; ++i) {
        const float s = dot(a.normals[i], c) - a.offsets[i];
        if (s > best.separation) best = {i, s};
    }
    if (best.separation > a.radius + circle.radius + margin) return;
    const Vec2 n = a.normals[best.edge];
    const int next = best.edge + 1 < a.count ? best.edge + 1 : 0;
    const Vec2 v1 = a.vertices[best.edge], v2 = a.vertices[next];
    const Vec2 along = v2 - v1;
    const float t1 = dot(c - v1, along), t2 = dot(v2 - c, along);
    // A segment has no inside: beyond its ends, the end itself is nearest, even at distance 0.
    const bool outside = best.separation > 1e-7f || a.count == 2;
    if (outside && t1 < 0.0f) {
        single_point(v1, c, n, a, circle, offset, margin, feature_of(best.edge, 255), m);
    } else if (outside && t2 < 0.0f) {
        single_point(v2, c, n, a, circle, offset, margin, feature_of(next, 255), m);
    } else {
        const float separation = best.separation - a.radius - circle.radius;
        const Vec2 surface_a = c + (a.radius - best.separation) * n;
        const Vec2 surface_b = c - circle.radius * n;
        m.set_point(n, 0.5f * (surface_a + surface_b), offset, separation,
                    feature_of(best.edge, 254));
    }
}

/// The edge of the reference, and the edge of the other polygon that faces it.
struct EdgePair {
    const Convex &reference, &other;
    Vec2 to_other;
    int edge, incident;
    bool flipped;  ///< the reference is b
};

/// For cores that are apart. Returns true if their nearest points are vertices of both; then the
/// direction between the shapes is not the normal of an edge, and the manifold is complete.
bool collide_vertices(const Convex& a, const Convex& b, Vec2 offset, float margin,
                      const EdgePair& pair, Manifold& m) {
    const auto& [reference, other, to_other, edge, incident, flipped] = pair;
    const int edge2 = edge + 1 < reference.count ? edge + 1 : 0;
    const int incident2 = incident + 1 < other.count ? incident + 1 : 0;
    float s, t;
    if (!nearest_ends(reference.vertices[edge], reference.vertices[edge2],
                      other.vertices[incident] + to_other, other.vertices[incident2] + to_other, s,
                      t))
        return false;
    const int r = s == 0.0f ? edge : edge2;
    const int o = t == 0.0f ? incident : incident2;
    const Vec2 p = reference.vertices[r], q = other.vertices[o] + to_other;
    const Vec2 n = reference.normals[edge];
    const Vec2 along = {-n.y, n.x};
    // Facing edges with level ends give a face contact, not a vertex contact.
    const Vec2 d = q - p;
    if (!(std::fabs(dot(d, along)) > 1e-3f * length(d))) return false;
    // Corners of thick shapes without rounding may still pass each other. (Cards do lean on each
    // other corner to corner.)
    const float thin = 20.0f * seam;
    const Vec2 reference_edge = reference.vertices[edge2] - reference.vertices[edge];
    const Vec2 other_edge = other.vertices[incident2] - other.vertices[incident];
    const float shorter = min(length_squared(reference_edge), length_squared(other_edge));
    if (a.radius + b.radius == 0.0f && shorter > thin * thin) return true;
    if (!flipped) {
        single_point(p, q, n, a, b, offset, margin, feature_of(r, o), m);
    } else {
        // In the frame of b: converted to the frame of a.
        single_point(q + offset, p + offset, -n, a, b, offset, margin, feature_of(o, r), m);
    }
    return true;
}

}  // namespace

void collide(const Convex& a, const Convex& b, Vec2 offset, float margin, Manifold& m) {
    m.count = 0;
    m.corner = 0.0f;
    if (b.count == 1) {
        collide_circle(a, b, offset, margin, m);
        return;
    }
    if (a.count == 1) {
        collide_circle(b, a, -offset, margin, m);
        m.normal = -m.normal;
        if (m.count > 0) {
            std::swap(m.points[0].anchor_a, m.points[0].anchor_b);
        }
        return;
    }
    const float reach = a.radius + b.radius + margin;
    const Axis on_a = deepest_axis(a, b, offset);
    if (on_a.separation > reach) return;
    const Axis on_b = deepest_axis(b, a, -offset);
    if (on_b.separation > reach) return;

    const bool flipped = on_b.separation > on_a.separation + face_preference;
    const Convex& reference = flipped ? b : a;
    const Convex& other = flipped ? a : b;
    const Vec2 to_other = flipped ? -offset : offset;
    const int edge = flipped ? on_b.edge : on_a.edge;
    const int incident = incident_edge(other, reference.normals[edge]);
    const FacingEdges edges(reference, edge, other, incident, to_other);
    // Segments in one line have no normal that tells them apart.
    const bool in_line = a.count == 2 && b.count == 2 && edges.are_beside();

    if ((in_line || (flipped ? on_b.separation : on_a.separation) > face_preference) &&
        collide_vertices(a, b, offset, margin,
                         {reference, other, to_other, edge, incident, flipped}, m))
        return;
    if (!edges.are_a_seam()) edges.clip(flipped, margin, offset, m);
}

void collide_half_plane(Vec2 normal, float depth, const Convex& b, Vec2 center_b, float margin,
                        Manifold& m) {
    m.count = 0;
    m.corner = 0.0f;
    m.normal = normal;
    const float base = dot(normal, center_b) - depth - b.radius;
    int deepest = 0;
    float least = dot(normal, b.vertices[0]);
    for (int i = 1; i < b.count; ++i) {
        const float s = dot(normal, b.vertices[i]);
        if (s < least) {
            least = s;
            deepest = i;
        }
    }
    auto add = [&](int vertex) {
        const float separation = dot(normal, b.vertices[vertex]) + base;
        if (separation > margin) return;
        const Vec2 anchor = b.vertices[vertex] - (b.radius + 0.5f * separation) * normal;
        m.points[m.count++] = {anchor + center_b,        anchor, separation, 0.0f, 0.0f,
                               uint16_t(vertex & 0xffff)};
    };
    add(deepest);
    if (b.count < 2 || m.count == 0) return;
    const int before = deepest > 0 ? deepest - 1 : b.count - 1;
    const int after = deepest + 1 < b.count ? deepest + 1 : 0;
    // The flatter of the two edges lies on the plane, not the one that ends lower: the ends of a
    // thin plank are lower than its other side, and if both points were at one end, the other end
    // would sink in.
    const Vec2 edge = b.vertices[before] - b.vertices[deepest];
    const Vec2 other_edge = b.vertices[after] - b.vertices[deepest];
    const float rise = dot(normal, edge), other_rise = dot(normal, other_edge);
    const float flat = rise * rise * length_squared(other_edge);
    const float other_flat = other_rise * other_rise * length_squared(edge);
    const bool longer = length_squared(edge) > length_squared(other_edge);
    add(flat < other_flat || (flat == other_flat && longer) ? before : after);
    // Sorted by vertex, so that the order for the solver does not change between steps.
    if (m.count == 2 && m.points[1].feature < m.points[0].feature)
        std::swap(m.points[0], m.points[1]);
}

}  // namespace fettle::physics::detail
