#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <cstdint>
#include <vector>

// For hosts that read and write the bodies of a world by slot, without handles: `World::state`,
// `World::write`.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Result of writing a number or a velocity by slot. `same`: the value was there already. `done`:
/// the value is written. `refused`: nothing is written, and the setter of `Body` must be called
/// instead. Reasons: the body sleeps, does not move by itself, has a mass or shapes that were
/// edited since the last step, or the world is locked (callbacks.h). Writing calls no callback and
/// allocates nothing.
enum class Written : uint8_t { same, done, refused };

/// Numbers of a body that hosts write by slot, named like the setters of `Body`. These setters
/// document the ranges; writing by slot does not check them.
enum class BodyNumber : uint8_t {
    /// `Body::set_angular_velocity`
    angular_velocity,
    /// `Body::set_torque`
    torque,
    /// `Body::set_gravity_scale`
    gravity_scale,
    /// `Body::set_linear_damping`
    linear_damping,
    /// `Body::set_angular_damping`
    angular_damping
};

namespace detail {
/// Data that are read too often for function calls: arrays with the index `BodyId::index`.
struct Columns {
    std::vector<BodyState> states;
    std::vector<Pose> previous;
    std::vector<uint32_t> body_generations;   ///< 0 where a slot is free
    std::vector<uint32_t> shape_generations;  ///< by `ShapeId::index`
    std::vector<uint32_t> joint_generations;  ///< by `JointId::index`

    /// Whether the object exists in this world.
    bool is_valid(BodyId id) const { return lives(body_generations, id.index, id.generation); }
    bool is_valid(ShapeId id) const { return lives(shape_generations, id.index, id.generation); }
    bool is_valid(JointId id) const { return lives(joint_generations, id.index, id.generation); }

  private:
    static bool lives(const std::vector<uint32_t>& generations, uint32_t index,
                      uint32_t generation) {
        return generation != 0 && index < generations.size() && generations[index] == generation;
    }
};
}  // namespace detail

}  // namespace fettle::physics

FETTLE_PHYSICS_END
