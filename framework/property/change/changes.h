#pragma once
// Changes of a tree and their delivery: to observers at once, to watchers at the next barrier.

#include <cstdint>
#include <exception>
#include <span>
#include <string>

#include <instances/instances.h>
#include <writes/authorship.h>
#include <writes/writes_log.h>

#include "errors.h"
#include "observers.h"
#include "queue.h"
#include "shadows.h"
#include "tree_weight.h"
#include "watchers.h"

namespace fettle::property {

struct Changes {
    Changes(Instances& of, Lifetime& life)
        : instances(of),
          nodes(of.nodes),
          tree(of.tree),
          lifetime(life),
          errors{life},
          weight{tree, life, errors},
          watchers(*this),
          shadows(writes),
          observers{life} {}

    Instances& instances;
    Nodes& nodes;
    Tree& tree;
    Lifetime& lifetime;
    HandlerErrors errors;
    TreeWeight weight;
    Authorship author;
    WritesLog writes;
    Watchers watchers;
    Shadows shadows;
    Observers observers;
    Queue queue;
    const Event* deleted_event = nullptr;  // the event `deleted` of Object

    bool replaying = false;  // set while recorded writes are repeated: no callbacks, no settling
    bool stepped = false;    // since the shadows were last compared
    bool edited = false;
    Cause last_edit;  // kept while there are shadows; its place only while some are derived
    std::uint64_t invalidations = 1;  // part of `epoch` that does not come from the log of writes

    /// A number that changes whenever a value may have changed without an announcement. A write
    /// that the fastest path undoes does not count: no code can have run in between.
    std::uint64_t epoch() const { return invalidations + writes.ever(); }
    void note_edit();
    /// Whether a write now is an edit for the history.
    bool recording() const { return !replaying && writes.closed_for(WritesLog::Reason::recorded); }
    /// Called when a cell was written by anything but the typed functions.
    void written(Handle handle, const Node& node, const Property& property, const Value& old_value);

    /// Calls `what(observer)` for each observer.
    template <class What>
    void notify(What what) {
        report_plain_writes();
        if (!replaying && !observers.all.empty()) observers.notify(what);
    }
    /// Reports the writes of the typed functions before anything else is reported.
    void report_plain_writes() {
        if (writes.any_unreported()) report_unreported();
    }
    void report_unreported();

    // changes.cpp: the queue
    void queue_item(QueueItem item);
    /// Empties the queue and returns its items.
    std::vector<QueueItem> take_items();
    /// To be called when items leave the queue: they take no memory any more.
    void forget_messages(std::size_t count);
    void queue_change(Handle handle, const Property& property, const Value& old_value,
                      const Value& new_value, const Cause& cause);
    /// `recipient`: the only watcher to be called; 0: all watchers.
    void queue_creation(Handle handle, const Class& of, WatcherId recipient = 0);
    void queue_deletion(Handle handle, const Class& of, const Cause& cause);
    /// The same for an instance that is already deleted. `only_own`: only the watchers of the
    /// instance itself knew it.
    void queue_deletion_notice(Existence gone, bool only_own);
    bool needs_deletion_notice(Handle handle, const Class& of, bool only_own) const;
    /// The record that watchers of the deletion receive. Its cause is not known yet.
    Existence deletion_notice_of(Handle handle, const Class& of, bool with_values) const;
    /// Marks all instances as old: the watchers of their classes have been notified of them, but
    /// for those whose creation `batch` contains.
    void forget_fresh(std::span<const QueueItem> batch = {});
    void compare_shadows();

    // shadowing.cpp: which cells are compared
    void watcher_added(const Watcher& watcher);
    void watcher_removed(const Watcher& watcher);
    /// While a restore is under way, cells have no shadows: an instance may have no row yet, so its
    /// module cannot be asked for values. All shadows are made again at the end.
    void refresh_shadows(std::uint32_t index) {
        if (!replaying) shadows.refresh(tree, watchers, nodes.handle(index));
    }
    void refresh_shadows_below(std::uint32_t top);

    // delivery.cpp
    /// Calls the handlers of one item. `errors` decides where their exceptions go.
    void deliver(QueueItem& item, std::exception_ptr& first_error);
    template <class What>
    void call(const Watcher& watcher, const What& what);
    /// Describes one item for a report of causes and effects.
    std::string describe(const QueueItem& item, std::size_t part) const;

  private:
    /// Adds to a queued change, unless a watcher that has begun since then would get an older value
    /// than it has seen. False in that case: the rest is a change of its own.
    bool join(QueueItem& item, const Value& new_value, const Cause& cause);
    void join_queued(Motion& motion);
    void count_interest(const Watcher& watcher, int sign);
    std::uint32_t top_of(const Pattern& pattern) const;
    template <class Visit>
    void each_cell_wanted(const Watcher& watcher, Visit visit);
    void deliver_one(QueueItem& item);
    void deliver_change(const Change& change, WatcherId until);
    void deliver_motion(Motion& motion, WatcherId until, std::exception_ptr& error);
    void deliver_event(const Occurrence& occurrence, WatcherId until);
    template <class What>
    void deliver_to(const QueueItem& item, const What& what);
    std::string describe(const Change& change) const;
    std::string describe(const Existence& existence) const;
    std::string describe(const Occurrence& occurrence) const;
};

}  // namespace fettle::property
