#pragma once

#include <geometry/vector.h>

#include <cstdint>

namespace fettle::physics::detail {

/// Separations that differ by less than this (m) count as equal. So the choice between equally deep
/// faces is stable, and contacts do not flip.
inline constexpr float face_preference = 0.0005f;

/// Two edges that overlap end against end by less than this (m), and by less than a tenth of
/// either, do not stop each other. Otherwise the side of every tile would kick a shape that slides
/// over a tiled floor.
inline constexpr float seam = 0.005f;

/// A convex shape at its pose: vertices, edge normals, and n·v of each edge. They are already
/// rotated, but relative to the center of mass of the body. All contacts of the shape use the same
/// rotated data, and no precision is lost far from the origin. One vertex is a circle, two are a
/// segment (its two sides are its two edges).
struct Convex {
    const Vec2* vertices;
    const Vec2* normals;
    const float* offsets;
    int count;
    float radius;
};

struct ManifoldPoint {
    Vec2 anchor_a;  ///< from the center of mass of body a to the point, world axes
    Vec2 anchor_b;
    float separation = 0.0f;
    float normal_impulse = 0.0f;
    float tangent_impulse = 0.0f;
    uint32_t feature = 0;  ///< vertex of a << 8 | vertex of b
};

struct Manifold {
    Vec2 normal;  ///< from a to b
    int count = 0;
    float corner = 0.0f;  ///< distance of the cores at a corner contact, m; else 0
    ManifoldPoint points[2];

    /// A contact of one point, at `at` from the center of mass of a; `offset` is that of b.
    void set_point(Vec2 along, Vec2 at, Vec2 offset, float separation, uint32_t feature) {
        normal = along;
        points[0] = {at, at - offset, separation, 0.0f, 0.0f, feature};
        count = 1;
    }
};

// Wide collisions read and write four numbers at a time: `normal` to `corner`, both anchors, and
// `separation` to `feature`. So the layout must not change.
static_assert(sizeof(ManifoldPoint) == 32 && sizeof(Manifold) == 80);

/// Contact points of a and b that are closer than `margin` (m); `offset` is the center of mass of b
/// minus that of a. Sets normal, count, anchors, separations and features; leaves impulses zero.
void collide(const Convex& a, const Convex& b, Vec2 offset, float margin, Manifold& manifold);

/// Contact with the half-plane of the points p with normal·p <= depth, which is solid. `center_b`:
/// center of mass of b in the same coordinates. The normal points out of the half-plane.
void collide_half_plane(Vec2 normal, float depth, const Convex& b, Vec2 center_b, float margin,
                        Manifold& manifold);

}  // namespace fettle::physics::detail
