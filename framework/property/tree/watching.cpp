// Watching: how watchers are registered, and what has to be kept for them. Delivery is
// delivery.cpp.

#include <algorithm>

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

// -----------------------------------------------------------------------------------------------------

namespace {

template <class Handler>
void require_handler(const Handler& handler) {
    if (!handler) throw Error(ErrorKind::wrong_type, "to watch needs a handler, a function");
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
    QueueItem item;
    item.kind = QueueItem::Kind::initial;
    item.what = Change{.instance = instance,
                       .property = &property,
                       .old_value = {},
                       .new_value = {},
                       .cause = state.tree.cause()};
    item.recipients = {recipient};
    state.changes.queue_item(std::move(item));
}

}  // namespace

Connection Tree::watch(Handle instance, const Property& property, ChangeHandler handler,
                       WatchOptions options) {
    State& s = *state_;
    s.instances.require(instance, property);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::cell;
    watcher.index = instance.index;
    watcher.property = property.symbol;
    watcher.on_change = std::move(handler);
    watcher.label = std::move(options.label);
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
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::instance;
    watcher.index = instance.index;
    watcher.on_change = std::move(handler);
    watcher.label = std::move(options.label);
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
    require_handler(handler);
    if (property != nullptr && property->owner != nullptr && !property->owner->is_a(of) &&
        !of.is_a(*property->owner))
        throw Error(ErrorKind::unknown_name, of.name() + " has no such property: \"" +
                                                 property->name + "\" is of " +
                                                 property->owner->name());
    Watcher watcher;
    watcher.kind = WatchKind::of_class;
    watcher.of = &of;
    if (property != nullptr) watcher.property = property->symbol;
    watcher.on_change = std::move(handler);
    watcher.label = std::move(options.label);
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
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::pattern;
    watcher.pattern = std::make_unique<Pattern>(pattern);
    watcher.property = watcher.pattern->only_property();
    watcher.on_change = std::move(handler);
    watcher.label = std::move(options.label);
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
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::created;
    watcher.of = &of;
    watcher.on_existence = std::move(handler);
    watcher.label = std::move(options.label);
    Connection connection = s.changes.watchers.add(std::move(watcher));
    if (options.initial)
        each_instance(s, of, [&](Handle instance) {
            QueueItem item;
            item.kind = QueueItem::Kind::created;
            item.what = Existence{.instance = instance,
                                  .instance_class = &class_of(instance),
                                  .path = {},
                                  .cause = cause(),
                                  .last_values = {}};
            item.recipients = {s.changes.watchers.last_id()};
            s.changes.queue_item(std::move(item));
        });
    return connection;
}

Connection Tree::watch_deleted(const Class& of, ExistenceHandler handler, WatchOptions options) {
    state_->instances.require_own(of);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::deleted;
    watcher.of = &of;
    watcher.on_existence = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->changes.watchers.add(std::move(watcher));
}

Connection Tree::watch_deleted(Handle instance, ExistenceHandler handler, WatchOptions options) {
    state_->instances.require(instance);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::deleted;
    watcher.index = instance.index;
    watcher.on_existence = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->changes.watchers.add(std::move(watcher));
}

Connection Tree::on(Handle instance, const Event& event, EventHandler handler,
                    WatchOptions options) {
    state_->instances.require_event(class_of(instance), event);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::event;
    watcher.index = instance.index;
    watcher.event = &event;
    watcher.on_event = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->changes.watchers.add(std::move(watcher));
}

Connection Tree::on(const Class& of, const Event& event, EventHandler handler,
                    WatchOptions options) {
    state_->instances.require_event(of, event);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::class_event;
    watcher.of = &of;
    watcher.event = &event;
    watcher.on_event = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->changes.watchers.add(std::move(watcher));
}

void Tree::observe(Observer& observer) {
    state_->changes.tell_plain_writes();
    state_->changes.observers.all.push_back(&observer);
}

void Tree::unobserve(Observer& observer) {
    state_->changes.tell_plain_writes();
    if (state_->changes.observers.telling == 0)
        std::erase(state_->changes.observers.all, &observer);
    else  // the places of the others stay until all are told
        std::ranges::replace(state_->changes.observers.all, &observer, nullptr);
}

std::size_t Tree::watcher_count() const {
    return state_->changes.watchers.size();
}

}  // namespace fettle::property
