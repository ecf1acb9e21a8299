#pragma once

#include <collision/manifold.h>

#include <span>

namespace fettle::physics::detail {

/// The kind of a shape's form. Forms that are not plain convex are handled by
/// `collide_special_forms`, so that common pairs need one test. It has 32 bits because compilers
/// for Windows put two bit fields into one word only if their types have the same size.
enum class FormKind : uint32_t {
    convex,   ///< a convex polygon grown by a radius; one vertex: a circle, two: a capsule
    border,   ///< a half-plane of the world's border
    ellipse,  ///< its center; collision/ellipse.h describes its axes
    large,    ///< a convex polygon of many vertices, see collision/large_polygon.h
    piece,    ///< a convex part of a longer outline, see collision/outline_piece.h
    outline   ///< an outline: its pieces collide instead
};

/// A shape of any kind but the border, at its pose.
struct Solid {
    Convex form;
    FormKind kind = FormKind::convex;
    Rotation rotation = {};         ///< of a large polygon or a piece
    const Vec2* limits = nullptr;   ///< of a piece
    const Vec2* normals = nullptr;  ///< of a piece: normals of its edges, body coordinates
};

/// The nearest points of two shapes, relative to the center of mass of a.
struct Nearest {
    float distance = 0.0f;  ///< 0 when they overlap; then both points are equal
    Vec2 on_a, on_b;
    Vec2 normal;  ///< from a to b; zero when they overlap
};

}  // namespace fettle::physics::detail
