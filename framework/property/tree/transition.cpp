#include "transition.h"

#include <algorithm>

#include "state.h"

namespace fettle::property {

Transition::Transition(Tree::State& state) : state_(state), left_(state.step) {
    // A formula that was to settle tells its value as it would have.
    lived_.reserve(state_.nodes.alive());
    for (std::uint32_t i = 1; i < state_.nodes.end(); ++i)
        if (state_.nodes[i].alive()) note(i);
}

void Transition::note(std::uint32_t index) {
    const Node& node = state_.nodes[index];
    const Handle self = state_.nodes.handle(index);
    const Class& of = state_.classes[node.class_id];
    lived_.push_back({self, &of, node.name, node.fresh != 0});
    const bool broad = state_.watchers.any_broad();
    if (!node.watched && !broad && !state_.watchers.any_deleted()) return;
    for (const Property* property : state_.tree.properties(self))
        if (watched(self, node, *property))
            known_.push_back({self, property, state_.read(index, node, *property)});
    const bool told =
        state_.wants_farewell(self, of, node.fresh) ||
        !state_.watchers.of_event(self, *state_.deleted_event, state_.watchers.last_id()).empty();
    if (!told && !node.watched) return;
    Existence gone{.instance = self,
                   .instance_class = &of,
                   .path = state_.tree.path(self),
                   .cause = {},
                   .last_values = {}};
    if (told)
        for (const Property* property : state_.tree.properties(self))
            gone.last_values.emplace_back(property, state_.read(index, node, *property));
    farewells_.push_back(std::move(gone));
}

bool Transition::watched(Handle self, const Node& node, const Property& property) const {
    return (node.watched && state_.watchers.directly_watched({self.index, property.symbol})) ||
           (state_.watchers.any_broad() && state_.watchers.broadly_watched(self, property));
}

void Transition::finish() {
    const Tree::CauseScope scope(state_.tree, Writer::restore);
    if (state_.step < left_) state_.writes.went_back(state_.step);
    for (const std::uint32_t index : state_.fresh) state_.nodes[index].fresh = false;
    state_.fresh.clear();
    drop_queued();
    end_instances();
    watch_again();
    tell_created();
    tell_changed();
    if (state_.restored_event->listeners != 0)
        state_.tree.emit(state_.root, *state_.restored_event,
                         {Value(static_cast<std::int64_t>(state_.step)),
                          Value(static_cast<std::int64_t>(left_))});
    state_.tell([](Observer& o) { o.restored(); });
}

// What was to be told of a time that is left is no longer true; an end that somebody waits for is.
void Transition::drop_queued() {
    std::erase_if(state_.queue, [](const QueueItem& item) {
        return !item.retire && item.kind != QueueItem::Kind::initial;
    });
    for (QueueItem& item : state_.queue) item.trigger = -1;
    state_.queued_changes.clear();
    state_.untold.clear();
}

void Transition::end_instances() {
    const Cause cause = state_.tree.cause();
    for (Existence& gone : farewells_) {
        if (state_.nodes.find(gone.instance) != nullptr) continue;
        const auto lived = std::lower_bound(
            lived_.begin(), lived_.end(), gone.instance.index,
            [](const Lived& l, std::uint32_t index) { return l.instance.index < index; });
        state_.bury({gone.instance, lived->of, lived->name.text(), gone.path, cause});
        gone.cause = cause;
        state_.queue_farewell(std::move(gone), lived->fresh);
    }
    // Whoever has no farewell is remembered without a path.
    std::size_t latest = 0;
    for (const Lived& lived : lived_) {
        if (state_.nodes.find(lived.instance) != nullptr || ++latest > 1024) continue;
        const auto told =
            std::any_of(farewells_.begin(), farewells_.end(),
                        [&](const Existence& gone) { return gone.instance == lived.instance; });
        if (!told)
            state_.bury(
                {lived.instance, lived.of, lived.name.text(), "the " + lived.of->name(), cause});
    }
}

void Transition::watch_again() {
    for (const std::uint32_t index : state_.watchers.watched_slots())
        state_.nodes[index].watched = true;
    state_.shadows = {};
    if (state_.watchers.any_broad()) {
        for (std::uint32_t i = 1; i < state_.nodes.end(); ++i)
            if (state_.nodes[i].alive())
                state_.shadows.refresh(state_.tree, state_.watchers, state_.nodes.handle(i));
    } else {
        for (const std::uint32_t index : state_.watchers.watched_slots())
            state_.shadows.refresh(state_.tree, state_.watchers, state_.nodes.handle(index));
    }
    state_.note_listeners();
}

void Transition::tell_created() {
    if (!state_.watchers.any_created()) return;
    std::size_t next = 0;
    for (std::uint32_t i = 1; i < state_.nodes.end(); ++i) {
        if (!state_.nodes[i].alive()) continue;
        const Handle self = state_.nodes.handle(i);
        while (next < lived_.size() && lived_[next].instance.index < i) ++next;
        if (next < lived_.size() && lived_[next].instance == self) continue;
        QueueItem item;
        item.kind = QueueItem::Kind::created;
        item.what = Existence{.instance = self,
                              .instance_class = &state_.classes[state_.nodes[i].class_id],
                              .path = {},
                              .cause = state_.tree.cause(),
                              .last_values = {}};
        state_.queue_item(std::move(item));
    }
}

/// Noted in the order of the slots.
std::span<const Transition::Known> Transition::known_of(Handle instance) const {
    const auto first = std::partition_point(known_.begin(), known_.end(), [&](const Known& known) {
        return known.instance.index < instance.index;
    });
    const auto last = std::partition_point(first, known_.end(), [&](const Known& known) {
        return known.instance.index == instance.index;
    });
    return {first, last};
}

void Transition::tell_changed() {
    const Cause cause = state_.tree.cause();
    for (const Known& known : known_) {
        const Node* node = state_.nodes.find(known.instance);
        if (node == nullptr) continue;
        const Property* property = state_.tree.find(known.instance, known.property->symbol);
        const Value now =
            property == nullptr ? Value() : state_.read(known.instance.index, *node, *property);
        if (!(now == known.value))
            state_.queue_change(known.instance, *known.property, known.value, now, cause);
    }
    // Properties that somebody had removed since: nothing of them was known.
    for (const Lived& lived : lived_) {
        const Node* node = state_.nodes.find(lived.instance);
        if (node == nullptr || !node->has_ad_hoc) continue;
        const std::span<const Known> of_it = known_of(lived.instance);
        for (const Property* property : state_.tree.ad_hoc(lived.instance)) {
            const bool told = std::any_of(of_it.begin(), of_it.end(), [&](const Known& known) {
                return known.property == property;
            });
            if (told || !watched(lived.instance, *node, *property)) continue;
            state_.queue_change(lived.instance, *property, Value(),
                                state_.read(lived.instance.index, *node, *property), cause);
        }
    }
}

}  // namespace fettle::property
