#pragma once

#include <fettle/physics/types.h>
#include <geometry/vector.h>

#include <cstdint>
#include <vector>

namespace fettle::physics::detail {

/// Sums over the sub-steps of a step: what changed the velocity of a body. Only bodies that the
/// user asked for have them. They are no part of the state of a world.
struct VelocitySums {
    struct OfContact {
        uint32_t contact = 0;  ///< its slot
        ShapeId own = {}, other = {};
        BodyId body = {};
        Vec2 impulse = {};
        float counted[2] = {};  ///< normal impulses of its points, in `impulse`
    };
    struct OfJoint {
        uint32_t slot = 0;
        JointId joint{};
        Vec2 impulse{};
    };

    BodyId body = {};
    uint64_t step = 0;         ///< number of steps at the end of the summed one; 0: none yet
    uint32_t solver_body = 0;  ///< 0: it took no part in the step
    uint32_t block = 0;        ///< of the solver
    Vec2 inverse_mass = {};    ///< 0 along a locked axis
    Vec2 earlier = {}, before = {}, after = {};
    Vec2 last = {};  ///< velocity at the end of the last sub-step
    Vec2 gravity = {}, force = {}, applied = {}, fields = {}, damping = {};
    std::vector<OfContact> contacts = {};
    std::vector<OfJoint> joints = {};
};

}  // namespace fettle::physics::detail
