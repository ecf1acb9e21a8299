// Where instances hang: other names, other parents, and how deep a tree may be.

#include <optional>

#include <fettle/property/path.h>
#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

/// What is to hang below has `levels` levels.
void Tree::State::require_room_below(Handle parent, std::size_t levels) const {
    if (nodes.depth(parent.index) + levels <= Nodes::deepest) return;
    std::string path = tree.path(parent);
    if (path.size() > 80) path = path.substr(0, 50) + "…" + path.substr(path.size() - 25);
    throw Error(ErrorKind::bad_structure, path + ": nothing can hang so deep; a tree has " +
                                              std::to_string(Nodes::deepest) + " levels at most");
}

void Tree::rename(Handle instance, std::string_view name) {
    State& s = *state_;
    Node& node = s.require(instance);
    s.forbid_in_formula("rename an instance");
    if (node.name.text() == name) return;
    if (instance == s.root)
        throw Error(ErrorKind::bad_structure, "the root is always called \"game\"");
    const std::uint32_t parent = node.parent;
    s.check_child_name(s.nodes.handle(parent), name);
    std::optional<History::Position> before;
    if (s.history.recording()) before = s.history.position(instance);
    const NodeName was = node.name;
    const NodeName made = NodeName::make(name);
    if (parent == 0) {
        node.name = made;
    } else {
        // Renaming keeps the place among the siblings.
        const bool first = s.nodes[parent].first_child == instance.index;
        const std::uint32_t in_front = first ? 0 : node.previous;
        s.nodes.unlink(instance.index);
        s.nodes.link(instance.index, parent, made);
        s.nodes.reorder(instance.index, in_front);
    }
    s.nodes[instance.index].named = true;
    s.structure_changed(parent, was);
    s.structure_changed(parent, made);
    if (before) s.history.moved(instance, *before);
    s.tell([&](Observer& o) { o.moved(instance); });
    if (s.watchers.any_broad()) s.refresh_shadows_below(instance.index);
}

void Tree::State::place_subtree(Handle top) {
    tree.each_below(top, [this](Handle handle) {
        const Class& of = tree.class_of(handle);
        if (!of.lifecycle().place) return;
        const Row row =
            of.lifecycle().place(of.lifecycle().context, tree, handle, nodes[handle.index].row);
        if (Node* node = nodes.find(handle)) node->row = row;
    });
}

void Tree::move(Handle instance, Handle new_parent, std::string_view name, bool first_plain) {
    State& s = *state_;
    const Node& node = s.require(instance);
    s.forbid_in_formula("move an instance");
    if (instance == s.root) throw Error(ErrorKind::bad_structure, "the root cannot be moved");
    if (new_parent) {
        s.require(new_parent);
        s.require_room_below(new_parent, s.nodes.height(instance.index));
        if (new_parent == instance || is_below(new_parent, instance))
            throw Error(
                ErrorKind::bad_structure,
                path(instance) + " cannot be moved below itself (" + path(new_parent) + ")");
    }
    NodeName chosen = node.name;
    if (!name.empty()) {
        if (s.nodes.child(new_parent.index, NodeName::look_up(name)) != instance.index ||
            !new_parent)
            s.check_child_name(new_parent, name);
        chosen = NodeName::make(name);
    } else if (new_parent && node.parent != new_parent.index) {
        const bool taken = !node.named || s.nodes.child(new_parent.index, node.name) != 0 ||
                           find(new_parent, node.name.text()) != nullptr ||
                           class_of(new_parent).method(node.name.text()) != nullptr;
        if (taken) {
            const std::string_view stem =
                node.named ? node.name.base.text() : class_of(instance).stem();
            const bool plain =
                find(new_parent, stem) == nullptr && class_of(new_parent).method(stem) == nullptr;
            chosen = first_plain ? s.nodes.plain_name(new_parent.index, stem, plain)
                                 : s.nodes.free_name(new_parent.index, stem);
        }
    } else if (node.parent == new_parent.index) {
        return;
    }
    const bool named = node.named || !name.empty();
    std::optional<History::Position> before;
    if (s.history.recording()) before = s.history.position(instance);
    const std::uint32_t left = node.parent;
    const NodeName was = node.name;
    s.nodes.unlink(instance.index);
    s.nodes.link(instance.index, new_parent.index, chosen);
    s.nodes[instance.index].named = named;
    s.edited = true;
    s.structure_changed(left, was);
    s.structure_changed(new_parent.index, chosen);
    s.place_subtree(instance);
    if (before) s.history.moved(instance, *before);
    s.tell([&](Observer& o) { o.moved(instance); });
    if (s.watchers.any_broad()) s.refresh_shadows_below(instance.index);
}

}  // namespace fettle::property
