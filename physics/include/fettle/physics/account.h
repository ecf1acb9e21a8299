#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// The part of a contact of two shapes in the change of a velocity.
struct ContactShare {
    ShapeId own;        ///< the shape of the body
    ShapeId other;      ///< the shape that it touches
    BodyId body;        ///< of `other`; the border has the slot 0
    Vec2 impulse = {};  ///< N s, on the body of `own`
    Vec2 change = {};   ///< m/s
};

/// The part of a joint in the change of a velocity.
struct JointShare {
    JointId joint;      ///< on the body
    Vec2 impulse = {};  ///< N s, on the body
    Vec2 change = {};   ///< m/s
};

/// What changed the velocity of a body in a step: `after` - `before` is the sum of all changes.
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
    /// What has no other name: locked axes, limits of speed, the answer of joints to a blow,
    /// rounding.
    Vec2 rest = {};
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
