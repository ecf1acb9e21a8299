#include "underway.h"

#include <instances/instances.h>

namespace fettle::property {

void Underway::require_no_deletion(std::string_view what) const {
    if (deletions != 0)
        throw Error(ErrorKind::bad_structure, "a module is told of a deletion: it cannot " +
                                                  std::string(what) + " meanwhile");
}

void Underway::require_staying(const Instances& instances, Handle instance,
                               std::string_view what) const {
    if (deletions == 0) return;
    instances.visit_below(instance.index, [&](std::uint32_t i) {
        if (instances.nodes[i].dying)
            throw Error(ErrorKind::bad_structure, instances.tree.path(instances.nodes.handle(i)) +
                                                      " is being deleted: its module, which is "
                                                      "told of that, cannot " +
                                                      std::string(what) + " meanwhile");
    });
}

void Underway::require_made(const Instances& instances, Handle instance,
                            std::string_view what) const {
    for (const Handle self : making)
        if (self == instance ||
            (instances.nodes.find(self) != nullptr && instances.tree.is_below(self, instance)))
            throw Error(ErrorKind::bad_structure,
                        instances.tree.path(self) +
                            " is being made: its module, which makes it, cannot " +
                            std::string(what) + " meanwhile");
}

}  // namespace fettle::property
