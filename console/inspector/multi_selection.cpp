#include <inspector/multi_selection.h>
#include <observed/last_value.h>

#include <cstdint>
#include <functional>
#include <unordered_set>

namespace fettle::console {

using property::Handle;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

/// The position that can be written; null if there is none.
const Property* position_of(const property::Tree& tree, Handle instance) {
    if (!tree.alive(instance)) return nullptr;
    const Property* found = tree.find(instance, "position");
    return found != nullptr && found->type == Type::vec2 && !found->read_only ? found : nullptr;
}

/// The instances that can be moved, without those below one of them, which move with it.
std::vector<Handle> movable(const property::Tree& tree, std::vector<Handle> instances) {
    std::erase_if(instances, [&](Handle each) { return position_of(tree, each) == nullptr; });
    return topmost(tree, instances);
}

/// Writes a new position to each instance, as one step of undo.
void set_positions(property::Tree& tree, const std::string& name,
                   const std::vector<Handle>& instances, const std::function<Vec2(Vec2)>& to) {
    tree.begin_edit(name);
    try {
        const property::Tree::CauseScope cause(tree, property::Writer::inspector);
        for (const Handle each : instances)
            if (const Property* position = position_of(tree, each))
                tree.set(each, *position, Value(to(last_value(tree, each, *position).vec2())));
    } catch (...) {
        tree.end_edit();
        throw;
    }
    tree.end_edit();
}

std::string command_for_each(const property::Tree& tree, const std::vector<Handle>& instances,
                             const std::function<std::string(Handle)>& action) {
    const std::vector<Handle> all = topmost(tree, instances);
    if (all.empty() || all.size() > most_in_command) return {};
    std::string command;
    for (const Handle each : all) command += (command.empty() ? "" : "; ") + action(each);
    return command;
}

}  // namespace

std::vector<Handle> topmost(const property::Tree& tree, const std::vector<Handle>& instances) {
    std::unordered_set<std::uint64_t> wanted, taken;
    for (const Handle each : instances)
        if (tree.alive(each)) wanted.insert(each.key());
    std::vector<Handle> top;
    for (const Handle each : instances) {
        if (!tree.alive(each)) continue;
        bool below = false;
        for (Handle above = tree.parent(each); above && !below; above = tree.parent(above))
            below = wanted.contains(above.key());
        if (!below && taken.insert(each.key()).second) top.push_back(each);
    }
    return top;
}

std::vector<Handle> in_box(const property::Tree& tree, Vec2 corner, Vec2 other) {
    const Vec2 low = corner.min(other), high = corner.max(other);
    std::vector<Handle> inside;
    tree.each_below(tree.root(), [&](Handle instance) {
        if (position_of(tree, instance) == nullptr) return;
        // Only below a world, which has the method `at`: a widget has a position on the screen.
        bool in_world = false;
        for (Handle above = tree.parent(instance); above && !in_world; above = tree.parent(above))
            in_world = tree.class_of(above).method("at") != nullptr;
        if (!in_world) return;
        const Vec2 at = last_value(tree, instance, *position_of(tree, instance)).vec2();
        if (at.within(low, high)) inside.push_back(instance);
    });
    // The position of a shape is relative to its body.
    std::erase_if(inside, [&](Handle instance) {
        for (Handle above = tree.parent(instance); above; above = tree.parent(above)) {
            if (tree.class_of(above).method("at") != nullptr) return false;
            if (position_of(tree, above) != nullptr) return true;
        }
        return false;
    });
    return inside;
}

std::vector<Handle> all_of_class(const property::Tree& tree, const property::Class& wanted) {
    std::vector<Handle> all;
    tree.each_below(tree.root(), [&](Handle instance) {
        if (&tree.class_of(instance) == &wanted) all.push_back(instance);
    });
    return all;
}

std::string delete_command(const property::Tree& tree, const std::vector<Handle>& instances) {
    return command_for_each(tree, instances,
                            [&](Handle each) { return tree.path(each) + ":delete()"; });
}

std::string clone_command(const property::Tree& tree, const std::vector<Handle>& instances) {
    return command_for_each(tree, instances, [&](Handle each) {
        return tree.path(tree.parent(each)) + ":add(" + tree.path(each) + ":clone())";
    });
}

void move_by(property::Tree& tree, const std::vector<Handle>& instances, Vec2 way) {
    const std::vector<Handle> all = movable(tree, instances);
    set_positions(
        tree, "move " + std::to_string(all.size()) + (all.size() == 1 ? " instance" : " instances"),
        all, [&](Vec2 at) { return Vec2(at + way); });
}

void align(property::Tree& tree, const std::vector<Handle>& instances, int axis) {
    const std::vector<Handle> all = movable(tree, instances);
    double sum = 0;
    int count = 0;
    for (const Handle each : all)
        if (const Property* position = position_of(tree, each)) {
            sum += last_value(tree, each, *position).vec2()[axis];
            ++count;
        }
    if (count == 0) return;
    set_positions(tree, axis == 0 ? "align x" : "align y", all, [&](Vec2 at) {
        at[axis] = sum / count;
        return at;
    });
}

}  // namespace fettle::console
