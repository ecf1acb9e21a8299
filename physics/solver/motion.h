#pragma once

#include <constraints/solver_body.h>

#include <cstdint>
#include <span>

// What moves bodies besides constraints, and what contacts give them again in every sub-step.
//
// Each sub-step begins with the impulses that the last one found (warm start). Contacts keep their
// normals and lever arms during a step, so what their impulses do to the velocity of a body is just
// what they did to it in the sub-step before, all passes together: its velocity at the end less
// that before the warm start. So only the first sub-step of a step warm starts contact by contact.

namespace fettle::physics::detail {

struct SubstepLimits {
    float speed = 0.0f;  ///< m/s
    float turn = 0.0f;   ///< rad/s
};

/// Of the bodies listed in `which`. `again`: contacts give each what they gave it in the last
/// sub-step.
void integrate_velocities(std::span<const uint32_t> which, std::span<SolverBody> bodies,
                          std::span<SolverForce> forces, const SubstepLimits& limits, bool again);
void integrate_positions(std::span<const uint32_t> which, std::span<SolverBody> bodies, float h);

}  // namespace fettle::physics::detail
