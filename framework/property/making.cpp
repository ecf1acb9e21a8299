// How an instance comes to be: its slot, its row with the defaults, its place.

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

std::uint32_t Tree::State::make(const Class& of, std::uint32_t parent, NodeName name, bool named,
                                Handle again) {
    if (!again && !to_come.empty()) {
        again = to_come.front();
        to_come.erase(to_come.begin());
    }
    if (again) nodes.revive(again);
    const std::uint32_t index = again ? again.index : nodes.allocate();
    nodes[index].class_id = static_cast<std::uint16_t>(of.id_);
    nodes[index].named = named;
    nodes[index].fresh = true;
    fresh.push_back(index);
    nodes.link(index, parent, name);
    const Handle self = nodes.handle(index);
    if (stored[of.id_]) {
        const std::uint32_t row = stored[of.id_]->add();
        nodes[index].stored_row = row;
    }
    const Lifecycle& lifecycle = of.lifecycle();
    bool has_row = false;
    try {
        if (lifecycle.create) {
            const Row row = lifecycle.create(lifecycle.context, tree, self);
            nodes[index].row = row;
        }
        has_row = true;
        if (lifecycle.place && parent != 0) {
            const Row row = lifecycle.place(lifecycle.context, tree, self, nodes[index].row);
            nodes[index].row = row;
        }
        for (const Property* property : of.initial_)
            write(index, nodes[index], *property, property->default_value);
    } catch (...) {  // its module has no room for it, or refuses a default: it never was
        if (has_row && lifecycle.destroy)
            lifecycle.destroy(lifecycle.context, tree, self, nodes[index].row);
        if (stored[of.id_]) stored[of.id_]->remove(nodes[index].stored_row);
        nodes.unlink(index);
        nodes.release(index);
        throw;
    }
    structure_changed(parent, name);
    if (watchers.any_broad()) {
        shadows.refresh(tree, watchers, self);
        note_listeners();
    }
    if (watchers.any_created())
        queue_item({.kind = QueueItem::Kind::created,
                    .what = Existence{.instance = self,
                                      .instance_class = &of,
                                      .path = {},
                                      .cause = tree.cause(),
                                      .last_values = {}},
                    .recipients = {}});
    tell([&](Observer& o) { o.created(self); });
    return index;
}

}  // namespace fettle::property
