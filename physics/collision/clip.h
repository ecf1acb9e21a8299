#pragma once

#include <collision/manifold.h>

// Clipping of two edges that face each other; used for all pairs of polygons.

namespace fettle::physics::detail {

/// The edge whose normal is most opposed to `normal`.
inline int incident_edge(const Convex& shape, Vec2 normal) {
    int edge = 0;
    float least = dot(normal, shape.normals[0]);
    for (int i = 1; i < shape.count; ++i) {
        const float d = dot(normal, shape.normals[i]);
        if (d < least) {
            least = d;
            edge = i;
        }
    }
    return edge;
}

inline uint16_t feature_of(int vertex_a, int vertex_b) {
    return uint16_t((vertex_a & 255) << 8 | (vertex_b & 255));
}

/// Nearest points of two segments that do not cross, as fractions of each. True if both points are
/// ends.
inline bool nearest_ends(Vec2 p1, Vec2 p2, Vec2 q1, Vec2 q2, float& s, float& t) {
    // C. Ericson, "Real-Time Collision Detection", 5.1.9.
    const Vec2 d1 = p2 - p1, d2 = q2 - q1, r = p1 - q1;
    const float a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r), b = dot(d1, d2);
    const float denominator = a * e - b * b;
    s = denominator > 1e-12f * a * e ? clamp((b * f - c * e) / denominator, 0.0f, 1.0f) : 0.0f;
    t = e > 0.0f ? (b * s + f) / e : 0.0f;
    if (t < 0.0f) {
        t = 0.0f;
        s = a > 0.0f ? clamp(-c / a, 0.0f, 1.0f) : 0.0f;
    } else if (t > 1.0f) {
        t = 1.0f;
        s = a > 0.0f ? clamp((b - c) / a, 0.0f, 1.0f) : 0.0f;
    }
    return (s == 0.0f || s == 1.0f) && (t == 0.0f || t == 1.0f);
}

/// The incident edge of `other` in front of the reference edge. All data are in the frame of
/// `reference`; `to_other` is the origin of `other` in it.
class FacingEdges {
  public:
    FacingEdges(const Convex& reference, int edge, const Convex& other, int incident, Vec2 to_other)
        : reference_(reference),
          other_(other),
          edge_(edge),
          edge2_(edge + 1 < reference.count ? edge + 1 : 0),
          incident_(incident),
          incident2_(incident + 1 < other.count ? incident + 1 : 0),
          n_(reference.normals[edge]),
          w1_(other.vertices[incident2_] + to_other),
          w2_(other.vertices[incident_] + to_other) {
        // The incident edge runs against the reference edge: its second vertex is at the
        // reference's first.
        const Vec2 tangent = {-n_.y, n_.x};
        low_ = dot(tangent, reference.vertices[edge_]);
        high_ = dot(tangent, reference.vertices[edge2_]);
        x1_ = dot(tangent, w1_);
        x2_ = dot(tangent, w2_);
    }

    /// End against end, with so little overlap that a contact would kick the shapes.
    bool are_a_seam() const {
        const float facing = min(high_, x2_) - max(low_, x1_);
        const bool inside = (x1_ >= low_ && x2_ <= high_) || (low_ >= x1_ && high_ <= x2_);
        return !inside && facing < min(seam, 0.1f * min(high_ - low_, x2_ - x1_)) &&
               reference_.radius + other_.radius == 0.0f;
    }
    /// True if no part of one edge faces the other.
    bool are_beside() const { return x2_ < low_ || x1_ > high_; }

    /// The ends of the incident edge, clipped at the ends of the reference edge. `flipped`: the
    /// reference belongs to shape b of the manifold; `offset` leads from a to b.
    void clip(bool flipped, float margin, Vec2 offset, Manifold& m) const {
        const float run = x2_ - x1_;
        const Vec2 along = w2_ - w1_;
        Vec2 c1 = w1_, c2 = w2_;
        if (x2_ < low_) {
            c1 = w2_;  // the edges do not face each other: only the nearer end remains
        } else if (x1_ > high_) {
            c2 = w1_;
        } else {
            if (x1_ < low_ && run > 1e-9f) c1 = w1_ + ((low_ - x1_) / run) * along;
            if (x2_ > high_ && run > 1e-9f) c2 = w1_ + ((high_ - x1_) / run) * along;
        }
        const float radii = reference_.radius + other_.radius;
        const float plane = reference_.offsets[edge_];
        const Vec2 candidates[2] = {c1, c2};
        const int reference_vertex[2] = {edge_, edge2_};
        const int other_vertex[2] = {incident2_, incident_};
        m.normal = flipped ? -n_ : n_;
        m.count = 0;
        for (int k = 0; k < 2; ++k) {
            const float gap = dot(n_, candidates[k]) - plane;
            const float separation = gap - radii;
            if (separation > margin) continue;
            // Midway between the two surfaces.
            const Vec2 middle =
                candidates[k] + (0.5f * (reference_.radius - other_.radius - gap)) * n_;
            ManifoldPoint& point = m.points[m.count++];
            point.anchor_a = flipped ? middle + offset : middle;
            point.anchor_b = flipped ? middle : middle - offset;
            point.separation = separation;
            point.normal_impulse = 0.0f;
            point.tangent_impulse = 0.0f;
            point.feature = flipped ? feature_of(other_vertex[k], reference_vertex[k])
                                    : feature_of(reference_vertex[k], other_vertex[k]);
        }
    }

  private:
    const Convex& reference_;
    const Convex& other_;
    int edge_, edge2_, incident_, incident2_;
    Vec2 n_, w1_, w2_;
    float low_, high_, x1_, x2_;
};

}  // namespace fettle::physics::detail
