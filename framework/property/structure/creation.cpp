// Creation of instances.

#include <optional>
#include <stdexcept>

#include <fettle/property/write_log.h>

#include <values/weight.h>

#include "structure.h"

namespace fettle::property {
namespace {

/// Checks the columns when the class gets its first row, so that reads need no check.
void require_columns(const Class& of) {
    for (const Property* property : of.properties()) {
        const Binding& binding = property->binding;
        if (binding.kind == BindingKind::column && binding.base(binding.context) == nullptr)
            throw Error(ErrorKind::rejected,
                        of.name() + "." + property->name +
                            ": it has no memory: the `base` of its column gave a null pointer");
    }
    ClassRegistry::columns_found(of) = true;
}

}  // namespace

NodeName Structure::free_name(std::uint32_t parent, std::string_view stem) {
    const NodeName name = nodes.free_name(
        parent, stem, [&](const NodeName& taken) { return instances.is_taken(parent, taken); });
    note_number(parent, name.base);
    return name;
}

void Structure::note_number(std::uint32_t parent, Symbol stem) {
    if (changes.observers.logs.empty() || changes.replaying || parent == 0) return;
    const std::uint32_t last = nodes.last_number(parent, stem);
    if (last == 0) return;
    for (WriteLog* log : changes.observers.logs) log->numbered(nodes.handle(parent), stem, last);
}

/// Undoes the work of a module that refuses an instance.
void Structure::undo_making(Handle self, const Class& of, bool has_row) {
    const Lifecycle& lifecycle = of.lifecycle();
    while (nodes[self.index].first_child != 0) {  // children that it has made
        const Handle child = nodes.handle(nodes[self.index].first_child);
        changes.notify([&](Observer& o) { o.destroying(child); });
        destroy_below(child.index);
    }
    if (has_row && lifecycle.destroy) try {
            lifecycle.destroy(lifecycle.context, tree, self, nodes[self.index].row);
        } catch (...) {
            // The caller reports the first exception.
        }
}

std::uint32_t Structure::make(const Class& of, std::uint32_t parent, NodeName name, bool named,
                              Handle again) {
    instances.classes.require_living(of);
    if (!again && !next_handles.empty()) {
        again = next_handles.front();
        next_handles.erase(next_handles.begin());
    }
    if (again) nodes.revive(again);
    const std::uint32_t index = again ? again.index : nodes.allocate();
    const std::int64_t bytes = weight_of_instance + of.weight();
    const Pin pin(changes.lifetime, "a lifecycle function");
    changes.weight.add(bytes);
    if (named && name.number == 0) changes.weight.add_name(name.base);
    nodes[index].class_id = static_cast<std::uint16_t>(of.id());
    nodes[index].named = named;
    nodes[index].fresh = true;
    changes.queue.fresh.push_back(index);
    nodes.link(index, parent, name);
    const Handle self = nodes.handle(index);
    if (instances.stored[of.id()]) {
        const std::uint32_t row = instances.stored[of.id()]->add();
        nodes[index].stored_row = row;
    }
    const Lifecycle& lifecycle = of.lifecycle();
    std::optional<Hold> making_it(std::in_place, underway, self, being_made);
    bool has_row = false;
    try {
        if (lifecycle.create) {
            const Row row = lifecycle.create(lifecycle.context, tree, self);
            nodes[index].row = row;
            has_row = true;
        }
        if (!ClassRegistry::columns_found(of)) require_columns(of);
    } catch (...) {  // the module refuses it: the instance never existed
        undo_making(self, of, has_row);
        if (instances.stored[of.id()]) instances.stored[of.id()]->remove(nodes[index].stored_row);
        nodes.unlink(index);
        nodes.release(index, again && instances.keep_slots);
        note_number(parent, name.base);
        changes.weight.add(-bytes);
        throw;
    }
    finish_making(self, of);
    making_it.reset();
    changed(parent, name);
    if (changes.watchers.any_broad()) changes.refresh_shadows(index);
    if (changes.watchers.any_created()) changes.queue_creation(self, of);
    changes.notify([&](Observer& o) { o.created(self); });
    return index;
}

/// Steps that the module may refuse after the row was made. Then the instance is reported as
/// created and deleted, so that logs repeat the same.
void Structure::finish_making(Handle self, const Class& of) {
    const Lifecycle& lifecycle = of.lifecycle();
    const Property* at = nullptr;
    try {
        if (lifecycle.place && nodes[self.index].parent != 0) {
            const Row row = lifecycle.place(lifecycle.context, tree, self, nodes[self.index].row);
            nodes[self.index].row = row;
        }
        for (const Property* property : ClassRegistry::initial(of)) {
            at = property;
            instances.write(self.index, nodes[self.index], *property, property->default_value);
        }
    } catch (const std::invalid_argument& refusal) {
        unmake(self);
        throw Error(ErrorKind::rejected,
                    of.name() + (at == nullptr ? "" : "." + at->name) + ": " + refusal.what());
    } catch (...) {
        unmake(self);
        throw;
    }
}

void Structure::unmake(Handle self) {
    changes.notify([&](Observer& o) { o.created(self); });
    changes.notify([&](Observer& o) { o.destroying(self); });
    destroy_below(self.index);
}

}  // namespace fettle::property
