#pragma once

#include <collision/manifold.h>
#include <fettle/physics/definitions.h>
#include <geometry/mass.h>
#include <geometry/vertex_pool.h>

// Exact ellipses; they are not approximated by polygons.

namespace fettle::physics::detail {

/// An ellipse at its pose, relative to the center of mass of its body.
struct EllipseForm {
    Vec2 center;
    Vec2 axis;  ///< unit vector along the first radius
    float first = 0.0f, second = 0.0f;

    /// The farthest point along a direction.
    Vec2 support(Vec2 direction) const;
    /// Distance from the center to the farthest point along a unit vector.
    float reach(Vec2 direction) const;
};

// An ellipse uses two vertices: the center, with the axis as its normal; the two radii.
void write_ellipse(const Ellipse& ellipse, Vec2* vertices, Vec2* normals);
void write_ellipse(const Ellipse& ellipse, uint32_t begin, VertexPool& pool);
inline EllipseForm ellipse_of(const Convex& form) {
    return {form.vertices[0], form.normals[0], form.vertices[1].x, form.vertices[1].y};
}

Vec2 half_box(const EllipseForm& ellipse);  ///< half the sides of its bounding box
AreaMoments moments_of(const Ellipse& ellipse);

/// The nearest point to `p` on the rim, and the outward normal there; `distance` is negative
/// inside.
struct RimPoint {
    Vec2 point, normal;
    float distance = 0.0f;
};
RimPoint nearest_on_rim(const EllipseForm& ellipse, Vec2 p);

/// Gap between an ellipse and another shape, along the line of least distance or least overlap.
struct EllipseGap {
    Vec2 normal;  ///< from the ellipse to the other
    Vec2 on_ellipse, on_other;
    float separation = 0.0f;  ///< of the cores: without the radius of the other shape
    int edge = -1;            ///< of the other shape, if the normal is that of an edge
    int vertex = -1;          ///< of the other shape, if it is not
};
/// `offset` is the origin of the other shape minus that of the ellipse; the result is in the frame
/// of the ellipse.
EllipseGap gap_between(const EllipseForm& ellipse, const Convex& other, Vec2 offset);
EllipseGap gap_between(const EllipseForm& ellipse, const EllipseForm& other, Vec2 offset);

}  // namespace fettle::physics::detail
