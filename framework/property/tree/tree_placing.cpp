// Renaming and moving of instances with everything below them, and the depth limit of the tree.

#include <optional>

#include <fettle/property/path.h>
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
    s.instances.require_movable(instance);
    s.underway.require_staying(s.instances, instance, "rename it");
    if (s.underway.restoring) s.underway.require_rows(s.instances, instance, "rename it");
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
    s.changes.tell([&](Observer& o) { o.moved(instance); });
    if (s.changes.watchers.any_broad()) s.changes.refresh_shadows_below(instance.index);
}

std::function<void()> Tree::way_back(Handle instance) {
    if (!alive(instance)) return [] {};
    const Position was = state_->instances.nodes.position(instance.index);
    return [this, instance, was] {
        State& s = *state_;
        if (!alive(instance) || (was.parent && !alive(was.parent)) || s.underway.deletions != 0 ||
            s.underway.ending_rows || !s.underway.unmade.empty())
            return;
        const Position left = s.instances.nodes.position(instance.index);
        s.structure.move_back(instance, was);
        if (s.changes.recording()) s.history.moved(instance, left);
        s.structure.tell_of_move(instance);
    };
}

void Tree::replace(Handle old, Handle by) {
    State& s = *state_;
    s.instances.require(old);
    s.instances.require(by);
    s.require_changeable("replace an instance");
    s.underway.require_staying(s.instances, old, "replace it");
    s.underway.require_made(s.instances, old, "replace it");
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
    static const Symbol beside("\x1b replacing");
    s.structure.move_or_stay(
        by, {.parent = at.parent, .before = {}, .name = {beside, 0}, .named = true});
    s.structure.tell_of_move(by);
    destroy(old);
    s.structure.relink(by, {.parent = at.parent, .before = {}, .name = at.name, .named = true});
    if (s.changes.recording()) s.history.moved(by, was);
    s.structure.tell_of_move(by);
}

void Tree::move(Handle instance, Handle new_parent, std::string_view name, bool first_plain) {
    if (!new_parent) new_parent = {};  // a null handle may have an index
    State& s = *state_;
    const Node& node = s.instances.require(instance);
    s.require_changeable("move an instance");
    if (instance == s.instances.root)
        throw Error(ErrorKind::bad_structure, "the root cannot be moved");
    s.instances.require_movable(instance);
    s.underway.require_staying(s.instances, instance, "move it");
    if (new_parent) s.instances.require(new_parent);
    if (s.underway.restoring) {
        s.underway.require_rows(s.instances, instance, "move it");
        s.underway.require_row_above(s.instances, new_parent, "move an instance below it");
    }
    if (new_parent && node.parent == new_parent.index) {
        if (!name.empty()) rename(instance, name);
        return;
    }
    if (new_parent) {
        if (s.instances.require(new_parent).dying)
            s.underway.require_staying(s.instances, new_parent, "move an instance below it");
        s.instances.require_room_below(new_parent, s.instances.nodes.height(instance.index));
        if (new_parent == instance || is_below(new_parent, instance))
            throw Error(
                ErrorKind::bad_structure,
                path(instance) + " cannot be moved below itself (" + path(new_parent) + ")");
    }
    NodeName chosen = node.name;
    if (!name.empty()) {
        s.instances.check_child_name(new_parent, name);
        chosen = NodeName::make(name);
    } else if (new_parent) {
        if (!node.named || s.instances.is_taken(new_parent.index, node.name)) {
            const std::string_view stem =
                node.named ? node.name.base.text() : class_of(instance).stem();
            chosen = first_plain ? s.instances.plain_name(new_parent.index, stem)
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
    s.structure.tell_of_move(instance);
}

}  // namespace fettle::property
