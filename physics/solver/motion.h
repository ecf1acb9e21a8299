#pragma once

#include <constraints/solver_body.h>

#include <cstdint>
#include <span>

// Integration of velocities and positions, and the warm start of sub-steps after the first.
//
// Each sub-step begins with the impulses of the previous sub-step (warm start). Contacts keep their
// normals and lever arms during a step. So these impulses change the velocity of a body by the same
// amount as all passes of the previous sub-step did: by its velocity at the end minus the velocity
// before the warm start. So only the first sub-step of a step warm starts contact by contact.

namespace fettle::physics::detail {

struct SubstepLimits {
    float speed = 0.0f;  ///< m/s
    float turn = 0.0f;   ///< rad/s
};

/// Integrates the bodies listed in `which`. `again`: adds the change of velocity that contacts
/// caused in the previous sub-step.
void integrate_velocities(std::span<const uint32_t> which, std::span<SolverBody> bodies,
                          std::span<SolverForce> forces, const SubstepLimits& limits, bool again);
void integrate_positions(std::span<const uint32_t> which, std::span<SolverBody> bodies, float h);

}  // namespace fettle::physics::detail
