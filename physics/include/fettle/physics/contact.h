#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <array>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

struct ContactPoint {
    Vec2 point = {};          ///< world, m
    float separation = 0.0f;  ///< m, negative: overlap
    float normal_impulse =
        0.0f;  ///< N s in one sub-step; multiply by the sub-step rate for newtons
    float tangent_impulse = 0.0f;  ///< N s in one sub-step
    uint16_t feature = 0;          ///< identifies the vertex and edge between steps
};

/// A contact between two shapes as it was in the last step. The normal points from a to b. One of
/// the bodies may be the world's border (`ShapeType::border`).
struct Contact {
    BodyId body_a;
    BodyId body_b;
    ShapeId shape_a;
    ShapeId shape_b;
    Vec2 normal = {};
    int point_count = 0;
    std::array<ContactPoint, 2> points;
    float friction = 0.0f;      ///< mixed
    float restitution = 0.0f;   ///< mixed
    float normal_force = 0.0f;  ///< N, mean over the last sub-step, sum of both points

    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
