#include <collision/clip.h>
#include <collision/ellipse.h>
#include <collision/extreme_points.h>
#include <collision/outline_piece.h>

namespace fettle::physics::detail {
namespace {

/// If the overlap through an inner edge is smaller than through any other edge by this (m), the
/// shape is in front of another piece.
constexpr float beyond = 0.01f;

/// A direction in which the overlap is more than this times the least one is not the way out of the
/// outline: it would press a shape through to the other side.
constexpr float most_next = 3.0f;

/// A body that touches a one-sided segment is pushed to its front until the whole body is this far
/// behind (m): a heavy impact may press a thin body through within a step or two, before the
/// contact pushes it out.
constexpr float far_behind = 0.01f;

/// What slides along an edge overlaps it by less than this, m.
constexpr float rests_behind = 0.005f;
/// A shape that is turned against an edge by less than this, rad, lies along it.
constexpr float lying = 0.002f;

/// The best of the edges that may push, and the separation along the inner edges.
struct Axes {
    EdgeGap outer = {-1};
    float inner = -1e30f;
    float greatest() const { return max(outer.separation, inner); }
};

/// The order of edges from the greatest separation to the least.
bool is_after(EdgeGap first, EdgeGap second) {
    return second.separation < first.separation ||
           (second.separation == first.separation && second.edge > first.edge);
}

/// Outer edges up to `last` in the order of their separation are left out.
Axes axes_of(const OutlinePiece& piece, auto&& nearest, EdgeGap last = {-1, 1e30f}) {
    const Convex& form = piece.form;
    Axes axes;
    for (int i = 0; i < form.count; ++i) {
        const float s = nearest(form.normals[i]) - form.offsets[i];
        if (piece.is_inner(i))
            axes.inner = max(axes.inner, s);
        else if (s > axes.outer.separation && is_after(last, {i, s}))
            axes.outer = {i, s};
    }
    return axes;
}

float lowest(const Convex& form, Vec2 normal) {
    return dot(normal, form.vertices[farthest_vertex(form, -normal)]);
}

void one_point(Vec2 on_a, Vec2 normal, float gap, float radius_b, Vec2 offset, float margin,
               uint16_t feature, Manifold& m) {
    const float separation = gap - radius_b;
    if (separation > margin) return;
    m.set_point(normal, on_a + (0.5f * separation) * normal, offset, separation, feature);
}

/// Faces extend beyond their ends by this (m), so that rounding leaves no gap between two nearly
/// equal faces.
float overhang(float height, Vec2 where) {
    return 2.0f * OutlinePiece::flat_angle * std::fabs(height) +
           1e-6f * (std::fabs(where.x) + std::fabs(where.y));
}

/// True if no segment beside a corner of the outline would push: the tip of a thin shape on the
/// corner is deeper in both segments than the shape is wide, so each leaves it to the other.
/// `least`: the overlap along the best direction, `through_face`: through the face of this segment.
bool is_left_by_all(const OutlinePiece& piece, float least, float through_face) {
    return piece.one_sided() && least > 0.0f && through_face < 4.0f * least + beyond;
}

/// True if the shape is in front of another piece: the overlap through an inner edge is smaller,
/// and the middle of the shape is beyond this edge. It is beyond it for only one of the two pieces
/// that share the edge, so they never both leave the shape to each other. The back of a segment has
/// no other piece behind it. A body that touches the segment may be behind it by more than the
/// thickness of the body. `nearest(normal)`: the coordinate of the nearest point of the shape.
bool is_behind_inner(const OutlinePiece& piece, float inner, float outer, Vec2 middle,
                     auto&& nearest) {
    if (piece.one_sided() || !(inner > outer + beyond)) return false;
    const Convex& form = piece.form;
    for (int i = 0; i < form.count; ++i) {
        const Vec2 n = form.normals[i];
        if (piece.is_inner(i) && dot(n, middle) > form.offsets[i] &&
            nearest(n) - form.offsets[i] > outer + beyond)
            return true;
    }
    return false;
}

/// A circle: its center is a point, so the nearest feature of the piece decides.
void collide_circle(const OutlinePiece& a, Vec2 center, float radius, Vec2 offset, float margin,
                    bool had_contact, Manifold& m) {
    const Axes axes = axes_of(a, [&](Vec2 n) { return dot(n, center); });
    if (axes.greatest() > radius + margin) return;
    const bool in_front = a.faces(center, had_contact ? radius + far_behind : 0.0f);
    // Beyond an inner edge, the circle meets another piece first.
    const bool hidden = !a.one_sided() && axes.inner > max(axes.outer.separation, 0.0f);
    const int edge = axes.outer.edge;
    if (edge < 0) return;
    const int next = edge + 1 < a.form.count ? edge + 1 : 0;
    const Vec2 v1 = a.form.vertices[edge], v2 = a.form.vertices[next];
    const Vec2 n = a.form.normals[edge], along = v2 - v1;
    const float t1 = dot(center - v1, along), t2 = dot(v2 - center, along);
    const float over = overhang(axes.outer.separation, v1) * length(along);
    const bool above = t1 >= -over && t2 >= -over;
    const float gap = axes.outer.separation;
    if (!hidden && (above || (in_front && gap > radius && a.is_before_hollow(edge, center)))) {
        if (!in_front) return;
        one_point(center - gap * n, n, gap, radius, offset, margin, feature_of(edge, 254), m);
        return;
    }
    // Beyond the ends of an edge, the nearest vertex counts if it is a corner of the outline and
    // belongs to this piece.
    int vertex = 0;
    float least = 1e30f;
    for (int i = 0; i < a.form.count; ++i) {
        const float d = length_squared(center - a.form.vertices[i]);
        if (d < least) {
            least = d;
            vertex = i;
        }
    }
    const Vec2 p = a.form.vertices[vertex];
    const float distance = std::sqrt(least);
    const Vec2 direction = distance > 1e-9f ? (1.0f / distance) * (center - p) : n;
    if (!in_front && !a.continues(vertex)) return;
    if (a.decide(vertex, direction) != OutlinePiece::Verdict::pushes) return;
    if (axes.greatest() <= 0.0f) return;
    one_point(p, direction, distance, radius, offset, margin, feature_of(vertex, 255), m);
    m.corner = distance;
}

/// The end of a one-sided segment, 0 or 1, beyond which an ellipse crosses its line; -1: none.
int crossed_beyond(const EllipseForm& e, Vec2 center, Vec2 v1, Vec2 v2) {
    // In the frame in which the ellipse is the unit circle.
    const auto on_circle = [&](Vec2 d) {
        return Vec2{dot(d, e.axis) / e.first, cross(e.axis, d) / e.second};
    };
    const Vec2 p1 = on_circle(v1 - center), p2 = on_circle(v2 - center), along = p2 - p1;
    if (dot(p1, along) > 0.0f && length_squared(p1) > 1.0f) return 0;
    if (dot(p2, along) < 0.0f && length_squared(p2) > 1.0f) return 1;
    return -1;
}

/// Pushes an ellipse with the corner that is nearest to it, if there is one.
void push_with_corner(const OutlinePiece& a, const EllipseForm& e, Vec2 offset, float margin,
                      bool in_front, Manifold& m) {
    const float reach = max(e.first, e.second) + margin;
    for (int i = 0; i < a.form.count && m.count == 0; ++i) {
        const Vec2 to_center = e.center + offset - a.form.vertices[i];
        if (length_squared(to_center) > reach * reach) continue;
        const RimPoint rim = nearest_on_rim(e, a.form.vertices[i] - offset);
        if (rim.distance <= 0.0f || (!in_front && !a.continues(i))) continue;
        if (a.decide(i, -rim.normal) == OutlinePiece::Verdict::pushes)
            one_point(a.form.vertices[i], -rim.normal, rim.distance, 0.0f, offset, margin,
                      feature_of(i, 255), m);
    }
}

void collide_ellipse(const OutlinePiece& a, const EllipseForm& e, Vec2 offset, float margin,
                     bool had_contact, Manifold& m) {
    const Vec2 center = e.center + offset;
    const auto nearest = [&](Vec2 n) { return dot(n, center) - e.reach(n); };
    const Axes axes = axes_of(a, nearest);
    const float depth = had_contact ? e.reach(a.form.normals[0]) + far_behind : 0.0f;
    if (axes.greatest() > margin || axes.outer.edge < 0) return;
    const bool in_front = a.faces(center, depth);
    if (!in_front || is_behind_inner(a, axes.inner, axes.outer.separation, center, nearest)) {
        push_with_corner(a, e, offset, margin, in_front, m);
        return;
    }
    const int edge = axes.outer.edge;
    const int next = edge + 1 < a.form.count ? edge + 1 : 0;
    const Vec2 v1 = a.form.vertices[edge], v2 = a.form.vertices[next];
    const Vec2 n = a.form.normals[edge], along = v2 - v1;
    const Vec2 deepest = e.support(-n) + offset;
    const float over = overhang(axes.outer.separation, v1) * length(along);
    const int end =
        a.one_sided() && axes.outer.separation < 0.0f ? crossed_beyond(e, center, v1, v2) : -1;
    const bool before = end == 0 || (end < 0 && dot(deepest - v1, along) < -over);
    const bool after = end == 1 || (end < 0 && dot(deepest - v2, along) > over);
    if (!before && !after) {
        const float gap = axes.outer.separation;
        one_point(deepest - gap * n, n, gap, 0.0f, offset, margin, feature_of(edge, 254), m);
        return;
    }
    const int vertex = before ? edge : next;
    const Vec2 p = before ? v1 : v2;
    if (axes.outer.separation > 0.0f && a.is_before_hollow(edge, deepest, rests_behind)) {
        one_point(deepest - axes.outer.separation * n, n, axes.outer.separation, 0.0f, offset,
                  margin, feature_of(edge, 254), m);
        return;
    }
    const RimPoint rim = nearest_on_rim(e, p - offset);
    if (a.decide(vertex, -rim.normal) != OutlinePiece::Verdict::pushes) {
        const float gap = axes.outer.separation;
        const bool deep = !a.one_sided() && -rim.distance > beyond;
        if (deep || is_left_by_all(a, -rim.distance, -gap))
            one_point(deepest - gap * n, n, gap, 0.0f, offset, margin, feature_of(edge, 254), m);
        else
            push_with_corner(a, e, offset, margin, in_front, m);
        return;
    }
    one_point(p, -rim.normal, rim.distance, 0.0f, offset, margin, feature_of(vertex, 255), m);
}

/// A point on the edge of a polygon, at a part of the edge.
struct EdgePoint {
    int edge = 0;
    float part = 0.0f;
    Vec2 point;
};

EdgePoint nearest_on_edges(const Convex& form, Vec2 p) {
    EdgePoint best;
    float least = 1e30f;
    for (int i = 0; i < form.count; ++i) {
        const Vec2 from = form.vertices[i];
        const Vec2 along = form.vertices[i + 1 < form.count ? i + 1 : 0] - from;
        const float t = nearest_fraction(along, p - from);
        const Vec2 q = from + t * along;
        const float d = length_squared(p - q);
        if (d < least) {
            least = d;
            best = {i, t, q};
        }
    }
    return best;
}

/// A polygon, a capsule, or a piece of another outline.
class PolygonOnPiece {
  public:
    PolygonOnPiece(const OutlinePiece& a, const Convex& b, const OutlinePiece* piece_b, Vec2 offset,
                   float margin, bool had_contact, Manifold& m)
        : a_(a),
          b_(b),
          piece_b_(piece_b),
          offset_(offset),
          margin_(margin),
          had_contact_(had_contact),
          m_(m) {}

    void collide() {
        const float reach = b_.radius + margin_;
        const auto lowest_of_b = [&](Vec2 n) { return lowest(b_, n) + dot(n, offset_); };
        const Axes on_a = axes_of(a_, lowest_of_b);
        if (on_a.greatest() > reach || on_a.outer.edge < 0) return;
        collide_beyond(on_a, lowest_of_b);
        if (piece_b_ == nullptr) reach_over_hollow(on_a.outer);
    }

  private:
    void collide_beyond(const Axes& on_a, auto&& lowest_of_b) {
        const float reach = b_.radius + margin_;
        const auto lowest_of_a = [&](Vec2 n) { return lowest(a_.form, n) - dot(n, offset_); };
        Axes on_b;
        if (piece_b_ != nullptr)
            on_b = axes_of(*piece_b_, lowest_of_a);
        else
            on_b.outer = deepest_edge(Facets(b_), Facets(a_.form).middle() - offset_, lowest_of_a);
        if (on_b.greatest() > reach) return;
        const float best = max(on_a.outer.separation, on_b.outer.separation);
        if (piece_b_ && !in_front(*piece_b_, a_.form, -offset_)) return;
        const bool front = in_front(a_, b_, offset_);
        const Vec2 middle_a = Facets(a_.form).middle() - offset_;
        const Vec2 middle_b = Facets(b_).middle() + offset_;
        const auto meets_others = [&](float separation) {
            if (is_behind_inner(a_, on_a.inner, separation, middle_b, lowest_of_b)) return true;
            if (piece_b_ == nullptr || on_b.inner <= separation + beyond) return false;
            return piece_b_->one_sided() ||
                   is_behind_inner(*piece_b_, on_b.inner, separation, middle_a, lowest_of_a);
        };
        if (front && !meets_others(best)) push_with_edges(on_a.outer, on_b.outer);
        const bool sided = a_.one_sided() || (piece_b_ != nullptr && piece_b_->one_sided());
        if (m_.count == 0 && front && best < -beyond && !sided)
            push_along_next(on_a.outer, on_b.outer, meets_others, lowest_of_a, lowest_of_b);
        // Not for two outlines: two tips that catch on each other would touch and part in turns.
        const bool apart = max(best, on_a.inner) > face_preference;
        if (m_.count == 0 && apart && piece_b_ == nullptr) push_with_corner(front);
    }

    /// True if most of the other shape is in front of the plane of a one-sided segment.
    bool in_front(const OutlinePiece& piece, const Convex& other, Vec2 to_other) const {
        if (!piece.one_sided()) return true;
        const Vec2 n = piece.form.normals[0];
        const float low = lowest(other, n), high = -lowest(other, -n);
        const float counted = had_contact_ ? high + other.radius + far_behind : 0.5f * (low + high);
        return counted + dot(n, to_other) >= piece.form.offsets[0];
    }

    /// Pushes with the corner that is nearest to an edge, if it is before a hollow. See
    /// `OutlinePiece::is_before_hollow`.
    void reach_over_hollow(EdgeGap on_a) {
        const float separation = on_a.separation - b_.radius;
        if (!(separation > 0.0f)) return;
        const Vec2 n = a_.form.normals[on_a.edge];
        const int corner = farthest_vertex(b_, -n);
        const Vec2 p = b_.vertices[corner] + offset_;
        if (!a_.is_before_hollow(on_a.edge, p, b_.radius + rests_behind) ||
            !in_front(a_, b_, offset_))
            return;
        Manifold m;
        one_point(p - on_a.separation * n, n, on_a.separation, b_.radius, offset_, margin_,
                  feature_of(on_a.edge, corner), m);
        if (m.count == 0 || (m_.count > 0 && !(m_.normal == n))) return;
        // A shape that lies along the edge touches it with its other end, too.
        for (int k = 0; k < m_.count; ++k) {
            const float more = m_.points[k].separation - separation;
            if (more < lying * length(m_.points[k].anchor_a - m.points[0].anchor_a)) return;
        }
        m_ = m;
    }

    void push_with_edges(EdgeGap on_a, EdgeGap on_b) {
        if (on_b.separation > on_a.separation + face_preference)
            push_with_b(on_b);
        else
            push_with_a(on_a.edge, on_a.separation);
        const float best = max(on_a.separation, on_b.separation);
        // While the cores are apart, they have nearest points, and the piece that has one pushes.
        if (m_.count == 0 && best <= face_preference &&
            is_left_by_all(a_, b_.radius - best, b_.radius - on_a.separation))
            push_alone(on_a, on_b);
    }

    /// The next of the edges of the other shape, in the order of their separation.
    EdgeGap next_of_b(EdgeGap last, auto&& lowest_of_a) const {
        if (piece_b_ != nullptr) return axes_of(*piece_b_, lowest_of_a, last).outer;
        EdgeGap next = {-1};
        for (int i = 0; i < b_.count; ++i) {
            const EdgeGap gap = {i, lowest_of_a(b_.normals[i]) - b_.offsets[i]};
            if (gap.separation > next.separation && is_after(last, gap)) next = gap;
        }
        return next;
    }

    /// Pushes along the direction of least overlap among those that the pieces do not leave to
    /// others. A direction that a piece leaves is not that of the outline, which is deeper there.
    void push_along_next(EdgeGap on_a, EdgeGap on_b, auto&& meets_others, auto&& lowest_of_a,
                         auto&& lowest_of_b) {
        const float deepest = most_next * max(on_a.separation, on_b.separation);
        while (m_.count == 0) {
            if (on_b.separation > on_a.separation + face_preference)
                on_b = next_of_b(on_b, lowest_of_a);
            else
                on_a = axes_of(a_, lowest_of_b, on_a).outer;
            const float next = max(on_a.separation, on_b.separation);
            if (next < deepest || meets_others(next)) return;
            push_with_edges(on_a, on_b);
        }
    }

    /// Pushes where no other segment does: with the face, or with the end of the segment if the
    /// face has no point of the other shape above it.
    void push_alone(EdgeGap on_a, EdgeGap on_b) {
        push_with_a(on_a.edge, on_a.separation);
        if (m_.count > 0 || on_b.edge < 0) return;
        const Vec2 outwards = -b_.normals[on_b.edge];
        if (dot(outwards, a_.form.normals[on_a.edge]) < 0.7f) return;
        const int vertex = farthest_vertex(a_.form, outwards);
        one_point(a_.form.vertices[vertex], outwards, on_b.separation, b_.radius, offset_, margin_,
                  feature_of(vertex, on_b.edge), m_);
    }

    /// Pushes with the corner that is nearest to the other shape, if there is one. It may be at
    /// none of the edges that separate the shapes best; and most of a shape beside a sharp corner
    /// is behind one of the two segments that meet there (`front` is false).
    void push_with_corner(bool front) {
        for (int i = 0; i < a_.form.count && m_.count == 0; ++i) {
            if (!front && !a_.continues(i)) continue;
            const Vec2 p = a_.form.vertices[i] - offset_;
            const EdgePoint near = nearest_on_edges(b_, p);
            const float distance = length(near.point - p);
            if (distance <= face_preference) continue;
            const Vec2 direction = (1.0f / distance) * (near.point - p);
            if (a_.decide(i, direction) != OutlinePiece::Verdict::pushes) continue;
            one_point(a_.form.vertices[i], direction, distance, b_.radius, offset_, margin_,
                      feature_of(i, near.edge), m_);
            if (near.part == 0.0f || near.part == 1.0f) m_.corner = distance;
        }
    }

    /// Pushes along the normal of an edge of the piece.
    void push_with_a(int edge, float separation) {
        const Vec2 n = a_.form.normals[edge];
        if (piece_b_ != nullptr) {
            const int vertex = farthest_vertex(b_, -n);
            if (piece_b_->decide(vertex, -n) == OutlinePiece::Verdict::leaves &&
                !is_face(*piece_b_, vertex, -n))
                return;
        }
        const int incident =
            b_.count > most_small_vertices ? incident_edge_of(Facets(b_), n) : incident_edge(b_, n);
        if (separation > face_preference &&
            corner_to_corner(a_.form, edge, b_, incident, offset_, false))
            return;
        clip_pieces(a_.form, edge, b_, incident, offset_, false);
    }

    /// Pushes along the normal of an edge of the other shape: a corner of the outline is pushed.
    void push_with_b(EdgeGap axis) {
        const Vec2 outwards = -b_.normals[axis.edge];
        const int vertex = farthest_vertex(a_.form, outwards);
        if (is_face(a_, vertex, outwards)) {
            push_with_a(a_.edge_at(vertex, outwards), axis.separation);
            return;
        }
        const OutlinePiece::Verdict verdict = a_.decide(vertex, outwards);
        if (verdict == OutlinePiece::Verdict::leaves) return;
        const int edge = a_.edge_at(vertex, outwards);
        if (edge < 0) return;
        if (verdict == OutlinePiece::Verdict::flat) {
            push_with_a(edge, axis.separation);
            return;
        }
        if (axis.separation > face_preference &&
            corner_to_corner(b_, axis.edge, a_.form, edge, -offset_, true))
            return;
        clip_pieces(b_, axis.edge, a_.form, edge, -offset_, true);
    }

    /// True if a direction is almost the normal of an edge of the outline at the vertex.
    static bool is_face(const OutlinePiece& piece, int vertex, Vec2 direction) {
        const int edge = piece.edge_at(vertex, direction);
        return edge >= 0 && dot(piece.form.normals[edge], direction) > 1.0f - 1e-5f;
    }

    /// True if two corners are nearest to each other; adds the point if this piece reports it.
    bool corner_to_corner(const Convex& reference, int edge, const Convex& other, int incident,
                          Vec2 to_other, bool flipped) {
        const int edge2 = edge + 1 < reference.count ? edge + 1 : 0;
        const int incident2 = incident + 1 < other.count ? incident + 1 : 0;
        float s, t;
        if (!nearest_ends(reference.vertices[edge], reference.vertices[edge2],
                          other.vertices[incident] + to_other, other.vertices[incident2] + to_other,
                          s, t))
            return false;
        const int r = s == 0.0f ? edge : edge2, o = t == 0.0f ? incident : incident2;
        const Vec2 d = other.vertices[o] + to_other - reference.vertices[r];
        const float distance = length(d);
        const Vec2 n = reference.normals[edge];
        if (!(std::fabs(cross(n, d)) > 1e-3f * distance)) return false;
        const Vec2 direction = flipped ? (-1.0f / distance) * d : (1.0f / distance) * d;
        const int on_a = flipped ? o : r, on_b = flipped ? r : o;
        if (a_.decide(on_a, direction) != OutlinePiece::Verdict::pushes) return true;
        if (piece_b_ != nullptr &&
            piece_b_->decide(on_b, -direction) != OutlinePiece::Verdict::pushes)
            return true;
        one_point(a_.form.vertices[on_a], direction, distance, b_.radius, offset_, margin_,
                  feature_of(on_a, on_b), m_);
        m_.corner = distance;
        return true;
    }

    /// Like the function for plain polygons, but points beyond the edge belong to the next piece.
    void clip_pieces(const Convex& reference, int edge, const Convex& other, int incident,
                     Vec2 to_other, bool flipped) {
        const FacingEdges edges(reference, edge, other, incident, to_other);
        if (!edges.are_beside()) edges.clip(flipped, margin_, offset_, m_);
    }

    const OutlinePiece& a_;
    const Convex& b_;
    const OutlinePiece* piece_b_;
    Vec2 offset_;
    float margin_;
    bool had_contact_;
    Manifold& m_;
};

}  // namespace

void collide_piece(const Solid& piece, const Solid& other, Vec2 offset, float margin,
                   bool had_contact, Manifold& m) {
    m.count = 0;
    m.corner = 0.0f;
    const OutlinePiece a(piece);
    if (other.kind == FormKind::ellipse) {
        collide_ellipse(a, ellipse_of(other.form), offset, margin, had_contact, m);
    } else if (other.form.count == 1) {
        collide_circle(a, other.form.vertices[0] + offset, other.form.radius, offset, margin,
                       had_contact, m);
    } else if (other.kind == FormKind::piece) {
        const OutlinePiece b(other);
        PolygonOnPiece(a, other.form, &b, offset, margin, had_contact, m).collide();
    } else {
        PolygonOnPiece(a, other.form, nullptr, offset, margin, had_contact, m).collide();
    }
}

}  // namespace fettle::physics::detail
