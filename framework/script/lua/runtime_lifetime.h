#pragma once
// The lifetime of a runtime: it ends when the host has destroyed it and none of its scripts runs.

#include <memory>
#include <utility>

#include <fettle/property/tree.h>

namespace fettle::script {

struct RuntimeLifetime {
    std::weak_ptr<const property::Tree*> tree;  // expired: the tree was destroyed
    bool in_tree = true;                        // false: the runtime has left its tree
    int uses = 0;                               // entries into Lua that have not returned
    std::shared_ptr<void> orphan;               // keeps a runtime alive that the host destroyed

    /// Whether the tree exists and the runtime belongs to it.
    bool has_tree() const { return in_tree && !tree.expired(); }

    /// Keeps the runtime alive during a call into it, because the call may destroy it.
    class Use {
      public:
        explicit Use(RuntimeLifetime& life) : life_(life) { ++life_.uses; }
        ~Use() {
            if (--life_.uses == 0) const std::shared_ptr<void> dead = std::move(life_.orphan);
        }
        Use(const Use&) = delete;

      private:
        RuntimeLifetime& life_;
    };
};

}  // namespace fettle::script
