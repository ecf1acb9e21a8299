#pragma once
// How long a runtime lives: as long as its host keeps it, and as long as a script of it runs.

#include <memory>
#include <utility>

#include <fettle/property/tree.h>

namespace fettle::script {

struct Life {
    std::weak_ptr<const property::Tree*> tree;  // expired: the tree was destroyed
    bool in_tree = true;                        // false: the runtime has left its tree
    int uses = 0;                               // entries into Lua that have not returned
    std::shared_ptr<void> orphan;               // the runtime itself, once its host destroyed it

    /// Whether there is a tree, and the runtime belongs to it.
    bool has_tree() const { return in_tree && !tree.expired(); }

    /// While it lives, scripts run, and what they call may destroy the runtime: all of it stays as
    /// long.
    class Use {
      public:
        explicit Use(Life& life) : life_(life) { ++life_.uses; }
        ~Use() {
            if (--life_.uses == 0) const std::shared_ptr<void> dead = std::move(life_.orphan);
        }
        Use(const Use&) = delete;

      private:
        Life& life_;
    };
};

}  // namespace fettle::script
