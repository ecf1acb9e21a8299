// Selection of the cells that have shadows: watched cells whose values change without an edit.

#include "changes.h"

namespace fettle::property {

void Changes::count_interest(const Watcher& watcher, int sign) {
    const auto count = [&](const Property& property) {
        if (Watchers::may_match(watcher, property))
            property.shortcut.set_interest(property.shortcut.interest +
                                           static_cast<std::uint32_t>(sign));
    };
    if (watcher.property) {  // The watcher has one property name, so only that name is looked up.
        for (std::uint32_t i = 0; i < instances.classes.size(); ++i) {
            const Property* property = instances.classes[i].property(watcher.property);
            if (property != nullptr && property->owner == &instances.classes[i]) count(*property);
        }
        const auto own = instances.ad_hoc.descriptors.find(watcher.property);
        if (own != instances.ad_hoc.descriptors.end()) count(*own->second);
        return;
    }
    for (std::uint32_t i = 0; i < instances.classes.size(); ++i)
        for (const Property& property : ClassRegistry::own_properties(instances.classes[i]))
            count(property);
    for (const auto& [name, property] : instances.ad_hoc.descriptors) count(*property);
}

void Changes::refresh_shadows_below(std::uint32_t top) {
    instances.visit_below(top, [this](std::uint32_t i) { refresh_shadows(i); });
}

/// Visits every shadowed cell that a broad watcher matches or could match. Only cells that the
/// watcher could match are visited, so the cost of a pattern does not depend on other watchers.
template <class Visit>
void Changes::each_cell_wanted(const Watcher& watcher, Visit visit) {
    std::vector<std::vector<const Property*>> of_class(instances.classes.size());
    bool any = false;
    for (std::uint32_t c = 0; c < instances.classes.size(); ++c)
        for (const Property* property : ClassRegistry::observed(instances.classes[c]))
            if (Watchers::may_match(watcher, *property)) {
                of_class[c].push_back(property);
                any = true;
            }
    if (!any) return;
    const auto look_at = [&](std::uint32_t i) {
        for (const Property* property : of_class[nodes[i].class_id])
            if (watchers.matches(watcher, nodes.handle(i), *property))
                visit(nodes.handle(i), *property);
    };
    if (watcher.kind == WatchKind::pattern) {
        if (const std::uint32_t top = top_of(*watcher.pattern); top != 0)
            instances.visit_below(top, look_at);
        return;
    }
    for (std::uint32_t i = 1; i < nodes.end(); ++i)
        if (nodes[i].alive()) look_at(i);
}

/// The lowest instance that contains all possible matches of the pattern: "world.crates" for
/// "world.crates.*.position". 0 if there is none.
std::uint32_t Changes::top_of(const Pattern& pattern) const {
    std::uint32_t top = instances.root.index;
    for (std::size_t i = 0; i + 1 < pattern.segments().size() && top != 0; ++i) {
        const std::string& name = pattern.segments()[i];
        if (name.find('*') != std::string::npos) break;
        top = nodes.child(top, NodeName::look_up(name));
    }
    return top;
}

void Changes::watcher_added(const Watcher& watcher) {
    if (watcher.index != 0) {
        nodes[watcher.index].watched = true;
        refresh_shadows(watcher.index);
    } else if (watcher.broad()) {
        count_interest(watcher, 1);
        if (replaying) return;
        each_cell_wanted(watcher, [this](Handle instance, const Property& property) {
            shadows.keep(tree, instance, property);
        });
    }
}

void Changes::watcher_removed(const Watcher& watcher) {
    if (watcher.index != 0) {
        // Within a restore, the instance and its slot may not exist any more. The data for watchers
        // are computed again at the end of the restore.
        if (nodes.find({watcher.index, watcher.generation}) == nullptr) return;
        nodes[watcher.index].watched = watchers.any_on(watcher.index);
        refresh_shadows(watcher.index);
    } else if (watcher.broad()) {
        count_interest(watcher, -1);
        if (replaying) return;
        each_cell_wanted(watcher, [this](Handle instance, const Property& property) {
            const Cell cell{instance.index, property.symbol};
            if (!watchers.directly_watched(cell) && !watchers.broadly_watched(instance, property))
                shadows.drop(cell);
        });
    }
}

}  // namespace fettle::property
