#include "watchers.h"

#include <algorithm>

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

void Connection::stop() {
    if (const auto watchers = watchers_.lock()) (*watchers)->stop(id_);
}

bool Connection::active() const {
    const auto watchers = watchers_.lock();
    return watchers && (*watchers)->active(id_);
}

std::vector<WatcherId>* Watchers::list_of(const Watcher& watcher) {
    switch (watcher.kind) {
        case WatchKind::cell:
            return &cells_[{watcher.index, watcher.property}];
        case WatchKind::instance:
            return &instances_[watcher.index];
        case WatchKind::deleted:
            return watcher.of != nullptr ? &deleted_ : &deleted_on_[watcher.index];
        case WatchKind::event:
            return &events_[{watcher.index, watcher.event->symbol}];
        case WatchKind::of_class:
        case WatchKind::pattern:
            return &broad_;
        case WatchKind::created:
            return &created_;
        case WatchKind::class_event:
            return &class_events_;
    }
    return nullptr;
}

Connection Watchers::add(Watcher watcher) {
    watcher.id = ++last_id_;
    const auto kept = std::make_shared<Watcher>(std::move(watcher));
    all_.emplace(kept->id, kept);
    list_of(*kept)->push_back(kept->id);
    if (kept->index != 0) on_index_[kept->index].push_back(kept->id);
    if (kept->event != nullptr) ++kept->event->listeners;
    tree_.state().watcher_added(*kept);
    return {self_, kept->id};
}

void Watchers::stop(WatcherId id) {
    const auto found = all_.find(id);
    if (found == all_.end()) return;
    const std::shared_ptr<Watcher> watcher = found->second;
    all_.erase(found);
    if (!watcher->active) return;  // retired before
    watcher->active = false;
    unlist(*watcher);
    tree_.state().watcher_removed(*watcher);
}

void Watchers::unlist(const Watcher& watcher) {
    std::erase(*list_of(watcher), watcher.id);
    const auto drop_if_empty = [](auto& map, const auto& key) {
        const auto entry = map.find(key);
        if (entry != map.end() && entry->second.empty()) map.erase(entry);
    };
    drop_if_empty(cells_, Cell{watcher.index, watcher.property});
    drop_if_empty(instances_, watcher.index);
    drop_if_empty(deleted_on_, watcher.index);
    if (watcher.event != nullptr) {
        --watcher.event->listeners;
        drop_if_empty(events_, Cell{watcher.index, watcher.event->symbol});
    }
    if (const auto on = on_index_.find(watcher.index); on != on_index_.end()) {
        std::erase(on->second, watcher.id);
        if (on->second.empty()) on_index_.erase(on);
    }
}

void Watchers::retire(std::uint32_t index, const std::vector<WatcherId>& keep) {
    const auto on = on_index_.find(index);
    if (on == on_index_.end()) return;
    const std::vector<WatcherId> ids = on->second;
    for (const WatcherId id : ids) {
        const std::shared_ptr<Watcher> watcher = all_.at(id);
        unlist(*watcher);
        watcher->active = false;
        if (std::find(keep.begin(), keep.end(), id) == keep.end()) all_.erase(id);
    }
}

std::vector<std::uint32_t> Watchers::watched_slots() const {
    std::vector<std::uint32_t> slots;
    for (const auto& [index, ids] : on_index_) slots.push_back(index);
    std::sort(slots.begin(), slots.end());
    return slots;
}

std::shared_ptr<Watcher> Watchers::find(WatcherId id) const {
    const auto found = all_.find(id);
    return found == all_.end() ? nullptr : found->second;
}

bool Watchers::wants(const Watcher& watcher, Handle instance, const Property& property) const {
    if (watcher.kind == WatchKind::pattern)
        return watcher.pattern->matches(tree_, instance, property);
    return (!watcher.property || watcher.property == property.symbol) &&
           tree_.class_of(instance).is_a(*watcher.of);
}

bool Watchers::broadly_watched(Handle instance, const Property& property) const {
    return property.interest != 0 && std::any_of(broad_.begin(), broad_.end(), [&](WatcherId id) {
               return wants(*all_.at(id), instance, property);
           });
}

std::uint32_t Watchers::interest(const Property& property, const Class* of) const {
    std::uint32_t count = 0;
    for (const WatcherId id : broad_) {
        const Watcher& watcher = *all_.at(id);
        if (watcher.kind == WatchKind::pattern)
            count += watcher.pattern->may_match(property.symbol);
        else
            count += (!watcher.property || watcher.property == property.symbol) &&
                     (of == nullptr || of->is_a(*watcher.of) || watcher.of->is_a(*of));
    }
    return count;
}

namespace {

// Keeps those registered up to `until`, in order of registration, once each.
std::vector<WatcherId> in_order(std::vector<WatcherId> ids, WatcherId until) {
    std::erase_if(ids, [until](WatcherId id) { return id > until; });
    std::sort(ids.begin(), ids.end());
    return ids;
}

template <class Map, class Key>
void append(std::vector<WatcherId>& out, const Map& map, const Key& key) {
    if (const auto found = map.find(key); found != map.end())
        out.insert(out.end(), found->second.begin(), found->second.end());
}

}  // namespace

std::vector<WatcherId> Watchers::of_change(const Change& change, WatcherId until) const {
    std::vector<WatcherId> ids;
    append(ids, cells_, Cell{change.instance.index, change.property->symbol});
    append(ids, instances_, change.instance.index);
    if (change.property->interest != 0)
        for (const WatcherId id : broad_)
            if (wants(*all_.at(id), change.instance, *change.property)) ids.push_back(id);
    return in_order(std::move(ids), until);
}

std::vector<WatcherId> Watchers::of_event(Handle instance, const Event& event,
                                          WatcherId until) const {
    return of_event(instance.index, tree_.class_of(instance), event, until);
}

std::vector<WatcherId> Watchers::of_event(std::uint32_t index, const Class& instance_class,
                                          const Event& event, WatcherId until) const {
    std::vector<WatcherId> ids;
    append(ids, events_, Cell{index, event.symbol});
    for (const WatcherId id : class_events_) {
        const Watcher& watcher = *all_.at(id);
        if (watcher.event->symbol == event.symbol && instance_class.is_a(*watcher.of))
            ids.push_back(id);
    }
    return in_order(std::move(ids), until);
}

std::vector<WatcherId> Watchers::of_creation(const Class& instance_class, WatcherId until) const {
    std::vector<WatcherId> ids;
    for (const WatcherId id : created_)
        if (instance_class.is_a(*all_.at(id)->of)) ids.push_back(id);
    return in_order(std::move(ids), until);
}

std::vector<WatcherId> Watchers::of_deletion(std::uint32_t index, const Class& instance_class,
                                             bool only_own) const {
    std::vector<WatcherId> ids;
    append(ids, deleted_on_, index);
    if (only_own) return in_order(std::move(ids), last_id_);
    for (const WatcherId id : deleted_)
        if (instance_class.is_a(*all_.at(id)->of)) ids.push_back(id);
    return in_order(std::move(ids), last_id_);
}

}  // namespace fettle::property
