// Watching: how watchers are registered, and what has to be kept for them. Delivery is
// delivery.cpp.

#include <algorithm>

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

// -----------------------------------------------------------------------------------------------------

void Tree::State::count_interest(const Watcher& watcher, int sign) {
    const auto count = [&](const Property& property) {
        if (Watchers::may_want(watcher, property))
            property.note_interest(property.interest + static_cast<std::uint32_t>(sign));
    };
    if (watcher.property) {  // about one name: whatever else there is need not be looked at
        for (std::uint32_t i = 0; i < classes.size(); ++i) {
            const Property* property = classes[i].property(watcher.property);
            if (property != nullptr && property->owner == &classes[i]) count(*property);
        }
        const auto own = ad_hoc_properties.find(watcher.property);
        if (own != ad_hoc_properties.end()) count(*own->second);
        return;
    }
    for (std::uint32_t i = 0; i < classes.size(); ++i)
        for (const Property& property : classes[i].own_properties_) count(property);
    for (const auto& [name, property] : ad_hoc_properties) count(*property);
}

void Tree::State::refresh_shadows_below(std::uint32_t top) {
    visit_below(top, [this](std::uint32_t i) { shadows.refresh(tree, watchers, nodes.handle(i)); });
    note_listeners();
}

/// Visits every shadowed cell that a broad watcher wants or would want. Only what the watcher may
/// be about is looked at, so that a pattern costs the same whatever else is watched.
template <class Visit>
void Tree::State::each_cell_wanted(const Watcher& watcher, Visit visit) {
    std::vector<std::vector<const Property*>> of_class(classes.size());
    bool any = false;
    for (std::uint32_t c = 0; c < classes.size(); ++c)
        for (const Property* property : classes[c].observed_)
            if (Watchers::may_want(watcher, *property)) {
                of_class[c].push_back(property);
                any = true;
            }
    if (!any) return;
    const auto look_at = [&](std::uint32_t i) {
        for (const Property* property : of_class[nodes[i].class_id])
            if (watchers.wants(watcher, nodes.handle(i), *property))
                visit(nodes.handle(i), *property);
    };
    if (watcher.kind == WatchKind::pattern) {
        if (const std::uint32_t top = top_of(*watcher.pattern); top != 0) visit_below(top, look_at);
        return;
    }
    for (std::uint32_t i = 1; i < nodes.end(); ++i)
        if (nodes[i].alive()) look_at(i);
}

/// The instance below which everything hangs that a pattern can match: "world.crates" of
/// "world.crates.*.position". 0 where there is none.
std::uint32_t Tree::State::top_of(const Pattern& pattern) const {
    std::uint32_t top = root.index;
    for (std::size_t i = 0; i + 1 < pattern.segments().size() && top != 0; ++i) {
        const std::string& name = pattern.segments()[i];
        if (name.find('*') != std::string::npos) break;
        top = nodes.child(top, NodeName::look_up(name));
    }
    return top;
}

void Tree::State::watcher_added(const Watcher& watcher) {
    if (watcher.index != 0) {
        nodes[watcher.index].watched = true;
        shadows.refresh(tree, watchers, nodes.handle(watcher.index));
    } else if (watcher.broad()) {
        count_interest(watcher, 1);
        each_cell_wanted(watcher, [this](Handle instance, const Property& property) {
            shadows.keep(tree, instance, property);
        });
    }
    note_listeners();
}

void Tree::State::watcher_removed(const Watcher& watcher) {
    if (watcher.index != 0) {
        nodes[watcher.index].watched = watchers.any_on(watcher.index);
        shadows.refresh(tree, watchers, nodes.handle(watcher.index));
    } else if (watcher.broad()) {
        count_interest(watcher, -1);
        each_cell_wanted(watcher, [this](Handle instance, const Property& property) {
            const Cell cell{instance.index, property.symbol};
            if (!watchers.directly_watched(cell) && !watchers.broadly_watched(instance, property))
                shadows.drop(cell);
        });
    }
    note_listeners();
}

namespace {

template <class Handler>
void require_handler(const Handler& handler) {
    if (!handler) throw Error(ErrorKind::wrong_type, "to watch needs a handler, a function");
}

template <class Visit>
void each_instance(Tree::State& state, const Class& of, Visit visit) {
    for (std::uint32_t i = 1; i < state.nodes.end(); ++i)
        if (state.nodes[i].alive() && state.classes[state.nodes[i].class_id].is_a(of))
            visit(state.nodes.handle(i));
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
    state.queue_item(std::move(item));
}

}  // namespace

Connection Tree::watch(Handle instance, const Property& property, ChangeHandler handler,
                       WatchOptions options) {
    State& s = *state_;
    s.require(instance, property);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::cell;
    watcher.index = instance.index;
    watcher.property = property.symbol;
    watcher.on_change = std::move(handler);
    watcher.label = std::move(options.label);
    Connection connection = s.watchers.add(std::move(watcher));
    if (options.initial) queue_initial(s, instance, property, s.watchers.last_id());
    return connection;
}

Connection Tree::watch(Handle instance, std::string_view name, ChangeHandler handler,
                       WatchOptions options) {
    return watch(instance, property(instance, name), std::move(handler), std::move(options));
}

Connection Tree::watch(Handle instance, ChangeHandler handler, WatchOptions options) {
    State& s = *state_;
    s.require(instance);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::instance;
    watcher.index = instance.index;
    watcher.on_change = std::move(handler);
    watcher.label = std::move(options.label);
    Connection connection = s.watchers.add(std::move(watcher));
    if (options.initial)
        for (const Property* property : properties(instance))
            queue_initial(s, instance, *property, s.watchers.last_id());
    return connection;
}

Connection Tree::watch(const Class& of, const Property* property, ChangeHandler handler,
                       WatchOptions options) {
    State& s = *state_;
    s.require_own(of);
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
    Connection connection = s.watchers.add(std::move(watcher));
    if (options.initial)
        each_instance(s, of, [&](Handle instance) {
            for (const Property* p : properties(instance))
                if (property == nullptr || p->symbol == property->symbol)
                    queue_initial(s, instance, *p, s.watchers.last_id());
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
    Connection connection = s.watchers.add(std::move(watcher));
    if (options.initial) {
        const Pattern matching(pattern);
        each_instance(s, object_class(), [&](Handle instance) {
            for (const Property* p : properties(instance))
                if (matching.matches(*this, instance, *p))
                    queue_initial(s, instance, *p, s.watchers.last_id());
        });
    }
    return connection;
}

Connection Tree::watch_created(const Class& of, ExistenceHandler handler, WatchOptions options) {
    State& s = *state_;
    s.require_own(of);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::created;
    watcher.of = &of;
    watcher.on_existence = std::move(handler);
    watcher.label = std::move(options.label);
    Connection connection = s.watchers.add(std::move(watcher));
    if (options.initial)
        each_instance(s, of, [&](Handle instance) {
            QueueItem item;
            item.kind = QueueItem::Kind::created;
            item.what = Existence{.instance = instance,
                                  .instance_class = &class_of(instance),
                                  .path = {},
                                  .cause = cause(),
                                  .last_values = {}};
            item.recipients = {s.watchers.last_id()};
            s.queue_item(std::move(item));
        });
    return connection;
}

Connection Tree::watch_deleted(const Class& of, ExistenceHandler handler, WatchOptions options) {
    state_->require_own(of);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::deleted;
    watcher.of = &of;
    watcher.on_existence = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->watchers.add(std::move(watcher));
}

Connection Tree::watch_deleted(Handle instance, ExistenceHandler handler, WatchOptions options) {
    state_->require(instance);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::deleted;
    watcher.index = instance.index;
    watcher.on_existence = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->watchers.add(std::move(watcher));
}

Connection Tree::on(Handle instance, const Event& event, EventHandler handler,
                    WatchOptions options) {
    state_->require_event(class_of(instance), event);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::event;
    watcher.index = instance.index;
    watcher.event = &event;
    watcher.on_event = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->watchers.add(std::move(watcher));
}

Connection Tree::on(const Class& of, const Event& event, EventHandler handler,
                    WatchOptions options) {
    state_->require_event(of, event);
    require_handler(handler);
    Watcher watcher;
    watcher.kind = WatchKind::class_event;
    watcher.of = &of;
    watcher.event = &event;
    watcher.on_event = std::move(handler);
    watcher.label = std::move(options.label);
    return state_->watchers.add(std::move(watcher));
}

void Tree::observe(Observer& observer) {
    state_->tell_plain_writes();
    state_->observers.push_back(&observer);
}

void Tree::unobserve(Observer& observer) {
    state_->tell_plain_writes();
    if (state_->telling == 0)
        std::erase(state_->observers, &observer);
    else  // the places of the others stay until all are told
        std::ranges::replace(state_->observers, &observer, nullptr);
}

std::size_t Tree::watcher_count() const {
    return state_->watchers.size();
}

}  // namespace fettle::property
