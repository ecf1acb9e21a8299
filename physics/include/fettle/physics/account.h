#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// The part of a contact of two shapes in the change of a velocity.
struct ContactShare {
    ShapeId own;         ///< the shape of the body
    ShapeId other;       ///< the shape that it touches
    BodyId body;         ///< of `other`; the border has the slot 0
    Vec2 impulse = {};   ///< N s, on the body of `own`
    Vec2 change = {};    ///< m/s
    float twist = 0.0f;  ///< N m s, about the center of mass of that body
    float turn = 0.0f;   ///< rad/s
};

/// The part of a joint in the change of a velocity.
struct JointShare {
    JointId joint;       ///< on the body
    Vec2 impulse = {};   ///< N s, on the body
    Vec2 change = {};    ///< m/s
    float twist = 0.0f;  ///< N m s, about its center of mass
    float turn = 0.0f;   ///< rad/s
};

/// The changes of the angular velocity of a body in a step, besides those by contacts and joints.
struct TurnAccount {
    float earlier = 0.0f;  ///< rad/s at the end of the step before; `before` if it is unknown
    float before = 0.0f;   ///< rad/s at the start of the step
    float after = 0.0f;    ///< rad/s at its end
    float torque = 0.0f;   ///< rad/s, as all that follow; by `Body::torque`
    float applied = 0.0f;  ///< by `Body::apply_torque` and by forces beside the center of mass
    float fields = 0.0f;   ///< by fields of force
    float damping = 0.0f;  ///< by damping
    /// Other changes: limits of speed, bounces of curved shapes, the answer of joints to a blow,
    /// rounding.
    float rest = 0.0f;
    /// The sum of the sizes of all changes, also of those that cancel: rounding errors are small
    /// compared with it.
    float size = 0.0f;
};

/// The changes of the velocity of a body in a step: `after` - `before` is their sum.
struct VelocityAccount {
    Vec2 earlier = {};  ///< m/s at the end of the step before; `before` if it is unknown
    Vec2 before = {};   ///< m/s at the start of the step
    Vec2 after = {};    ///< m/s at its end
    Vec2 gravity = {};  ///< m/s, as all that follow
    Vec2 force = {};    ///< by `Body::force`
    Vec2 applied = {};  ///< by `Body::apply_force`
    Vec2 fields = {};   ///< by fields of force
    Vec2 damping = {};  ///< by `Body::linear_damping`
    std::vector<ContactShare> contacts;  ///< by contacts, one each
    std::vector<JointShare> joints;      ///< by joints, one each
    /// Other changes: locked axes, limits of speed, the answer of joints to a blow, rounding.
    Vec2 rest = {};
    TurnAccount turn = {};  ///< what changed the angular velocity
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
