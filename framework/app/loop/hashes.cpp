// Hashes of the state of a game: of all of it, and of its parts.

#include <fettle/app/loop.h>

#include <time/state_hash.h>

namespace fettle::app {

std::uint64_t Loop::hash() const {
    StateHash hash;
    hash.add(static_cast<std::uint64_t>(services_.clock.step));
    hash.add(services_.clock.now);
    hash.add_stored_values(tree_);
    for (const SteppedModule& module : modules_) {
        hash.add(module.name);
        if (module.hash) hash.add(module.hash());
    }
    return hash.result();
}

Hashes Loop::hashes() const {
    Hashes all;
    StateHash time, values;
    time.add(services_.clock.now);
    values.add_stored_values(tree_);
    all.emplace_back("time", time.result());
    all.emplace_back("values", values.result());
    for (const SteppedModule& module : modules_)
        if (module.hash) all.emplace_back(module.name, module.hash());
    return all;
}

}  // namespace fettle::app
