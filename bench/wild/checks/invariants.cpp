// The table of invariants.

#include <array>

#include "wild/checks/check.h"

namespace fettle::bench::wild {

std::span<const Invariant> invariants() {
    static const std::array table = {
        Invariant{"finite", "positions and velocities are numbers", check_finite},
        Invariant{"through", "nothing passes through what is static or kinematic", check_through},
        Invariant{"bullets", "bullets and moving bodies do not pass through each other",
                  check_bullets},
        Invariant{"frozen", "what has a speed moves", check_frozen},
        Invariant{"energy", "energy does not come from nowhere", check_energy},
        Invariant{"momentum", "bodies that only meet each other keep their momentum",
                  check_momentum},
        Invariant{"speed", "nothing is much faster than what drives it", check_speed},
        Invariant{"joints", "joints hold", check_joints},
        Invariant{"events", "every begin has its end", check_events},
        Invariant{"sensors", "a sensor tells of what crosses it", check_sensors},
        Invariant{"rest", "what can rest rests in time", check_rest},
        Invariant{"consistent", "the lists of the world agree", check_consistent},
    };
    return table;
}

}  // namespace fettle::bench::wild
