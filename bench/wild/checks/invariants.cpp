// The table of invariants.

#include <array>

#include "wild/checks/check.h"

namespace fettle::bench::wild {

std::span<const Invariant> invariants() {
    static const std::array table = {
        Invariant{"finite", "positions and velocities are numbers", check_finite},
        Invariant{"through", "no body passes through a static or kinematic body", check_through},
        Invariant{"bullets", "bullets and moving bodies do not pass through each other",
                  check_bullets},
        Invariant{"frozen", "a body with a speed moves", check_frozen},
        Invariant{"energy", "energy does not increase without a cause", check_energy},
        Invariant{"momentum", "collisions keep the total momentum", check_momentum},
        Invariant{"speed", "no body is much faster than the source of its motion", check_speed},
        Invariant{"joints", "joints hold their bodies together", check_joints},
        Invariant{"events", "every begin has its end", check_events},
        Invariant{"sensors", "a sensor reports the bodies that enter it", check_sensors},
        Invariant{"rest", "bodies that can rest come to rest in time", check_rest},
        Invariant{"consistent", "the lists of the world agree", check_consistent},
    };
    return table;
}

}  // namespace fettle::bench::wild
