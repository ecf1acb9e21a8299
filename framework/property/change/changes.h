#pragma once
// What changes in a tree, and who is told of it: observers at once, watchers at the next barrier.

#include <cstdint>
#include <exception>
#include <string>

#include <instances/instances.h>
#include <writes/authorship.h>
#include <writes/writes_log.h>

#include "errors.h"
#include "growth.h"
#include "observers.h"
#include "queue.h"
#include "shadows.h"
#include "watchers.h"

namespace fettle::property {

struct Changes {
    Changes(Instances& of, Lifetime& life)
        : instances(of),
          nodes(of.nodes),
          tree(of.tree),
          lifetime(life),
          errors{life},
          growth{life, errors},
          watchers(*this),
          shadows(writes),
          observers{life} {}

    Instances& instances;
    Nodes& nodes;
    Tree& tree;
    Lifetime& lifetime;
    HandlerErrors errors;
    Growth growth;
    Authorship author;
    WritesLog writes;
    Watchers watchers;
    Shadows shadows;
    Observers observers;
    Queue queue;
    const Event* deleted_event = nullptr;  // of Object

    bool replaying = false;  // what is done now was done before: nobody is told, nothing settles
    bool stepped = false;    // since the shadows were last compared
    bool edited = false;
    Cause last_edit;  // kept while anything is shadowed; its place, while what is derived
    std::uint64_t invalidations = 1;  // what `epoch` counts beside writes in the log

    /// Another after whatever may have changed a value that nobody announces. What the shortest way
    /// takes back it had before: nobody can have looked in between.
    std::uint64_t epoch() const { return invalidations + writes.ever(); }
    void note_edit();
    /// Whether what is written now is an edit for the history.
    bool recording() const { return !replaying && writes.closed_for(WritesLog::Reason::recorded); }
    /// A cell was written by anything but the typed ways.
    void written(Handle handle, const Node& node, const Property& property, const Value& old_value);

    /// Calls `what(observer)` for each observer.
    template <class What>
    void tell(What what) {
        tell_plain_writes();
        if (!replaying && !observers.all.empty()) observers.tell(what);
    }
    /// What the typed ways have written is told before anything else.
    void tell_plain_writes() {
        if (writes.any_untold()) tell_untold();
    }
    void tell_untold();

    // changes.cpp: what is queued
    void queue_item(QueueItem item);
    void queue_change(Handle handle, const Property& property, const Value& old_value,
                      const Value& new_value, const Cause& cause);
    /// `recipient`: the only watcher to be told; 0: all.
    void queue_creation(Handle handle, const Class& of, WatcherId recipient = 0);
    void queue_deletion(Handle handle, const Class& of, const Cause& cause);
    /// The same for one that is gone already. `only_own`: only its own watchers knew it.
    void queue_farewell(Existence gone, bool only_own);
    bool wants_farewell(Handle handle, const Class& of, bool only_own) const;
    /// What is told of its end. The cause is not known yet.
    Existence farewell_of(Handle handle, const Class& of, bool with_values) const;
    /// From now on instances are old: who watches classes knows of them.
    void forget_fresh();
    void compare_shadows();

    // shadowing.cpp: which cells are compared
    void watcher_added(const Watcher& watcher);
    void watcher_removed(const Watcher& watcher);
    void refresh_shadows(std::uint32_t index) {
        shadows.refresh(tree, watchers, nodes.handle(index));
    }
    void refresh_shadows_below(std::uint32_t top);

    // delivery.cpp
    /// Calls the handlers of one item. Their errors are kept where `errors` says.
    void deliver(QueueItem& item, std::exception_ptr& first_error);
    template <class What>
    void call(const Watcher& watcher, const What& what);
    /// In an account of what caused what.
    std::string describe(const QueueItem& item, std::size_t part) const;

  private:
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
