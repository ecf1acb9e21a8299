// The table of invariants.

#include <array>

#include "wild/checks/check.h"

namespace fettle::bench::wild {

std::span<const Invariant> invariants() {
    static const std::array table = {
        // Positions and velocities are numbers.
        Invariant{"finite", check_finite},
        // No body passes through a static or kinematic body.
        Invariant{"through", check_through},
        // Bullets and moving bodies do not pass through each other.
        Invariant{"bullets", check_bullets},
        // A body with a speed moves.
        Invariant{"frozen", check_frozen},
        // Energy does not increase without a cause.
        Invariant{"energy", check_energy},
        // Collisions keep the total momentum.
        Invariant{"momentum", check_momentum},
        // No body is much faster than the source of its motion.
        Invariant{"speed", check_speed},
        // Joints hold their bodies together.
        Invariant{"joints", check_joints},
        // Every begin has its end.
        Invariant{"events", check_events},
        // A sensor reports the bodies that enter it.
        Invariant{"sensors", check_sensors},
        // Bodies that can rest come to rest in time.
        Invariant{"rest", check_rest},
        // The lists of the world agree.
        Invariant{"consistent", check_consistent},
    };
    return table;
}

}  // namespace fettle::bench::wild
