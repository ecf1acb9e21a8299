// Delivery: what has changed is queued, and handlers hear of it at barriers.
//
// A barrier runs in generations: everything queued so far is delivered; what the handlers write
// meanwhile is the next generation. Changes of one cell are coalesced to (first old, last new)
// while they wait.

#include <algorithm>
#include <exception>
#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/tree.h>

#include "failure_scope.h"
#include "state.h"

namespace fettle::property {
namespace {
constexpr std::size_t most_generations = 16;
constexpr std::size_t most_fresh_kept = 1024;  // room for instances made between barriers
}  // namespace

// --- Queueing
// --------------------------------------------------------------------------------------------------------

void Tree::State::queue_item(QueueItem item) {
    if (replaying) return;
    add_weight(weight_of_message);
    item.until = watchers.last_id();
    item.trigger = delivering;
    item.trigger_part = delivering_part;
    queue.push_back(std::move(item));
}

void Tree::State::queue_change(Handle handle, const Property& property, const Value& old_value,
                               const Value& new_value, const Cause& cause) {
    if (replaying) return;
    const Cell cell{handle.index, property.symbol};
    shadows.update(cell, new_value);
    writes.note_in_full(handle, property.symbol, cause);
    const auto [place, first] = queued_changes.try_emplace(cell, queue.size());
    if (!first) {
        Change& waiting = std::get<Change>(queue[place->second].what);
        if (waiting.instance == handle) {
            waiting.new_value = new_value;
            waiting.cause = cause;
            queue[place->second].until = watchers.last_id();
            return;
        }
        place->second = queue.size();
    }
    QueueItem item;
    item.what = Change{.instance = handle,
                       .property = &property,
                       .old_value = old_value,
                       .new_value = new_value,
                       .cause = cause};
    queue_item(std::move(item));
}

bool Tree::State::wants_farewell(Handle handle, const Class& of, bool only_own) const {
    return !watchers.of_deletion(handle.index, of, only_own).empty();
}

void Tree::State::queue_deletion(Handle handle, const Class& of, const Cause& cause) {
    // Who was never told of the instance is not told of its end; its own watchers knew it.
    const bool only_own = nodes[handle.index].fresh;
    const bool wanted = wants_farewell(handle, of, only_own);
    if (!wanted && deleted_event->listeners == 0 && !nodes[handle.index].watched) return;
    Existence gone{.instance = handle,
                   .instance_class = &of,
                   .path = tree.path(handle),
                   .cause = cause,
                   .last_values = {}};
    if (wanted)
        for (const Property* property : tree.properties(handle))
            gone.last_values.emplace_back(property, tree.peek(handle, *property));
    queue_farewell(std::move(gone), only_own);
}

void Tree::State::queue_farewell(Existence gone, bool only_own) {
    if (replaying) return;
    const Handle handle = gone.instance;
    const std::string path = gone.path;
    const Cause cause = gone.cause;
    std::vector<WatcherId> keep;
    const std::vector<WatcherId> watching =
        watchers.of_deletion(handle.index, *gone.instance_class, only_own);
    std::vector<WatcherId> listening;
    for (const Watcher* watcher :
         watchers.of_event(handle.index, *gone.instance_class, *deleted_event, watchers.last_id()))
        listening.push_back(watcher->id);
    if (!watching.empty()) {
        QueueItem item;
        item.kind = QueueItem::Kind::deleted;
        item.what = std::move(gone);
        item.recipients = watching;
        item.retire = true;
        queue_item(std::move(item));
        keep = watching;
    }
    if (!listening.empty()) {
        Occurrence told{.instance = handle,
                        .event = deleted_event,
                        .record = {&deleted_event->fields, {Value(path), Value(cause.text())}},
                        .step = step};
        QueueItem item;
        item.kind = QueueItem::Kind::event;
        item.what = std::move(told);
        item.recipients = listening;
        item.retire = true;
        queue_item(std::move(item));
        keep.insert(keep.end(), listening.begin(), listening.end());
    }
    watchers.retire(handle.index, keep);
}

bool Tree::listens(const Event& event) const {
    if (event.listeners == 0) return false;
    if (event.owner != nullptr) state_->require_own(*event.owner);
    return true;
}

bool Tree::listens(Handle instance, const Event& event) const {
    if (!alive(instance)) return false;
    state_->require_event(instance, event);
    return event.listeners != 0 &&
           !state_->watchers.of_event(instance, event, state_->watchers.last_id()).empty();
}

void Tree::emit(Handle instance, const Event& event, std::vector<Value> values) {
    State& s = *state_;
    s.require_event(instance, event);
    s.require_values(instance, event, values);
    s.require_changeable("tell an event");
    if (event.listeners == 0) return;
    QueueItem item;
    item.kind = QueueItem::Kind::event;
    item.what = Occurrence{.instance = instance,
                           .event = &event,
                           .record = {&event.fields, std::move(values)},
                           .step = s.step};
    s.queue_item(std::move(item));
}

// --- The barrier
// -----------------------------------------------------------------------------------------------------

void Tree::State::compare_shadows() {
    const bool everything = stepped;
    if (!stepped && !edited) return;
    stepped = edited = false;
    if (shadows.empty()) return;
    Motion motion;
    motion.cause =
        everything ? Cause{.writer = Writer::simulation, .where = {}, .step = step} : last_edit;
    shadows.compare(*this, true, everything ? step : 0, motion.changes);
    if (motion.changes.empty()) return;
    if (!everything)
        for (const CellChange& change : motion.changes)
            writes.note_in_full(change.instance, change.property->symbol, last_edit);
    if (!queued_changes.empty()) join_queued(motion);
    QueueItem item;
    item.kind = QueueItem::Kind::motion;
    item.what = std::move(motion);
    queue_item(std::move(item));
}

/// A cell that waits to be delivered already, because it was edited, is delivered once.
void Tree::State::join_queued(Motion& motion) {
    std::erase_if(motion.changes, [&](const CellChange& change) {
        const auto place = queued_changes.find({change.instance.index, change.property->symbol});
        if (place == queued_changes.end()) return false;
        QueueItem& item = queue[place->second];
        Change& waiting = std::get<Change>(item.what);
        if (waiting.instance != change.instance) return false;
        waiting.new_value = change.new_value;
        waiting.cause = motion.cause;
        item.until = watchers.last_id();
        return true;
    });
}

std::string Tree::State::describe(const Change& change) const {
    return nodes.find(change.instance) ? cell_path(change.instance, *change.property)
                                       : change.property->name;
}

std::string Tree::State::describe(const Existence& existence) const {
    return existence.path.empty() && nodes.find(existence.instance) ? tree.path(existence.instance)
                                                                    : existence.path;
}

std::string Tree::State::describe(const Occurrence& occurrence) const {
    const std::string where = nodes.find(occurrence.instance) ? tree.path(occurrence.instance)
                              : occurrence.record.values.empty()
                                  ? std::string("(deleted)")
                                  : tree.text(occurrence.record.values.front());
    return where + " " + occurrence.event->name;
}

/// In an account of what caused what; a change names its own cause.
std::string Tree::State::describe(const QueueItem& item, std::size_t part) const {
    const auto told = [this](const Change& change) {
        return describe(change) + " by " + change.cause.text();
    };
    if (const auto* change = std::get_if<Change>(&item.what)) return told(*change);
    if (const auto* motion = std::get_if<Motion>(&item.what)) {
        const CellChange& moved = motion->changes[part];
        return told({moved.instance, moved.property, {}, {}, motion->cause});
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
void Tree::State::call(const Watcher& watcher, const What& what) {
    if (ending) return;  // one of the handlers has destroyed the tree
    try {
        hand_over(watcher, what);
    } catch (...) {
        if (failure == nullptr) throw;
        report(
            *failure, [&] { return describe(what); }, watcher.label);
    }
}

/// To those who are interested now.
void Tree::State::deliver_change(const Change& change, WatcherId until) {
    if (nodes.find(change.instance) == nullptr || change.old_value == change.new_value) return;
    watchers.of_change(change, until, called);
    for (const Watcher* watcher : called)
        if (watcher->active) call(*watcher, change);
}

/// Whoever throws, the others still hear: the first error is thrown again by the barrier.
void Tree::State::deliver_motion(Motion& motion, WatcherId until, std::exception_ptr& error) {
    Change change;
    change.cause = motion.cause;
    for (std::size_t part = 0; part < motion.changes.size() && !ending; ++part) {
        CellChange& moved = motion.changes[part];
        change.instance = moved.instance;
        change.property = moved.property;
        change.old_value.swap(moved.old_value);
        change.new_value.swap(moved.new_value);
        delivering_part = part;
        try {
            deliver_change(change, until);
        } catch (...) {
            if (!error) error = std::current_exception();
        }
    }
    delivering_part = 0;
}

template void Tree::State::call(const Watcher&, const Occurrence&);  // of question.cpp

/// A handler may delete what the event names before the next one is called.
void Tree::State::deliver_event(const Occurrence& occurrence, WatcherId until) {
    const Event& event = *occurrence.event;
    if (event.begin != nullptr && untold.take(occurrence)) return;
    bool told = false;
    for (const Watcher* watcher : watchers.of_event(occurrence.instance, event, until)) {
        if (!watcher->active) continue;
        if (nodes.find(occurrence.instance) == nullptr) return;
        const auto deleted = [this](const Value& value) { return names_deleted(tree, value); };
        if (event.begin == nullptr && std::ranges::any_of(occurrence.record.values, deleted)) {
            if (event.end != nullptr && !told) untold.note(tree, occurrence);
            return;
        }
        told = true;
        call(*watcher, occurrence);
    }
}

/// To the recipients it was queued for.
template <class What>
void Tree::State::deliver_to(const QueueItem& item, const What& what) {
    for (const WatcherId id : item.recipients) {
        const Watcher* watcher = watchers.find(id);
        if (watcher == nullptr) continue;
        if (watcher->active || item.retire) call(*watcher, what);
        if (ending) return;
        if (item.retire && !watcher->active) watchers.stop(id);
    }
}

void Tree::State::deliver(QueueItem& item) {
    if (ending) return;
    const auto to_all = [this](const Watchers::List& list, const auto& what) {
        for (const Watcher* watcher : list)
            if (watcher->active) call(*watcher, what);
    };
    switch (item.kind) {
        case QueueItem::Kind::change:
            return deliver_change(std::get<Change>(item.what), item.until);
        case QueueItem::Kind::motion:
            return;  // deliver_motion
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

void Tree::State::barrier_overrun(const std::vector<std::vector<QueueItem>>& generations) {
    std::string chain;
    const QueueItem* item = queue.empty() ? nullptr : &queue.front();
    std::size_t part = 0;
    for (std::size_t g = generations.size(); item != nullptr; --g) {
        chain += "\n  " + describe(*item, part);
        part = item->trigger_part;
        item = g == 0 || item->trigger < 0
                   ? nullptr
                   : &generations[g - 1][static_cast<std::size_t>(item->trigger)];
    }
    queue.clear();
    queued_changes.clear();
    const Error error(ErrorKind::no_barrier_end,
                      "handlers keep making changes: the barrier stopped after " +
                          std::to_string(most_generations) +
                          " generations; each of these caused the one above:" + chain);
    if (!error_sink) throw error;
    tell_error({.path = "barrier",
                .where = {},
                .message = exception_text(error),
                .exception = std::make_exception_ptr(error)});
}

void Tree::at_barrier(std::function<void()> action) {
    require_changeable("order anything for the next barrier");
    if (!action) throw Error(ErrorKind::wrong_type, "at_barrier: a function is needed");
    state_->at_barrier.push_back(std::move(action));
}

void Tree::State::run_actions(std::exception_ptr& first_error) {
    // What they post meanwhile waits for the next barrier.
    const std::vector<std::function<void()>> actions = std::exchange(at_barrier, {});
    for (const auto& action : actions) {
        if (ending) return;
        try {
            action();
        } catch (...) {
            report(first_error, [] { return std::string("barrier"); });
        }
    }
}

void Tree::barrier(bool between_steps) {
    State& s = *state_;
    if (s.in_barrier)
        throw Error(ErrorKind::bad_structure, "a handler cannot start a barrier: it runs in one");
    const State::Use use(s);
    s.require_changeable("start a barrier");
    std::exception_ptr first_error;
    const FailureScope failure_scope(s.failure, first_error);
    s.deliver_all(first_error);
    if (between_steps && !s.ending && !s.at_barrier.empty()) {
        s.run_actions(first_error);
        if (!s.ending) s.deliver_all(first_error);
    }
    if (first_error) std::rethrow_exception(first_error);
    use.finish();
}

void Tree::State::deliver_all(std::exception_ptr& first_error) {
    tell_plain_writes();
    for (const std::uint32_t index : fresh) nodes[index].fresh = false;
    fresh.clear();
    if (fresh.capacity() > most_fresh_kept) fresh.shrink_to_fit();
    formulas.settle_all(stepped);
    formulas.tell_problems();
    if (ending) return;
    compare_shadows();
    if (queue.empty()) return;

    struct Running {
        State& state;
        Watchers::HandlersRun handlers;
        explicit Running(State& st) : state(st), handlers(st.watchers) { state.in_barrier = true; }
        ~Running() {
            state.in_barrier = false;
            state.delivering = -1;
            state.delivering_part = 0;
        }
    } running(*this);
    std::vector<std::vector<QueueItem>> generations;
    while (!queue.empty()) {
        if (generations.size() == most_generations) return barrier_overrun(generations);
        std::vector<QueueItem>& batch = generations.emplace_back(std::move(queue));
        queue.clear();
        queued_changes.clear();
        for (std::size_t i = 0; i < batch.size(); ++i) {
            QueueItem& item = batch[i];
            delivering = static_cast<std::ptrdiff_t>(i);
            if (auto* motion = std::get_if<Motion>(&item.what)) {
                deliver_motion(*motion, item.until, first_error);
                continue;
            }
            try {
                deliver(item);
            } catch (...) {
                if (!first_error) first_error = std::current_exception();
            }
        }
        delivering = -1;
        if (ending) return;
        formulas.settle_all(false);
        formulas.tell_problems();
        if (ending) return;
        compare_shadows();
    }
}

void Tree::State::report(std::exception_ptr& first, const std::function<std::string()>& path,
                         const std::string& where) const {
    try {
        if (!error_sink || ending) throw;
        tell_error({.path = path(),
                    .where = where,
                    .message = exception_text(),
                    .exception = std::current_exception()});
    } catch (...) {
        if (!first) first = std::current_exception();
    }
}

void Tree::State::tell_error(const HandlerError& error) const {
    // It may put another in its place.
    if (const auto sink = error_sink) sink(error);
}

void Tree::on_handler_error(std::function<void(const HandlerError&)> sink) {
    state_->error_sink = std::move(sink);
}

}  // namespace fettle::property
