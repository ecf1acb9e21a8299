#pragma once

#include <geometry/vector.h>

#include <cstdint>

namespace fettle::physics::detail {

/// Separations that differ by less than this count as equal (m): the choice between faces that are
/// equally deep is stable, so that contacts do not flip.
inline constexpr float face_preference = 0.0005f;

/// Two edges that overlap end against end by less than this (m) and less than a tenth of either do
/// not stop each other: otherwise a shape that slides over a floor of tiles would be kicked by the
/// side of every tile.
inline constexpr float seam = 0.005f;

/// A convex shape at its pose: vertices, edge normals and n·v of each edge, already rotated but
/// relative to the center of mass of its body. All contacts of the shape use the same rotated data,
/// and no precision is lost far from the origin. One vertex is a circle, two are a segment (its two
/// sides are its two edges).
struct Convex {
    const V2* vertices;
    const V2* normals;
    const float* offsets;
    int count;
    float radius;
};

struct ManifoldPoint {
    V2 anchor_a;  ///< from the center of mass of body a to the point, world axes
    V2 anchor_b;
    float separation = 0.0f;
    float normal_impulse = 0.0f;
    float tangent_impulse = 0.0f;
    uint32_t feature = 0;  ///< vertex of a << 8 | vertex of b
};

struct Manifold {
    V2 normal;  ///< from a to b
    int count = 0;
    float corner = 0.0f;  ///< distance of the cores at a corner contact, m; else 0
    ManifoldPoint points[2];
};

// Wide collisions read and write four numbers at a time: `normal` to `corner`, both anchors, and
// `separation` to `feature`.
static_assert(sizeof(ManifoldPoint) == 32 && sizeof(Manifold) == 80);

/// Contact points of a and b that are closer than `margin` (m); `offset` is the center of mass of b
/// minus that of a. Sets normal, count, anchors, separations and features; leaves impulses zero.
void collide(const Convex& a, const Convex& b, V2 offset, float margin, Manifold& manifold);

/// Contact with the half-plane of points p with normal·p <= depth, p relative to `offset` from the
/// center of mass of b: a is solid there. The normal points out of it.
void collide_half_plane(V2 normal, float depth, const Convex& b, V2 center_b, float margin,
                        Manifold& manifold);

}  // namespace fettle::physics::detail
