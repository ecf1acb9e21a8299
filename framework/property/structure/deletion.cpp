// Deletion of instances with everything below them.

#include <fettle/property/exception_text.h>

#include "structure.h"

namespace fettle::property {

std::string Structure::destroy_below(std::uint32_t top) {
    const Pin pin(changes.lifetime, "a lifecycle function");
    struct Deleting {
        int& count;
        explicit Deleting(int& c) : count(c) { ++count; }
        ~Deleting() { --count; }
    } deleting(underway.deletions);
    std::vector<std::uint32_t> order;
    instances.visit_below(top, [&](std::uint32_t i) {
        order.push_back(i);
        nodes[i].being_deleted = 1;
    });
    const Cause by = changes.author.cause();
    // No message is written after the end of the tree.
    const std::size_t remembered = changes.lifetime.ending ? 0 : Tombstones::max_count;
    std::string problem;
    for (std::size_t left = order.size(); left > 0; --left)
        destroy_one(order[left - 1], by, left <= remembered, problem);
    return problem;
}

void Structure::destroy_one(std::uint32_t index, const Cause& cause, bool remember,
                            std::string& problem) {
    const Handle self = nodes.handle(index);
    const Class& of = instances.classes[nodes[index].class_id];
    const auto of_module = [&](const auto& call) {
        try {
            call();
        } catch (...) {
            if (problem.empty()) problem = tree.path(self) + ": " + exception_text();
        }
    };
    of_module([&] { changes.queue_deletion(self, of, cause); });
    // When a past step is repeated, the deletion has its tombstone already, with its first cause.
    if (remember && !changes.replaying)
        instances.tombstones.add({self, &of, nodes[index].name.text(), tree.path(self), cause});
    if (nodes[index].has_formula)
        for (const Property* property : tree.properties(self))
            formulas.remove({index, property->symbol});
    const std::uint32_t parent = nodes[index].parent;
    const NodeName name = nodes[index].name;
    const bool has_dependents = nodes[index].has_dependents;
    const Lifecycle& lifecycle = of.lifecycle();
    if (lifecycle.destroy)
        of_module([&] { lifecycle.destroy(lifecycle.context, tree, self, nodes[index].row); });
    // After the lifecycle function, which may begin to watch.
    changes.shadows.forget(tree, self);
    if (instances.stored[of.id()]) instances.stored[of.id()]->remove(nodes[index].stored_row);
    changes.weight.add(-instances.weight_of(index));
    changes.weight.remove_content(index);
    if (nodes[index].has_ad_hoc) instances.ad_hoc.of_instance.erase(index);
    instances.ad_hoc.tracks.erase(index);
    nodes.unlink(index);
    nodes.release(index, instances.keep_slots);
    changed(parent, name);
    if (has_dependents) formulas.instance_gone(index);
}

}  // namespace fettle::property
