#pragma once

#include <cstddef>
#include <cstdint>

#include <fettle/physics/export.h>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Statistics of the last step.
struct StepStatistics {
    uint64_t steps = 0;            ///< since the world was created
    uint32_t bodies = 0;           ///< of all types
    uint32_t awake_bodies = 0;     ///< dynamic and moving kinematic ones
    uint32_t shapes = 0;           ///< detached ones, too
    uint32_t joints = 0;           ///< without dormant ones
    uint32_t awake_joints = 0;     ///< joints that a step processes
    uint32_t contacts = 0;         ///< pairs whose fat boxes overlap
    uint32_t awake_contacts = 0;   ///< contacts that a step processes
    uint32_t touching = 0;         ///< awake contacts with a manifold that was solved
    uint32_t islands = 0;          ///< sleeping islands
    uint32_t moved_proxies = 0;    ///< proxies that left their fat box
    uint32_t direct_solves = 0;    ///< complementarity problems that the direct solver solved
    uint32_t direct_failures = 0;  ///< problems that were too large or had no solution: solved by
                                   ///< sweeps over their rows instead
    // Wall time of each stage, ms. A saved world does not have these times: restored, they are 0.
    float edits_ms = 0.0f;   ///< derived data of edited bodies and shapes
    float pairs_ms = 0.0f;   ///< broad phase
    float narrow_ms = 0.0f;  ///< manifolds
    float solve_ms = 0.0f;   ///< prepare, sub-steps, store
    float finish_ms = 0.0f;  ///< poses, boxes, continuous collision
    float sleep_ms = 0.0f;   ///< islands
    float total_ms = 0.0f;   ///< the whole step
};

/// Memory that a world has reserved for one purpose, bytes.
struct MemoryShare {
    const char* purpose = "";  ///< what it is for, "contacts"
    std::size_t used = 0;      ///< bytes in use
    std::size_t reserved = 0;  ///< including reserved room
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
