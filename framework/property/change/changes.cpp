#include "changes.h"

#include <utility>

#include <classes/coerce.h>
#include <values/weight.h>

namespace fettle::property {
namespace {

constexpr std::size_t max_fresh_kept = 1024;  // enough for the instances made between two barriers

/// Whether the simulation writes it. A value that derives from others changes with those.
bool moves_by_itself(const Property& property) {
    return property.simulated && property.derives_from.empty();
}

}  // namespace

Value PlainWrite::value() const {
    const bool narrow = property->shortcut.narrow;
    if (property->type == Type::number) return Value(narrow ? narrowed(x) : x);
    return Value(narrow ? narrowed(Vec2(x, y)) : Vec2(x, y));
}

void Observer::wrote_plain(const PlainWrites& writes) {
    for (const PlainWrite& write : writes.list)
        if (write.instance) wrote(write.instance, *write.property, write.value());
}

void Changes::report_unreported() {
    const PlainWrites reported = writes.unreported();
    // The list is emptied first, because an observer may call functions that report writes again.
    // Observers write nothing.
    writes.mark_reported(author.writer, author.step, replaying);
    if (!replaying && !observers.all.empty())
        observers.notify([&](Observer& observer) { observer.wrote_plain(reported); });
}

/// Remembers the author of an edit, in case the barrier finds derived values that it changed.
/// The author's place in a script is looked up only while a watched value depends on other cells,
/// because looking it up takes too long for a callback of a game.
void Changes::note_edit() {
    edited = true;
    ++invalidations;
    if (shadows.empty()) return;
    last_edit.writer = author.writer;
    last_edit.step = author.step;
    last_edit.where.clear();
    if (shadows.any_derived() || writes.closed_for(WritesLog::Reason::recorded))
        last_edit.where = author.place();
}

void Changes::written(Handle handle, const Node& node, const Property& property,
                      const Value& old_value) {
    note_edit();
    report_plain_writes();
    if (replaying) return;
    writes.note(handle, property, author.writer, author.step);
    if (recording() || writes.closed_for(WritesLog::Reason::located))
        writes.note_in_full(
            handle, property.symbol, author.cause(),
            moves_by_itself(property) ? instances.read(handle.index, node, property) : Value());
    if (!node.watched && property.shortcut.interest == 0) return;
    const Value now = instances.read(handle.index, node, property);
    if (now == old_value) return;
    queue_change(handle, property, old_value, now, author.cause());
}

void Changes::queue_item(QueueItem item) {
    if (replaying) return;
    weight.add(weight_of_message);
    item.until = watchers.last_id();
    item.trigger = queue.item;
    item.trigger_part = queue.part;
    queue.items.push_back(std::move(item));
}

void Changes::forget_messages(std::size_t count) {
    weight.add(-weight_of_message * static_cast<std::int64_t>(count));
}

std::vector<QueueItem> Changes::take_items() {
    forget_messages(queue.items.size());
    queue.changes.clear();
    return std::exchange(queue.items, {});
}

void Changes::queue_change(Handle handle, const Property& property, const Value& old_value,
                           const Value& new_value, const Cause& cause) {
    if (replaying) return;
    const Cell cell{handle.index, property.symbol};
    shadows.update(cell, new_value);
    writes.note_in_full(handle, property.symbol, cause,
                        moves_by_itself(property) ? new_value : Value());
    const auto [place, first] = queue.changes.try_emplace(cell, queue.items.size());
    if (!first) {
        QueueItem& item = queue.items[place->second];
        if (std::get<Change>(item.what).instance == handle && join(item, new_value, cause)) return;
        place->second = queue.items.size();
    }
    queue_item({.what = Change{.instance = handle,
                               .property = &property,
                               .old_value = old_value,
                               .new_value = new_value,
                               .cause = cause}});
}

void Changes::queue_creation(Handle handle, const Class& of, WatcherId recipient) {
    queue_item({.kind = QueueItem::Kind::created,
                .what = Existence{.instance = handle,
                                  .instance_class = &of,
                                  .path = {},
                                  .cause = author.cause(),
                                  .last_values = {}},
                .recipients = recipient == 0 ? std::vector<WatcherId>{} : std::vector{recipient}});
}

bool Changes::needs_deletion_notice(Handle handle, const Class& of, bool only_own) const {
    return !watchers.of_deletion(handle, of, only_own).empty();
}

void Changes::queue_deletion(Handle handle, const Class& of, const Cause& cause) {
    // A watcher that did not receive the creation of the instance does not receive its deletion.
    // Only the watchers of the instance itself have received it.
    const bool only_own = nodes[handle.index].fresh;
    const bool wanted = needs_deletion_notice(handle, of, only_own);
    if (!wanted && deleted_event->listeners == 0 && !nodes[handle.index].watched) return;
    Existence gone = deletion_notice_of(handle, of, wanted);
    gone.cause = cause;
    queue_deletion_notice(std::move(gone), only_own);
}

Existence Changes::deletion_notice_of(Handle handle, const Class& of, bool with_values) const {
    Existence gone{.instance = handle,
                   .instance_class = &of,
                   .path = tree.path(handle),
                   .cause = {},
                   .last_values = {}};
    if (with_values)
        for (const Property* property : tree.properties(handle))
            gone.last_values.emplace_back(property, tree.peek(handle, *property));
    return gone;
}

void Changes::forget_fresh(std::span<const QueueItem> batch) {
    for (const std::uint32_t index : queue.fresh) nodes[index].fresh = false;
    queue.fresh.clear();
    if (queue.fresh.capacity() > max_fresh_kept) queue.fresh.shrink_to_fit();
    for (const QueueItem& item : batch) {
        if (item.kind != QueueItem::Kind::created || !item.recipients.empty()) continue;
        const Handle made = std::get<Existence>(item.what).instance;
        if (nodes.find(made) == nullptr) continue;
        nodes[made.index].fresh = true;
        queue.fresh.push_back(made.index);
    }
}

void Changes::queue_deletion_notice(Existence gone, bool only_own) {
    const Handle handle = gone.instance;
    if (replaying) {
        // Watchers of an instance that was made in the same restore end with it and are not called.
        // All other watchers are called when the restore is over.
        if (only_own) watchers.retire(handle, {});
        return;
    }
    const std::string path = gone.path;
    const Cause cause = gone.cause;
    std::vector<WatcherId> keep;
    const std::vector<WatcherId> watching =
        watchers.of_deletion(handle, *gone.instance_class, only_own);
    std::vector<WatcherId> listening;
    for (const Watcher* watcher :
         watchers.of_event(handle.index, *gone.instance_class, *deleted_event, watchers.last_id()))
        if (watcher->index == 0 || watcher->generation == handle.generation)
            listening.push_back(watcher->id);
    if (!watching.empty()) {
        queue_item({.kind = QueueItem::Kind::deleted,
                    .what = std::move(gone),
                    .recipients = watching,
                    .retire = true});
        keep = watching;
    }
    if (!listening.empty()) {
        Occurrence occurrence{
            .instance = handle,
            .event = deleted_event,
            .record = {&deleted_event->fields, {Value(path), Value(cause.text())}},
            .step = author.step};
        queue_item({.kind = QueueItem::Kind::event,
                    .what = std::move(occurrence),
                    .recipients = listening,
                    .retire = true});
        keep.insert(keep.end(), listening.begin(), listening.end());
    }
    watchers.retire(handle, keep);
}

void Changes::compare_shadows() {
    const bool everything = stepped;
    if (!stepped && !edited) return;
    stepped = edited = false;
    if (shadows.empty()) return;
    Motion motion;
    motion.cause = everything
                       ? Cause{.writer = Writer::simulation, .where = {}, .step = author.step}
                       : last_edit;
    motion.changes = shadows.compare(instances, everything ? author.step : 0);
    if (motion.changes.empty()) return;
    if (!everything)
        for (const CellChange& change : motion.changes)
            writes.note_in_full(change.instance, change.property->symbol, last_edit);
    if (!queue.changes.empty()) join_queued(motion);
    queue_item({.kind = QueueItem::Kind::motion, .what = std::move(motion)});
}

bool Changes::join(QueueItem& item, const Value& new_value, const Cause& cause) {
    Change& waiting = std::get<Change>(item.what);
    if (item.until != watchers.last_id()) {
        Watchers::List watching;  // in order of registration
        watchers.of_change(waiting, watchers.last_id(), watching);
        if (!watching.empty() && watching.back()->id > item.until) return false;
    }
    waiting.new_value = new_value;
    waiting.cause = cause;
    item.until = watchers.last_id();
    return true;
}

/// Merges a change into the queued change of the same cell, so that the cell is reported once.
void Changes::join_queued(Motion& motion) {
    std::erase_if(motion.changes, [&](const CellChange& change) {
        const auto place = queue.changes.find({change.instance.index, change.property->symbol});
        if (place == queue.changes.end()) return false;
        QueueItem& item = queue.items[place->second];
        return std::get<Change>(item.what).instance == change.instance &&
               join(item, change.new_value, motion.cause);
    });
}

}  // namespace fettle::property
