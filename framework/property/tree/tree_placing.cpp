// Instances of a tree get other names and other parents, all of what hangs below them or nothing;
// and how deep a tree may be.

#include <optional>
#include <stdexcept>

#include <fettle/property/path.h>
#include <fettle/property/tree.h>
#include <fettle/property/write_log.h>

#include "state.h"

namespace fettle::property {

/// What only a module or the framework can make has the place that it was made for: a file could
/// not put it anywhere else.
void Tree::State::require_movable(Handle instance) const {
    const Class& of = classes[require(instance).class_id];
    if (!of.creatable())
        throw Error(ErrorKind::bad_structure,
                    tree.path(instance) + ": the " + of.name() + " cannot be moved or renamed");
}

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
    s.require_changeable("rename an instance");
    if (node.name.text() == name) return;
    if (instance == s.root)
        throw Error(ErrorKind::bad_structure, "the root is always called \"game\"");
    s.require_movable(instance);
    s.require_staying(instance, "rename it");
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
    const Pin pin(*this, "a lifecycle function");
    tree.each_below(top, [this](Handle handle) {
        const Class& of = tree.class_of(handle);
        if (!of.lifecycle().place) return;
        const Row row =
            of.lifecycle().place(of.lifecycle().context, tree, handle, nodes[handle.index].row);
        if (Node* node = nodes.find(handle)) node->row = row;
    });
}

bool Tree::State::is_taken(std::uint32_t parent, const NodeName& name) const {
    if (nodes.child(parent, name) != 0) return true;
    const Symbol symbol = Symbol::find(name.text());
    if (!symbol) return false;  // no property and no method is called so
    return tree.find(nodes.handle(parent), symbol) != nullptr ||
           classes[nodes[parent].class_id].method(symbol) != nullptr;
}

NodeName Tree::State::free_name(std::uint32_t parent, std::string_view stem) {
    const NodeName name = nodes.free_name(
        parent, stem, [&](const NodeName& taken) { return is_taken(parent, taken); });
    note_number(parent, name.base);
    return name;
}

void Tree::State::note_number(std::uint32_t parent, Symbol stem) {
    if (logs.empty() || replaying || parent == 0) return;
    const std::uint32_t last = nodes.last_number(parent, stem);
    if (last == 0) return;
    for (WriteLog* log : logs) log->numbered(nodes.handle(parent), stem, last);
}

NodeName Tree::State::plain_name(std::uint32_t parent, std::string_view stem) const {
    NodeName name{Symbol(stem), 0};
    if (!is_taken(parent, name)) return name;
    for (name.number = 2; is_taken(parent, name);) ++name.number;
    return name;
}

/// Links alone; modules are to be told.
void Tree::State::hang(Handle instance, const Position& at) {
    Node& node = nodes[instance.index];
    const std::uint32_t left = node.parent;
    const NodeName was = node.name;
    nodes.unlink(instance.index);
    nodes.link(instance.index, at.parent.index, at.name);
    nodes[instance.index].named = at.named;
    edited = true;
    structure_changed(left, was);
    structure_changed(at.parent.index, at.name);
}

/// A module refused a place: those that had taken theirs go back, and nothing has happened.
void Tree::State::hang_back(Handle instance, const Position& was) {
    const Position left = history.position(instance);
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

/// Hangs it there with all that is below it, or leaves it where it is. Nobody is told.
void Tree::State::hang_or_leave(Handle instance, const Position& at) {
    const Position was = history.position(instance);
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

void Tree::State::told_of_move(Handle instance) {
    tell([&](Observer& o) { o.moved(instance); });
    if (watchers.any_broad()) refresh_shadows_below(instance.index);
}

std::function<void()> Tree::way_back(Handle instance) {
    if (!alive(instance)) return [] {};
    const Position was = state_->history.position(instance);
    return [this, instance, was] {
        State& s = *state_;
        if (!alive(instance) || (was.parent && !alive(was.parent)) || s.deletions != 0) return;
        const Position left = s.history.position(instance);
        s.hang_back(instance, was);
        if (s.history.recording()) s.history.moved(instance, left);
        s.told_of_move(instance);
    };
}

void Tree::replace(Handle old, Handle by) {
    State& s = *state_;
    s.require(old);
    s.require(by);
    s.require_changeable("replace an instance");
    s.require_staying(old, "replace it");
    s.require_made(old, "replace it");
    s.require_staying(by, "move it");
    const Position at = s.history.position(old), was = s.history.position(by);
    s.require_movable(old);
    if (!at.parent || was.parent || by == s.root || old == by || is_below(old, by))
        throw Error(ErrorKind::bad_structure, path(by) + " cannot take the place of " + path(old));
    // First to a place of its own: modules can refuse it while the other still has its.
    static const Symbol beside("\x1b replacing");
    s.hang_or_leave(by, {.parent = at.parent, .before = {}, .name = {beside, 0}, .named = true});
    s.told_of_move(by);
    destroy(old);
    s.hang(by, {.parent = at.parent, .before = {}, .name = at.name, .named = true});
    if (s.history.recording()) s.history.moved(by, was);
    s.told_of_move(by);
}

void Tree::move(Handle instance, Handle new_parent, std::string_view name, bool first_plain) {
    State& s = *state_;
    const Node& node = s.require(instance);
    s.require_changeable("move an instance");
    if (instance == s.root) throw Error(ErrorKind::bad_structure, "the root cannot be moved");
    s.require_movable(instance);
    s.require_staying(instance, "move it");
    if (new_parent) {
        if (s.require(new_parent).dying) s.require_staying(new_parent, "move an instance below it");
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
        if (!node.named || s.is_taken(new_parent.index, node.name)) {
            const std::string_view stem =
                node.named ? node.name.base.text() : class_of(instance).stem();
            chosen = first_plain ? s.plain_name(new_parent.index, stem)
                                 : s.free_name(new_parent.index, stem);
        }
    } else if (node.parent == new_parent.index) {
        return;
    }
    const bool named = node.named || !name.empty();
    const Position was = s.history.position(instance);
    s.hang_or_leave(instance, {.parent = new_parent, .before = {}, .name = chosen, .named = named});
    if (s.history.recording()) s.history.moved(instance, was);
    s.told_of_move(instance);
}

}  // namespace fettle::property
