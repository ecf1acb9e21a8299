#include "transition.h"

#include <algorithm>

#include <tree/state.h>

namespace fettle::property {

Transition::Transition(Tree::State& state)
    : instances_(state.instances),
      nodes_(instances_.nodes),
      tree_(state.tree),
      changes_(state.changes),
      restored_(*state.restored_event),
      step_before_(state.changes.author.step) {
    former_.reserve(nodes_.alive());
    for (std::uint32_t i = 1; i < nodes_.end(); ++i)
        if (nodes_[i].alive()) note(i);
}

void Transition::note(std::uint32_t index) {
    const Node& node = nodes_[index];
    const Handle self = nodes_.handle(index);
    const Class& of = instances_.classes[node.class_id];
    former_.push_back({self, &of, node.name, node.fresh != 0});
    const bool broad = changes_.watchers.any_broad();
    if (!node.watched && !broad && !changes_.watchers.any_deleted()) return;
    for (const Property* property : tree_.properties(self))
        if (watched(self, node, *property))
            known_.push_back({self, property, instances_.read(index, node, *property)});
    const bool notified =
        changes_.needs_deletion_notice(self, of, node.fresh) ||
        !changes_.watchers.of_event(self, *changes_.deleted_event, changes_.watchers.last_id())
             .empty();
    if (!notified && !node.watched) return;
    deletion_notices_.push_back(changes_.deletion_notice_of(self, of, notified));
}

bool Transition::watched(Handle self, const Node& node, const Property& property) const {
    return (node.watched && changes_.watchers.directly_watched({self.index, property.symbol})) ||
           (changes_.watchers.any_broad() && changes_.watchers.broadly_watched(self, property));
}

void Transition::finish() {
    const Tree::CauseScope scope(tree_, Writer::restore);
    changes_.writes.note_jump(step_before_, changes_.author.step);
    changes_.forget_fresh();
    drop_queued();
    end_instances();
    restore_watchers();
    notify_created();
    notify_changed();
    if (restored_.listeners != 0)
        tree_.emit(instances_.root, restored_,
                   {Value(static_cast<std::int64_t>(changes_.author.step)),
                    Value(static_cast<std::int64_t>(step_before_))});
    changes_.notify([](Observer& o) { o.restored(); });
}

// Reports about the abandoned state are dropped, except reports of deletions and initial values.
void Transition::drop_queued() {
    const std::size_t dropped = std::erase_if(changes_.queue.items, [](const QueueItem& item) {
        return !item.retire && item.kind != QueueItem::Kind::initial;
    });
    changes_.forget_messages(dropped);
    for (QueueItem& item : changes_.queue.items) item.trigger = -1;
    changes_.queue.changes.clear();
    changes_.queue.undelivered.clear();
}

bool Transition::still_exists(const Former& former) const {
    const Node* const node = nodes_.find(former.instance);
    return node != nullptr && &instances_.class_of(*node) == former.of;
}

/// The data of an instance that existed before.
const Transition::Former& Transition::before(Handle instance) const {
    return *std::lower_bound(
        former_.begin(), former_.end(), instance.index,
        [](const Former& l, std::uint32_t index) { return l.instance.index < index; });
}

void Transition::end_instances() {
    const Cause cause = tree_.cause();
    for (Existence& gone : deletion_notices_) {
        const Former& was = before(gone.instance);
        if (still_exists(was)) continue;
        instances_.tombstones.add({gone.instance, was.of, was.name.text(), gone.path, cause});
        gone.cause = cause;
        changes_.queue_deletion_notice(std::move(gone), was.fresh);
    }
    // An instance without a deletion report gets a tombstone without a path.
    std::size_t latest = 0;
    for (const Former& former : former_) {
        if (still_exists(former) || ++latest > 1024) continue;
        const auto reported =
            std::any_of(deletion_notices_.begin(), deletion_notices_.end(),
                        [&](const Existence& gone) { return gone.instance == former.instance; });
        if (!reported)
            instances_.tombstones.add({former.instance, former.of, former.name.text(),
                                       "the " + former.of->name(), cause});
    }
}

void Transition::restore_watchers() {
    for (const std::uint32_t index : changes_.watchers.watched_slots()) {
        const bool lives = index < nodes_.end() && nodes_[index].alive();
        changes_.watchers.retire_others(lives ? nodes_.handle(index) : Handle{index, 0});
        if (lives) nodes_[index].watched = changes_.watchers.any_on(index);
    }
    changes_.shadows.clear();
    if (changes_.watchers.any_broad()) {
        for (std::uint32_t i = 1; i < nodes_.end(); ++i)
            if (nodes_[i].alive()) changes_.refresh_shadows(i);
    } else {
        for (const std::uint32_t index : changes_.watchers.watched_slots())
            changes_.refresh_shadows(index);
    }
}

void Transition::notify_created() {
    if (!changes_.watchers.any_created()) return;
    std::size_t next = 0;
    for (std::uint32_t i = 1; i < nodes_.end(); ++i) {
        if (!nodes_[i].alive()) continue;
        const Handle self = nodes_.handle(i);
        while (next < former_.size() && former_[next].instance.index < i) ++next;
        if (next < former_.size() && former_[next].instance == self && still_exists(former_[next]))
            continue;
        changes_.queue_creation(self, instances_.class_of(nodes_[i]));
    }
}

/// `known_` is sorted by slot.
std::span<const Transition::Known> Transition::known_of(Handle instance) const {
    const auto first = std::partition_point(known_.begin(), known_.end(), [&](const Known& known) {
        return known.instance.index < instance.index;
    });
    const auto last = std::partition_point(first, known_.end(), [&](const Known& known) {
        return known.instance.index == instance.index;
    });
    return {first, last};
}

void Transition::notify_changed() {
    const Cause cause = tree_.cause();
    for (const Known& known : known_) {
        if (!still_exists(before(known.instance))) continue;
        const Node* const node = nodes_.find(known.instance);
        const Property* property = tree_.find(known.instance, known.property->symbol);
        const Value now =
            property == nullptr ? Value() : instances_.read(known.instance.index, *node, *property);
        if (!(now == known.value))
            changes_.queue_change(known.instance, *known.property, known.value, now, cause);
    }
    // Ad-hoc properties that had been removed exist again; their old values are unknown.
    for (const Former& former : former_) {
        const Node* node = nodes_.find(former.instance);
        if (!still_exists(former) || !node->has_ad_hoc) continue;
        const std::span<const Known> of_it = known_of(former.instance);
        for (const Property* property : tree_.ad_hoc(former.instance)) {
            const bool value_known =
                std::any_of(of_it.begin(), of_it.end(),
                            [&](const Known& known) { return known.property == property; });
            if (value_known || !watched(former.instance, *node, *property)) continue;
            changes_.queue_change(former.instance, *property, Value(),
                                  instances_.read(former.instance.index, *node, *property), cause);
        }
    }
}

}  // namespace fettle::property
