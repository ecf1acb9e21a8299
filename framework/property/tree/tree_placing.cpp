// Renaming and moving of instances with everything below them, and the depth limit of the tree.

#include <exception>
#include <optional>

#include <fettle/property/path.h>
#include <fettle/property/sibling_order.h>
#include <fettle/property/write_log.h>

#include "state.h"

namespace fettle::property {

void Tree::rename(Handle instance, std::string_view name) {
    State& s = *state_;
    Node& node = s.instances.require(instance);
    s.require_changeable("rename an instance");
    if (node.name.text() == name) return;
    if (instance == s.instances.root)
        throw Error(ErrorKind::bad_structure, "the root is always called \"game\"");
    s.require_free(instance, "rename it");
    const std::uint32_t parent = node.parent;
    s.instances.check_child_name(s.instances.nodes.handle(parent), name);
    std::optional<Position> before;
    if (s.changes.recording()) before = s.instances.nodes.position(instance.index);
    const NodeName was = node.name;
    const NodeName made = NodeName::make(name);
    if (parent == 0) {
        node.name = made;
    } else {
        // A rename keeps the place among the siblings.
        const bool first = s.instances.nodes[parent].first_child == instance.index;
        const std::uint32_t in_front = first ? 0 : node.previous;
        s.instances.nodes.unlink(instance.index);
        s.instances.nodes.link(instance.index, parent, made);
        s.instances.nodes.reorder(instance.index, in_front);
    }
    s.instances.nodes[instance.index].named = true;
    s.structure.changed(parent, was);
    s.structure.changed(parent, made);
    if (before) s.history.moved(instance, *before);
    s.changes.notify([&](Observer& o) { o.moved(instance); });
    if (s.changes.watchers.any_broad()) s.changes.refresh_shadows_below(instance.index);
}

void Tree::State::require_free(Handle instance, std::string_view what) {
    instances.require_movable(instance);
    underway.require_staying(instances, instance, what);
    if (underway.restoring) underway.require_rows(instances, instance, what);
}

void Tree::State::require_place(Handle instance, Handle parent) {
    underway.require_settled(instances, instance, "move it");
    if (!parent) return;
    if (instances.require(parent).being_deleted)
        underway.require_staying(instances, parent, "move an instance below it");
    instances.require_room_below(parent, instances.nodes.height(instance.index));
    if (parent == instance || tree.is_below(parent, instance))
        throw Error(
            ErrorKind::bad_structure,
            tree.path(instance) + " cannot be moved below itself (" + tree.path(parent) + ")");
}

std::function<void()> Tree::placement_restorer(Handle instance) {
    if (!alive(instance)) return [] {};
    const Position was = state_->instances.nodes.position(instance.index);
    return [this, lives = lifetime(), instance, was] {
        if (!lives.expired()) state_->move_back(instance, was);
    };
}

void Tree::State::move_back(Handle instance, const Position& was) noexcept try {
    if (!tree.alive(instance) || (was.parent && !tree.alive(was.parent))) return;
    require_changeable("move an instance");
    if (instance == instances.root) return;
    require_free(instance, "move it");
    if (underway.restoring)
        underway.require_row_above(instances, was.parent, "move an instance below it");
    require_place(instance, was.parent);
    Position at = was;
    const std::uint32_t above = was.parent.index;
    if (was.parent && instances.nodes.child(above, was.name) != instance.index &&
        instances.is_taken(above, was.name))
        at.name = structure.free_name(above, was.name.base.text());
    const Position left = instances.nodes.position(instance.index);
    if (left.parent == at.parent)
        structure.relink(instance, at);
    else
        structure.move_or_stay(instance, at);
    instances.nodes.reorder(instance.index, tree.alive(was.before) ? was.before.index : 0);
    if (changes.recording()) history.moved(instance, left);
    structure.notify_move(instance);
} catch (...) {
    // It stays where it is, and the caller may try again later.
}

void Tree::replace(Handle old, Handle by) {
    State& s = *state_;
    s.instances.require(old);
    s.instances.require(by);
    s.require_changeable("replace an instance");
    s.underway.require_staying(s.instances, old, "replace it");
    s.underway.require_settled(s.instances, old, "replace it");
    s.underway.require_settled(s.instances, by, "move it");
    s.underway.require_staying(s.instances, by, "move it");
    if (s.underway.restoring) {
        s.underway.require_rows(s.instances, old, "replace it");
        s.underway.require_rows(s.instances, by, "move it");
    }
    const Position at = s.instances.nodes.position(old.index),
                   was = s.instances.nodes.position(by.index);
    s.instances.require_movable(old);
    if (!at.parent || was.parent || by == s.instances.root || old == by || is_below(old, by))
        throw Error(ErrorKind::bad_structure, path(by) + " cannot take the place of " + path(old));
    // The new instance first gets a temporary name, because modules may refuse it while the old one
    // is still in place.
    // Messages of modules about it name the place that it gets.
    const State::Replacing replacing(s, by.index, at.name);
    s.structure.move_or_stay(by, {.parent = at.parent,
                                  .before = {},
                                  .name = {State::name_while_replacing(), 0},
                                  .named = true});
    s.structure.notify_move(by);
    std::exception_ptr problem;  // of a module that was notified of the deletion
    try {
        const Hold stays(s.underway, by, being_moved);
        destroy(old);
    } catch (...) {
        if (alive(old)) {
            s.structure.move_back(by, was);
            s.structure.notify_move(by);
            throw;
        }
        problem = std::current_exception();
    }
    s.structure.relink(by, {.parent = at.parent, .before = {}, .name = at.name, .named = true});
    if (s.changes.recording()) s.history.moved(by, was);
    s.structure.notify_move(by);
    if (problem) std::rethrow_exception(problem);
}

void Tree::move(Handle instance, Handle new_parent, std::string_view name,
                PlainNames* plain_names) {
    if (!new_parent) new_parent = {};  // a null handle may have an index
    State& s = *state_;
    const Node& node = s.instances.require(instance);
    s.require_changeable("move an instance");
    if (instance == s.instances.root)
        throw Error(ErrorKind::bad_structure, "the root cannot be moved");
    if (new_parent) s.instances.require(new_parent);
    s.require_free(instance, "move it");
    if (s.underway.restoring)
        s.underway.require_row_above(s.instances, new_parent, "move an instance below it");
    if (new_parent && node.parent == new_parent.index) {
        if (!name.empty()) rename(instance, name);
        return;
    }
    s.require_place(instance, new_parent);
    NodeName chosen = node.name;
    if (!name.empty()) {
        s.instances.check_child_name(new_parent, name);
        chosen = NodeName::make(name);
    } else if (new_parent) {
        if (!node.named || s.instances.is_taken(new_parent.index, node.name)) {
            const std::string_view stem =
                node.named ? node.name.base.text() : class_of(instance).stem();
            chosen = plain_names != nullptr
                         ? s.instances.plain_name(new_parent.index, stem, *plain_names)
                         : s.structure.free_name(new_parent.index, stem);
        }
    } else if (node.parent == 0) {
        return;
    }
    const bool named = node.named || !name.empty();
    const Position was = s.instances.nodes.position(instance.index);
    s.structure.move_or_stay(instance,
                             {.parent = new_parent, .before = {}, .name = chosen, .named = named});
    if (s.changes.recording()) s.history.moved(instance, was);
    s.structure.notify_move(instance);
}

void put_behind(Tree& tree, Handle instance, Handle before) {
    Tree::State& s = tree.state();
    const Node& node = s.instances.require(instance);
    if (before) s.instances.require(before);
    s.require_changeable("move an instance");
    const Position was = s.instances.nodes.position(instance.index);
    if (!was.parent || before == instance || was.before.index == before.index) return;
    if (before && tree.parent(before) != was.parent) return;
    s.require_free(instance, "move it");
    if (s.underway.restoring)
        s.underway.require_row_above(s.instances, was.parent, "move an instance below it");
    s.instances.nodes.reorder(instance.index, before.index);
    s.changes.edited = true;
    s.structure.changed(was.parent.index, node.name);
    if (s.changes.recording()) s.history.moved(instance, was);
    s.structure.notify_move(instance);
}

}  // namespace fettle::property
