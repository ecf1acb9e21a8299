// How instances get other places, with all that is below them.

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
        const Row row =
            of.lifecycle().place(of.lifecycle().context, tree, handle, nodes[handle.index].row);
        if (Node* node = nodes.find(handle)) node->row = row;
    });
}

void Structure::hang(Handle instance, const Position& at) {
    Node& node = nodes[instance.index];
    const std::uint32_t left = node.parent;
    const NodeName was = node.name;
    nodes.unlink(instance.index);
    nodes.link(instance.index, at.parent.index, at.name);
    nodes[instance.index].named = at.named;
    changes.edited = true;
    changed(left, was);
    changed(at.parent.index, at.name);
}

void Structure::hang_back(Handle instance, const Position& was) {
    const Position left = nodes.position(instance.index);
    hang(instance, was);
    note_number(left.parent.index, left.name.base);
    note_number(was.parent.index, was.name.base);
    if (was.parent) nodes.reorder(instance.index, was.before.index);
    try {
        place_subtree(instance);
    } catch (...) {
        // It has just been there. What cannot go back stays in its module where it was put.
    }
}

void Structure::hang_or_leave(Handle instance, const Position& at) {
    const Position was = nodes.position(instance.index);
    hang(instance, at);
    try {
        place_subtree(instance);
    } catch (const std::invalid_argument& refusal) {
        hang_back(instance, was);
        throw Error(ErrorKind::rejected, tree.path(instance) + ": " + refusal.what());
    } catch (...) {
        hang_back(instance, was);
        throw;
    }
}

void Structure::tell_of_move(Handle instance) {
    changes.tell([&](Observer& o) { o.moved(instance); });
    if (changes.watchers.any_broad()) changes.refresh_shadows_below(instance.index);
}

}  // namespace fettle::property
