#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <array>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// A point of a contact.
struct ContactPoint {
    Position point = {};      ///< world, m
    float separation = 0.0f;  ///< m, negative: overlap
    float normal_impulse =
        0.0f;  ///< N s in one sub-step; multiply by the sub-step rate for newtons
    float tangent_impulse = 0.0f;  ///< N s in one sub-step
    uint16_t feature = 0;          ///< identifies the vertex and edge between steps
};

/// A contact between two shapes as it was in the last step. The normal points from a to b. One of
/// the bodies may be the world's border (`ShapeType::border`).
struct Contact {
    BodyId body_a;                       ///< of `shape_a`
    BodyId body_b;                       ///< of `shape_b`
    ShapeId shape_a;                     ///< the normal points away from it
    ShapeId shape_b;                     ///< the normal points towards it
    Vec2 normal = {};                    ///< from a to b; its length is 1
    int point_count = 0;                 ///< 1 or 2
    std::array<ContactPoint, 2> points;  ///< the first `point_count` of them
    float friction = 0.0f;               ///< mixed
    float restitution = 0.0f;            ///< mixed
    float normal_force = 0.0f;           ///< N, mean over the last sub-step, sum of both points
    /// Which segment of a chain, or which piece of a concave polygon: its place in `Shape::pieces`.
    /// 0 for other shapes.
    uint32_t part_a = 0;
    uint32_t part_b = 0;      ///< the same of `shape_b`
    uint32_t material_a = 0;  ///< of `shape_a`, or of the segment of a chain
    uint32_t material_b = 0;  ///< of `shape_b`, or of the segment of a chain

    /// The same in all events of this touch.
    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
