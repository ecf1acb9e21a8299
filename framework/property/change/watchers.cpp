#include "watchers.h"

#include <algorithm>
#include <unordered_set>

#include <values/names_above.h>
#include <values/weight.h>

#include "changes.h"

namespace fettle::property {

void Connection::stop() {
    if (const auto watchers = watchers_.lock()) (*watchers)->stop(id_);
}

bool Connection::active() const {
    const auto watchers = watchers_.lock();
    return watchers && (*watchers)->active(id_);
}

WatcherList* Watchers::list_of(const Watcher& watcher) {
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
            return &broad_lists_[watcher.property];
        case WatchKind::created:
            return &created_;
        case WatchKind::class_event:
            return &class_events_;
    }
    return nullptr;
}

void WatcherList::take_out(const Watcher& watcher) {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), watcher.id,
                                     [](const Entry& e, WatcherId id) { return e.id < id; });
    if (at == entries_.end() || at->watcher != &watcher) return;
    at->watcher = nullptr;
    if (++holes_ * 2 <= entries_.size()) return;
    std::erase_if(entries_, [](const Entry& entry) { return entry.watcher == nullptr; });
    holes_ = 0;
}

void WatcherList::append_to(std::vector<Watcher*>& out) const {
    for (const Entry& entry : entries_)
        if (entry.watcher != nullptr) out.push_back(entry.watcher);
}

Connection Watchers::add(Watcher watcher) {
    changes_.tree.require_changeable("watch anything");
    watcher.id = ++last_id_;
    Watcher& kept =
        *all_.emplace(last_id_, std::make_unique<Watcher>(std::move(watcher))).first->second;
    changes_.weight.add(weight_of_watcher);
    list_of(kept)->add(kept);
    if (kept.index != 0) on_index_[kept.index].add(kept);
    if (kept.event != nullptr) ++kept.event->listeners;
    broad_ += kept.broad();
    changes_.watcher_added(kept);
    return {self_, kept.id};
}

void Watchers::stop(WatcherId id) {
    const auto found = all_.find(id);
    if (found == all_.end()) return;
    std::unique_ptr<Watcher> watcher = std::move(found->second);
    all_.erase(found);
    if (watcher->active) {  // otherwise it was retired before
        watcher->active = false;
        unlist(*watcher);
        changes_.watcher_removed(*watcher);
    }
    if (handlers_run_ > 0) stopped_.push_back(std::move(watcher));
}

void Watchers::unlist(Watcher& watcher) {
    changes_.weight.add(-weight_of_watcher);
    list_of(watcher)->take_out(watcher);
    broad_ -= watcher.broad();
    const auto drop_if_empty = [](auto& map, const auto& key) {
        const auto entry = map.find(key);
        if (entry != map.end() && entry->second.empty()) map.erase(entry);
    };
    drop_if_empty(cells_, Cell{watcher.index, watcher.property});
    drop_if_empty(instances_, watcher.index);
    drop_if_empty(deleted_on_, watcher.index);
    drop_if_empty(broad_lists_, watcher.property);
    if (watcher.event != nullptr) {
        --watcher.event->listeners;
        drop_if_empty(events_, Cell{watcher.index, watcher.event->symbol});
    }
    if (const auto on = on_index_.find(watcher.index); on != on_index_.end()) {
        on->second.take_out(watcher);
        if (on->second.empty()) on_index_.erase(on);
    }
}

void Watchers::retire(Handle gone, const std::vector<WatcherId>& keep) {
    retire_if(
        gone.index, [&](const Watcher& each) { return each.generation == gone.generation; }, keep);
}

void Watchers::retire_others(Handle lives) {
    retire_if(lives.index, [&](const Watcher& each) { return each.generation != lives.generation; },
              {});
}

template <class Test>
void Watchers::retire_if(std::uint32_t index, Test test, const std::vector<WatcherId>& keep) {
    const auto on = on_index_.find(index);
    if (on == on_index_.end()) return;
    List retired;
    on->second.append_to(retired);
    std::erase_if(retired, [&](const Watcher* each) { return !test(*each); });
    const std::unordered_set<WatcherId> kept(keep.begin(), keep.end());
    for (Watcher* watcher : retired) {
        unlist(*watcher);
        watcher->active = false;
        if (kept.contains(watcher->id)) continue;
        const auto found = all_.find(watcher->id);
        if (handlers_run_ > 0) stopped_.push_back(std::move(found->second));
        all_.erase(found);
    }
}

std::vector<std::uint32_t> Watchers::watched_slots() const {
    std::vector<std::uint32_t> slots;
    for (const auto& [index, watchers] : on_index_) slots.push_back(index);
    std::sort(slots.begin(), slots.end());
    return slots;
}

Watcher* Watchers::find(WatcherId id) const {
    const auto found = all_.find(id);
    return found == all_.end() ? nullptr : found->second.get();
}

// --- Search for watchers

bool Watchers::may_match(const Watcher& watcher, const Property& property) {
    if (watcher.kind == WatchKind::pattern) return watcher.pattern->may_match(property.symbol);
    return (!watcher.property || watcher.property == property.symbol) &&
           (property.owner == nullptr || property.owner->is_a(*watcher.of) ||
            watcher.of->is_a(*property.owner));
}

bool Watchers::matches(const Watcher& watcher, Handle instance, const Property& property) const {
    if (watcher.kind == WatchKind::pattern)
        return watcher.pattern->matches(changes_.tree, instance, property);
    return (!watcher.property || watcher.property == property.symbol) &&
           changes_.tree.class_of(instance).is_a(*watcher.of);
}

/// Visits the broad watchers that could match the property, until a visit returns true.
template <class Visit>
bool Watchers::any_broad_on(const Property& property, Visit visit) const {
    for (const Symbol name : {property.symbol, Symbol()}) {
        const auto list = broad_lists_.find(name);
        if (list != broad_lists_.end() && list->second.any(visit)) return true;
    }
    return false;
}

namespace {

// Tests broad watchers against one property of one instance. The path is computed once for all
// patterns.
class Interest {
  public:
    Interest(const Tree& tree, Handle instance, const Property& property)
        : tree_(tree), instance_(instance), property_(property) {}

    bool of(const Watcher& watcher) {
        if (watcher.kind == WatchKind::of_class) return tree_.class_of(instance_).is_a(*watcher.of);
        if (patterns_++ == 0) return watcher.pattern->matches(tree_, instance_, property_);
        if (patterns_ == 2) {
            names_ = names_above(tree_, instance_);
            is_attached_ = !names_.empty() || instance_ == tree_.root();
            names_.push_back(property_.name);
        }
        return is_attached_ && watcher.pattern->matches(names_);
    }

  private:
    const Tree& tree_;
    Handle instance_;
    const Property& property_;
    std::vector<std::string> names_;
    int patterns_ = 0;  // tested so far; the path is computed at the second one
    bool is_attached_ = false;
};

}  // namespace

bool Watchers::broadly_watched(Handle instance, const Property& property) const {
    if (property.shortcut.interest == 0) return false;
    Interest interest(changes_.tree, instance, property);
    return any_broad_on(property, [&](const Watcher* watcher) { return interest.of(*watcher); });
}

std::uint32_t Watchers::interest(const Property& property) const {
    std::uint32_t count = 0;
    any_broad_on(property, [&](const Watcher* watcher) {
        count += may_match(*watcher, property);
        return false;
    });
    return count;
}

namespace {

// Keeps the watchers registered up to `until`, in the order of registration.
void keep_registered_until(std::vector<Watcher*>& list, WatcherId until) {
    std::erase_if(list, [until](const Watcher* watcher) { return watcher->id > until; });
    const auto older = [](const Watcher* a, const Watcher* b) { return a->id < b->id; };
    if (!std::is_sorted(list.begin(), list.end(), older))
        std::sort(list.begin(), list.end(), older);
}

template <class Map, class Key>
void append(std::vector<Watcher*>& out, const Map& map, const Key& key) {
    if (map.empty()) return;
    if (const auto found = map.find(key); found != map.end()) found->second.append_to(out);
}

}  // namespace

void Watchers::of_change(const Change& change, WatcherId until, List& out) const {
    out.clear();
    append(out, cells_, Cell{change.instance.index, change.property->symbol});
    append(out, instances_, change.instance.index);
    if (change.property->shortcut.interest != 0) {
        Interest interest(changes_.tree, change.instance, *change.property);
        any_broad_on(*change.property, [&](Watcher* watcher) {
            if (interest.of(*watcher)) out.push_back(watcher);
            return false;
        });
    }
    keep_registered_until(out, until);
}

Watchers::List Watchers::of_event(Handle instance, const Event& event, WatcherId until) const {
    return of_event(instance.index, changes_.tree.class_of(instance), event, until);
}

Watchers::List Watchers::of_event(std::uint32_t index, const Class& instance_class,
                                  const Event& event, WatcherId until) const {
    List out;
    append(out, events_, Cell{index, event.symbol});
    class_events_.any([&](Watcher* watcher) {
        if (watcher->event->symbol == event.symbol && instance_class.is_a(*watcher->of))
            out.push_back(watcher);
        return false;
    });
    keep_registered_until(out, until);
    return out;
}

Watchers::List Watchers::of_creation(const Class& instance_class, WatcherId until) const {
    List out;
    created_.append_to(out);
    std::erase_if(out, [&](const Watcher* each) { return !instance_class.is_a(*each->of); });
    keep_registered_until(out, until);
    return out;
}

std::vector<WatcherId> Watchers::of_deletion(Handle instance, const Class& instance_class,
                                             bool only_own) const {
    List out;
    append(out, deleted_on_, instance.index);
    // Within a restore, the slot may have watchers of two instances.
    std::erase_if(out,
                  [&](const Watcher* each) { return each->generation != instance.generation; });
    if (!only_own)
        deleted_.any([&](Watcher* watcher) {
            if (instance_class.is_a(*watcher->of)) out.push_back(watcher);
            return false;
        });
    keep_registered_until(out, last_id_);
    std::vector<WatcherId> ids;
    ids.reserve(out.size());
    for (const Watcher* watcher : out) ids.push_back(watcher->id);
    return ids;
}

}  // namespace fettle::property
