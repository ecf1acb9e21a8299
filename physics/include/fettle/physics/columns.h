#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <cstdint>
#include <vector>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics::detail {

/// Data that are read too often for function calls: arrays with the index `BodyId::index`. Hosts
/// read them by `HostAccess` (host_access.h).
struct Columns {
    std::vector<BodyState> states;
    std::vector<Pose> previous;
    std::vector<uint32_t> body_generations;   ///< 0 where a slot is free
    std::vector<uint32_t> shape_generations;  ///< by `ShapeId::index`
    std::vector<uint32_t> joint_generations;  ///< by `JointId::index`

    /// Whether the object exists in this world.
    bool is_valid(BodyId id) const noexcept {
        return lives(body_generations, id.index, id.generation);
    }
    bool is_valid(ShapeId id) const noexcept {
        return lives(shape_generations, id.index, id.generation);
    }
    bool is_valid(JointId id) const noexcept {
        return lives(joint_generations, id.index, id.generation);
    }

  private:
    static bool lives(const std::vector<uint32_t>& generations, uint32_t index,
                      uint32_t generation) noexcept {
        return generation != 0 && index < generations.size() && generations[index] == generation;
    }
};

}  // namespace fettle::physics::detail

FETTLE_PHYSICS_END
