#pragma once

#include <collision/manifold.h>

#include <span>

namespace fettle::physics::detail {

/// How the vertices of a shape are meant. What is no plain convex form goes through
/// `collide_unusual`, so that the common pairs ask one question.
enum class FormKind : uint8_t {
    convex,   ///< a convex polygon grown by a radius; one vertex: a circle, two: a capsule
    border,   ///< a half-plane of the border
    ellipse,  ///< its center; collision/ellipse.h tells where its axes are
    large,    ///< a convex polygon of many vertices, see collision/large_polygon.h
    piece,    ///< a convex part of a longer outline, see collision/piece.h
    outline   ///< of many pieces, each a shape of its own: nothing collides with it itself
};

/// A shape of any kind but the border, where it is.
struct Solid {
    Convex form;
    FormKind kind = FormKind::convex;
    Rotation rotation = {};       ///< of a large polygon, whose vertices are not; of a piece
    const V2* limits = nullptr;   ///< of a piece
    const V2* normals = nullptr;  ///< of a piece: of its edges, body coordinates
};

/// The points of two shapes that are nearest to each other, from the center of mass of a.
struct Nearest {
    float distance = 0.0f;  ///< 0 where they overlap: then the points are the same, inside both
    V2 on_a, on_b;
    V2 normal;  ///< from a to b; of no length where they overlap
};

}  // namespace fettle::physics::detail
