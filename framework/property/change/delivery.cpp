// Delivery: the handlers are called with the items that were queued for the barrier.

#include <algorithm>
#include <exception>
#include <optional>

#include "changes.h"

namespace fettle::property {

std::string Changes::describe(const Change& change) const {
    return nodes.find(change.instance) ? tree.path(change.instance, *change.property)
                                       : change.property->name;
}

std::string Changes::describe(const Existence& existence) const {
    return existence.path.empty() && nodes.find(existence.instance) ? tree.path(existence.instance)
                                                                    : existence.path;
}

std::string Changes::describe(const Occurrence& occurrence) const {
    const std::string where = nodes.find(occurrence.instance) ? tree.path(occurrence.instance)
                              : occurrence.record.values.empty()
                                  ? std::string("(deleted)")
                                  : tree.text(occurrence.record.values.front());
    return where + " " + occurrence.event->name;
}

/// The text for one item of the queue; a change includes its own cause.
std::string Changes::describe(const QueueItem& item, std::size_t part) const {
    const auto with_cause = [this](const Change& change) {
        return describe(change) + " by " + change.cause.text();
    };
    if (const auto* change = std::get_if<Change>(&item.what)) return with_cause(*change);
    if (const auto* motion = std::get_if<Motion>(&item.what)) {
        const CellChange& moved = motion->changes[part];
        return with_cause({moved.instance, moved.property, {}, {}, motion->cause});
    }
    if (const auto* existence = std::get_if<Existence>(&item.what)) return describe(*existence);
    return describe(std::get<Occurrence>(item.what));
}

namespace {

void hand_over(const Watcher& watcher, const Change& change) {
    watcher.on_change(change);
}
void hand_over(const Watcher& watcher, const Existence& existence) {
    watcher.on_existence(existence);
}
void hand_over(const Watcher& watcher, const Occurrence& occurrence) {
    watcher.on_event(occurrence);
}

}  // namespace

template <class What>
void Changes::call(const Watcher& watcher, const What& what) {
    if (lifetime.ending) return;  // one of the handlers has destroyed the tree
    try {
        hand_over(watcher, what);
    } catch (...) {
        if (errors.first == nullptr) throw;
        errors.report(
            *errors.first, [&] { return describe(what); }, watcher.label);
    }
}

void Changes::deliver_change(const Change& change, WatcherId until) {
    if (nodes.find(change.instance) == nullptr || change.old_value == change.new_value) return;
    watchers.of_change(change, until, queue.called);
    for (const Watcher* watcher : queue.called)
        if (watcher->active) call(*watcher, change);
}

/// After an exception the remaining changes are delivered all the same. The barrier throws the
/// first exception again.
void Changes::deliver_motion(Motion& motion, WatcherId until, std::exception_ptr& error) {
    Change change;
    change.cause = motion.cause;
    for (std::size_t part = 0; part < motion.changes.size() && !lifetime.ending; ++part) {
        CellChange& moved = motion.changes[part];
        change.instance = moved.instance;
        change.property = moved.property;
        change.old_value.swap(moved.old_value);
        change.new_value.swap(moved.new_value);
        queue.part = part;
        try {
            deliver_change(change, until);
        } catch (...) {
            if (!error) error = std::current_exception();
        }
    }
    queue.part = 0;
}

template void Changes::call(const Watcher&, const Occurrence&);  // used by question.cpp

/// A handler may delete an instance that the event refers to; then the remaining handlers are not
/// called.
void Changes::deliver_event(const Occurrence& occurrence, WatcherId until) {
    const Event& event = *occurrence.event;
    std::optional<UndeliveredBegins::Reached> begin;
    if (event.begin != nullptr) begin = queue.undelivered.take(occurrence);
    const auto deleted = [this](const Value& value) { return names_deleted(tree, value); };
    const auto all = watchers.of_event(occurrence.instance, event, until);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Watcher& watcher = *all[i];
        if (!watcher.active || (begin && !begin->is_for(i, all.size()))) continue;
        if (nodes.find(occurrence.instance) == nullptr) return;
        if (event.begin == nullptr && std::ranges::any_of(occurrence.record.values, deleted)) {
            if (event.end != nullptr) queue.undelivered.note(tree, occurrence, {all.size(), i});
            return;
        }
        call(watcher, occurrence);
    }
}

/// Calls the recipients that were fixed when the item was queued.
template <class What>
void Changes::deliver_to(const QueueItem& item, const What& what) {
    for (const WatcherId id : item.recipients) {
        const Watcher* watcher = watchers.find(id);
        if (watcher == nullptr) continue;
        if (watcher->active || item.retire) call(*watcher, what);
        if (lifetime.ending) return;
        if (item.retire && !watcher->active) watchers.stop(id);
    }
}

void Changes::deliver(QueueItem& item, std::exception_ptr& first_error) {
    if (auto* motion = std::get_if<Motion>(&item.what))
        return deliver_motion(*motion, item.until, first_error);
    try {
        deliver_one(item);
    } catch (...) {
        if (!first_error) first_error = std::current_exception();
    }
}

void Changes::deliver_one(QueueItem& item) {
    if (lifetime.ending) return;
    const auto to_all = [this](const Watchers::List& list, const auto& what) {
        for (const Watcher* watcher : list)
            if (watcher->active) call(*watcher, what);
    };
    switch (item.kind) {
        case QueueItem::Kind::change:
            return deliver_change(std::get<Change>(item.what), item.until);
        case QueueItem::Kind::motion:
            return;
        case QueueItem::Kind::initial: {
            auto& change = std::get<Change>(item.what);
            if (nodes.find(change.instance) == nullptr) return;
            change.new_value = tree.peek(change.instance, *change.property);
            return deliver_to(item, change);
        }
        case QueueItem::Kind::created: {
            auto& existence = std::get<Existence>(item.what);
            if (nodes.find(existence.instance) == nullptr) return;
            existence.path = tree.path(existence.instance);
            if (!item.recipients.empty()) return deliver_to(item, existence);
            nodes[existence.instance.index].fresh = false;
            return to_all(watchers.of_creation(*existence.instance_class, item.until), existence);
        }
        case QueueItem::Kind::deleted:
            return deliver_to(item, std::get<Existence>(item.what));
        case QueueItem::Kind::event: {
            const auto& occurrence = std::get<Occurrence>(item.what);
            if (item.retire) return deliver_to(item, occurrence);
            if (nodes.find(occurrence.instance) == nullptr) return;
            return deliver_event(occurrence, item.until);
        }
    }
}

}  // namespace fettle::property
