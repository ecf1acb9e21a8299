// Moves of instances with everything below them.

#include <stdexcept>

#include "structure.h"

namespace fettle::property {

void Structure::changed(std::uint32_t parent, const NodeName& name) {
    ++changes.invalidations;
    ++version;
    formulas.name_changed(parent, name);
}

void Structure::place_subtree(Handle top) {
    const Pin pin(changes.lifetime, "a lifecycle function");
    tree.each_below(top, [this](Handle handle) {
        const Class& of = tree.class_of(handle);
        if (!of.lifecycle().place) return;
        const Hold placing(underway, handle, being_moved);
        const Row row =
            of.lifecycle().place(of.lifecycle().context, tree, handle, nodes[handle.index].row);
        if (Node* node = nodes.find(handle)) node->row = row;
    });
}

void Structure::relink(Handle instance, const Position& at) {
    Node& node = nodes[instance.index];
    const std::uint32_t left = node.parent;
    const NodeName was = node.name;
    nodes.unlink(instance.index);
    nodes.link(instance.index, at.parent.index, at.name);
    nodes[instance.index].named = at.named;
    changes.edited = true;
    changed(left, was);
    changed(at.parent.index, at.name);
    if (left != at.parent.index) instances.forget_track(instance.index);
}

void Structure::move_back(Handle instance, const Position& was) {
    const Position left = nodes.position(instance.index);
    relink(instance, was);
    note_number(left.parent.index, left.name.base);
    note_number(was.parent.index, was.name.base);
    if (was.parent) nodes.reorder(instance.index, was.before.index);
    try {
        place_subtree(instance);
    } catch (...) {
        // The old place was valid, so this is not expected. The module keeps the instance where it
        // is.
    }
}

void Structure::move_or_stay(Handle instance, const Position& at) {
    const Position was = nodes.position(instance.index);
    // It goes back there if a module refuses the new place.
    const Hold former_place(underway, was.parent, being_left);
    relink(instance, at);
    try {
        place_subtree(instance);
    } catch (const std::invalid_argument& refusal) {
        move_back(instance, was);
        throw Error(ErrorKind::rejected, tree.path(instance) + ": " + refusal.what());
    } catch (...) {
        move_back(instance, was);
        throw;
    }
}

void Structure::notify_move(Handle instance) {
    changes.notify([&](Observer& o) { o.moved(instance); });
    if (changes.watchers.any_broad()) changes.refresh_shadows_below(instance.index);
}

}  // namespace fettle::property
