#pragma once
// Instances that a script created and never placed. Only Lua's garbage collector can determine
// whether a script still holds one. A full collection is made at fixed moments (at the beginning of
// a step, if there are enough such instances), so that runs are the same.

#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

struct Machine;

struct UnplacedInstances {
    std::vector<property::Handle> handles;
    std::size_t limit = 64;  // number of instances for which a collection is worth its time

    /// The instances added since the last call; `all`: the whole list, since some were removed.
    struct Changes {
        bool all = true;
        std::vector<property::Handle> handles;
        std::size_t limit = 64;
    };
    Changes take_changes();
    void redo(const Changes& changes);
    void restore(std::vector<property::Handle> those, std::size_t its_limit);

    std::size_t taken = 0;  // how many of them `take_changes` returned
    bool removed = true;    // some were removed since then, or it was not called yet
};

/// The unplaced instances to which nothing refers. Makes a full collection.
std::vector<property::Handle> dropped_instances(Machine& machine);
/// Destroys unplaced instances to which nothing refers.
void collect_unplaced(Machine& machine);

}  // namespace fettle::script
