#pragma once
// Watchers: they are found by the cell, instance or class that they watch, and are called in the
// order of registration. A handler may add and remove watchers while it runs.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/path.h>

#include <instances/cell.h>

namespace fettle::property {

using WatcherId = std::uint64_t;

enum class WatchKind : std::uint8_t {
    cell,
    instance,
    of_class,
    pattern,
    created,
    deleted,
    event,
    class_event
};

struct Watcher {
    WatcherId id = 0;
    WatchKind kind = WatchKind::cell;
    std::uint32_t index = 0;       // cell, instance, deleted, event
    std::uint32_t generation = 0;  // of that instance
    Symbol property;               // cell; of_class, pattern (empty: several properties)
    const Class* of = nullptr;     // of_class, created, deleted, class_event
    const Event* event = nullptr;  // event, class_event
    std::unique_ptr<Pattern> pattern;
    ChangeHandler on_change;
    ExistenceHandler on_existence;
    EventHandler on_event;
    std::string label;
    bool active = true;

    bool broad() const { return kind == WatchKind::of_class || kind == WatchKind::pattern; }
};

/// Watchers in order of registration. A removed watcher leaves a hole. The holes are closed when
/// they are the majority, so a removal costs one search, however many watchers there are.
class WatcherList {
  public:
    void add(Watcher& watcher) { entries_.push_back({watcher.id, &watcher}); }
    void take_out(const Watcher& watcher);
    bool empty() const { return entries_.size() == holes_; }
    void append_to(std::vector<Watcher*>& out) const;
    /// Whether `test` is true for a watcher. The search ends with the first one.
    template <class Test>
    bool any(Test test) const {
        return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
            return entry.watcher != nullptr && test(entry.watcher);
        });
    }

  private:
    struct Entry {
        WatcherId id = 0;
        Watcher* watcher = nullptr;  // null: a hole
    };
    std::vector<Entry> entries_;
    std::size_t holes_ = 0;
};

struct Changes;

class Watchers {
  public:
    using List = std::vector<Watcher*>;  // in order of registration

    explicit Watchers(Changes& changes)
        : changes_(changes), self_(std::make_shared<Watchers*>(this)) {}
    /// The destructor invalidates all connections first, because handlers may own connections.
    ~Watchers() { self_.reset(); }
    Watchers(const Watchers&) = delete;

    Connection add(Watcher watcher);
    void stop(WatcherId id);
    bool active(WatcherId id) const { return all_.contains(id); }
    /// nullptr if it was stopped.
    Watcher* find(WatcherId id) const;
    std::size_t size() const { return all_.size(); }
    WatcherId last_id() const { return last_id_; }

    // The watchers of a change or event in order of registration; only those registered up to
    // `until`.
    void of_change(const Change& change, WatcherId until, List& out) const;
    List of_event(Handle instance, const Event& event, WatcherId until) const;
    List of_event(std::uint32_t index, const Class& instance_class, const Event& event,
                  WatcherId until) const;
    List of_creation(const Class& instance_class, WatcherId until) const;
    std::vector<WatcherId> of_deletion(Handle instance, const Class& instance_class,
                                       bool only_own) const;

    /// True if a pattern or class watcher matches this property of this instance.
    bool broadly_watched(Handle instance, const Property& property) const;
    /// True if this watcher, which must be broad, matches the property.
    bool matches(const Watcher& watcher, Handle instance, const Property& property) const;
    /// A cheap test: false if the watcher cannot match the property of any instance.
    static bool may_match(const Watcher& watcher, const Property& property);
    /// True if this cell or its instance has a watcher.
    bool directly_watched(Cell cell) const {
        return cells_.contains(cell) || instances_.contains(cell.index);
    }
    bool any_on(std::uint32_t index) const { return on_index_.contains(index); }
    bool any_broad() const { return broad_ != 0; }
    bool any_created() const { return !created_.empty(); }
    bool any_deleted() const { return !deleted_.empty(); }
    /// Slots of instances that have watchers (other than broad ones).
    std::vector<std::uint32_t> watched_slots() const;
    /// The number of broad watchers that can match a property with that name. It is cached in
    /// `Property::Shortcut::interest`.
    std::uint32_t interest(const Property& property) const;

    /// Ends the watchers of a deleted instance: they are removed from the lists of its slot,
    /// because the slot may be reused. Watchers in `keep` can still be called until they are
    /// stopped.
    void retire(Handle gone, const std::vector<WatcherId>& keep);
    /// As `retire`, for the watchers of earlier instances in the slot of `lives`. `{index, 0}`: for
    /// all watchers of that slot.
    void retire_others(Handle lives);

    /// While handlers run, a stopped watcher is not freed, because it may be the one that runs. The
    /// calls may be nested: a handler may ask a question.
    class HandlersRun {
      public:
        explicit HandlersRun(Watchers& watchers) : watchers_(watchers) {
            ++watchers_.handlers_run_;
        }
        ~HandlersRun() {
            if (--watchers_.handlers_run_ == 0) watchers_.stopped_.clear();
        }
        HandlersRun(const HandlersRun&) = delete;

      private:
        Watchers& watchers_;
    };

  private:
    template <class Visit>
    bool any_broad_on(const Property& property, Visit visit) const;
    template <class Test>
    void retire_if(std::uint32_t index, Test test, const std::vector<WatcherId>& keep);
    WatcherList* list_of(const Watcher& watcher);
    void unlist(Watcher& watcher);

    Changes& changes_;
    std::shared_ptr<Watchers*> self_;
    WatcherId last_id_ = 0;
    std::unordered_map<WatcherId, std::unique_ptr<Watcher>> all_;
    std::vector<std::unique_ptr<Watcher>> stopped_;  // freed when no handler runs
    int handlers_run_ = 0;                           // number of nested calls of handlers
    std::unordered_map<Cell, WatcherList, CellHash> cells_;
    std::unordered_map<std::uint32_t, WatcherList> instances_;
    std::unordered_map<std::uint32_t, WatcherList> deleted_on_;
    std::unordered_map<Cell, WatcherList, CellHash> events_;
    std::unordered_map<std::uint32_t, WatcherList> on_index_;  // all kinds that watch one slot
    // By the property they watch; those that watch several are under the empty symbol.
    std::unordered_map<Symbol, WatcherList> broad_lists_;
    std::size_t broad_ = 0;
    WatcherList created_, deleted_, class_events_;
};

}  // namespace fettle::property
