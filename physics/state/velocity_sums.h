#pragma once

#include <fettle/physics/types.h>
#include <geometry/vector.h>
#include <state/records.h>

#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// Sums over the sub-steps of a step: the changes of the velocity of a body, by their causes. Only
/// the bodies that the user requested have them. They are not part of the state of a world.
struct VelocitySums {
    struct OfContact {
        uint32_t contact = 0;  ///< its slot
        ShapeId own = {}, other = {};
        BodyId body = {};
        Vec2 impulse = {};
        float twist = 0.0f;     ///< angular impulse about the center of mass
        float counted[2] = {};  ///< normal impulses of its points, in `impulse`
        // Of a contact of curved surfaces, whose levers change after the biased pass of a sub-step:
        Vec2 biased = {};           ///< impulses of that pass along the normal and the tangent
        Vec2 biased_impulse = {};   ///< their sum in the world
        float biased_twist = 0.0f;  ///< their angular impulse
    };
    struct OfJoint {
        uint32_t slot = 0;
        JointId joint{};
        Vec2 impulse{};
        float twist = 0.0f;
        // Of the sub-step so far. The levers change within it, so each pass is added at once:
        decltype(JointRecord::impulses) known{};  ///< the impulses that are already added
        Vec2 now_impulse = {};
        float now_twist = 0.0f;
        float now_moment = 0.0f;  ///< the greatest push times its lever
    };
    /// The same for the angular velocity.
    struct OfTurn {
        float inverse_inertia = 0.0f;  ///< 0 if the rotation is locked
        float earlier = 0.0f, before = 0.0f, after = 0.0f, last = 0.0f;
        float torque = 0.0f, applied = 0.0f, fields = 0.0f, damping = 0.0f;
        float size = 0.0f;  ///< sum of the sizes of the angular impulses
    };

    BodyId body = {};
    uint64_t step = 0;         ///< number of steps at the end of the summed one; 0: none yet
    uint32_t solver_body = 0;  ///< 0: it took no part in the step
    uint32_t block = 0;        ///< of the solver
    Vec2 inverse_mass = {};    ///< 0 along a locked axis
    Vec2 earlier = {};         ///< velocity at the end of the step before
    Vec2 before = {};          ///< at the beginning of this step: edits may have changed it
    Vec2 after = {};           ///< at the end of this step
    Vec2 last = {};            ///< at the end of the last sub-step
    /// The share of the step after an impact that ended the motion of the body: forces do not act
    /// in it.
    float without_forces = 0.0f;
    Vec2 gravity = {}, force = {}, applied = {}, fields = {}, damping = {};
    OfTurn turn = {};
    std::vector<OfContact> contacts = {};
    std::vector<OfJoint> joints = {};
};

}  // namespace fettle::physics::detail
