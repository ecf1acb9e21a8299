// Registration of watchers. Delivery is in delivery.cpp.

#include <algorithm>

#include "state.h"

namespace fettle::property {

namespace {

template <class Handler>
Watcher watcher_of(WatchKind kind, Handler& handler, WatchOptions& options) {
    if (!handler)
        throw Error(ErrorKind::wrong_type, "watch: expected a function as the handler, got none");
    Watcher watcher;
    watcher.kind = kind;
    watcher.label = std::move(options.label);
    if constexpr (std::is_same_v<Handler, ChangeHandler>)
        watcher.on_change = std::move(handler);
    else if constexpr (std::is_same_v<Handler, ExistenceHandler>)
        watcher.on_existence = std::move(handler);
    else
        watcher.on_event = std::move(handler);
    return watcher;
}

// The watchers of an instance that is being deleted have been notified of it already. A watcher
// that is added now would not be removed, and would receive changes of the next instance in the
// slot.
void watch_instance(const Tree::State& state, Watcher& watcher, Handle instance) {
    if (state.instances.nodes[instance.index].being_deleted)
        state.underway.require_staying(state.instances, instance, "watch it");
    watcher.index = instance.index;
    watcher.generation = instance.generation;
}

template <class Visit>
void each_instance(Tree::State& state, const Class& of, Visit visit) {
    for (std::uint32_t i = 1; i < state.instances.nodes.end(); ++i)
        if (state.instances.nodes[i].alive() &&
            state.instances.classes[state.instances.nodes[i].class_id].is_a(of))
            visit(state.instances.nodes.handle(i));
}

void queue_initial(Tree::State& state, Handle instance, const Property& property,
                   WatcherId recipient) {
    state.changes.queue_item({.kind = QueueItem::Kind::initial,
                              .what = Change{.instance = instance,
                                             .property = &property,
                                             .old_value = {},
                                             .new_value = {},
                                             .cause = state.tree.cause()},
                              .recipients = {recipient}});
}

}  // namespace

Connection Tree::watch(Handle instance, const Property& property, ChangeHandler handler,
                       WatchOptions options) {
    State& s = *state_;
    s.instances.require(instance, property);
    Watcher watcher = watcher_of(WatchKind::cell, handler, options);
    watch_instance(s, watcher, instance);
    watcher.property = property.symbol;
    Connection connection = s.changes.watchers.add(std::move(watcher));
    if (options.initial) queue_initial(s, instance, property, s.changes.watchers.last_id());
    return connection;
}

Connection Tree::watch(Handle instance, std::string_view name, ChangeHandler handler,
                       WatchOptions options) {
    return watch(instance, property(instance, name), std::move(handler), std::move(options));
}

Connection Tree::watch(Handle instance, ChangeHandler handler, WatchOptions options) {
    State& s = *state_;
    s.instances.require(instance);
    Watcher watcher = watcher_of(WatchKind::instance, handler, options);
    watch_instance(s, watcher, instance);
    Connection connection = s.changes.watchers.add(std::move(watcher));
    if (options.initial)
        for (const Property* property : properties(instance))
            queue_initial(s, instance, *property, s.changes.watchers.last_id());
    return connection;
}

Connection Tree::watch(const Class& of, const Property* property, ChangeHandler handler,
                       WatchOptions options) {
    State& s = *state_;
    s.instances.require_own(of);
    if (property != nullptr && property->owner != nullptr && !property->owner->is_a(of) &&
        !of.is_a(*property->owner))
        throw Error(ErrorKind::unknown_name, of.name() + " has no such property: \"" +
                                                 property->name + "\" is of " +
                                                 property->owner->name());
    Watcher watcher = watcher_of(WatchKind::of_class, handler, options);
    watcher.of = &of;
    if (property != nullptr) watcher.property = property->symbol;
    Connection connection = s.changes.watchers.add(std::move(watcher));
    if (options.initial)
        each_instance(s, of, [&](Handle instance) {
            for (const Property* p : properties(instance))
                if (property == nullptr || p->symbol == property->symbol)
                    queue_initial(s, instance, *p, s.changes.watchers.last_id());
        });
    return connection;
}

Connection Tree::watch_pattern(std::string_view pattern, ChangeHandler handler,
                               WatchOptions options) {
    State& s = *state_;
    Watcher watcher = watcher_of(WatchKind::pattern, handler, options);
    watcher.pattern = std::make_unique<Pattern>(pattern);
    watcher.property = watcher.pattern->only_property();
    Connection connection = s.changes.watchers.add(std::move(watcher));
    if (options.initial) {
        const Pattern matching(pattern);
        each_instance(s, object_class(), [&](Handle instance) {
            for (const Property* p : properties(instance))
                if (matching.matches(*this, instance, *p))
                    queue_initial(s, instance, *p, s.changes.watchers.last_id());
        });
    }
    return connection;
}

Connection Tree::watch_created(const Class& of, ExistenceHandler handler, WatchOptions options) {
    State& s = *state_;
    s.instances.require_own(of);
    Watcher watcher = watcher_of(WatchKind::created, handler, options);
    watcher.of = &of;
    Connection connection = s.changes.watchers.add(std::move(watcher));
    if (options.initial)
        each_instance(s, of, [&](Handle instance) {
            s.changes.queue_creation(instance, class_of(instance), s.changes.watchers.last_id());
        });
    return connection;
}

Connection Tree::watch_deleted(const Class& of, ExistenceHandler handler, WatchOptions options) {
    state_->instances.require_own(of);
    Watcher watcher = watcher_of(WatchKind::deleted, handler, options);
    watcher.of = &of;
    return state_->changes.watchers.add(std::move(watcher));
}

Connection Tree::watch_deleted(Handle instance, ExistenceHandler handler, WatchOptions options) {
    state_->instances.require(instance);
    Watcher watcher = watcher_of(WatchKind::deleted, handler, options);
    watch_instance(*state_, watcher, instance);
    return state_->changes.watchers.add(std::move(watcher));
}

Connection Tree::on(Handle instance, const Event& event, EventHandler handler,
                    WatchOptions options) {
    state_->instances.require_event(class_of(instance), event);
    Watcher watcher = watcher_of(WatchKind::event, handler, options);
    watch_instance(*state_, watcher, instance);
    watcher.event = &event;
    return state_->changes.watchers.add(std::move(watcher));
}

Connection Tree::on(const Class& of, const Event& event, EventHandler handler,
                    WatchOptions options) {
    state_->instances.require_event(of, event);
    Watcher watcher = watcher_of(WatchKind::class_event, handler, options);
    watcher.of = &of;
    watcher.event = &event;
    return state_->changes.watchers.add(std::move(watcher));
}

void Tree::observe(Observer& observer) {
    state_->lifetime.require_going_on("be observed");
    state_->changes.report_plain_writes();
    state_->changes.observers.all.push_back(&observer);
}

void Tree::unobserve(Observer& observer) {
    state_->changes.report_plain_writes();
    if (state_->changes.observers.running_calls == 0)
        std::erase(state_->changes.observers.all, &observer);
    else  // positions must not change during a call of the observers
        std::ranges::replace(state_->changes.observers.all, &observer, nullptr);
}

std::size_t Tree::watcher_count() const {
    return state_->changes.watchers.size();
}

}  // namespace fettle::property
