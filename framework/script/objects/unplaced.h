#pragma once
// Instances that a script created and never placed. Only Lua's garbage collector can determine
// whether a script still holds one. A full collection is made at fixed moments (at the beginning of
// a step, if there are enough such instances), so that runs are the same.

#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

struct Machine;

struct Unplaced {
    std::vector<property::Handle> handles;
    std::size_t limit = 64;  // number of instances for which a collection is worth its time
};

/// Destroys unplaced instances to which nothing refers.
void collect_unplaced(Machine& machine);

}  // namespace fettle::script
