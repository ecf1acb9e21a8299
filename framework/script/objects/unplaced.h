#pragma once
// Instances that a script made and never gave a place. Whether a script still holds one, only the
// collector knows; so that runs are the same, it is asked at fixed moments (the beginning of a
// step, once enough of them have gathered), never whenever it happens to run.

#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

struct Machine;

struct Unplaced {
    std::vector<property::Handle> handles;
    std::size_t limit = 64;  // so many make a collection worth its time
};

/// Destroys those that nothing refers to.
void collect_unplaced(Machine& machine);

}  // namespace fettle::script
