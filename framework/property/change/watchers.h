#pragma once
// Watchers: who wants to hear of what. They are found by what they watch, called in the order they
// were registered, and survive whatever a handler does to them meanwhile.

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
    Symbol property;               // cell; of_class, pattern (empty: more than one)
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

/// Watchers in order of registration. One that is taken out leaves a hole, and the holes are closed
/// when they are the greater part: however many there are, taking out costs a search among them.
class WatcherList {
  public:
    void add(Watcher& watcher) { entries_.push_back({watcher.id, &watcher}); }
    void take_out(const Watcher& watcher);
    bool empty() const { return entries_.size() == holes_; }
    void append_to(std::vector<Watcher*>& out) const;
    /// Whether `test` is true of one; it is not asked further then.
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
    /// Handlers may hold connections: these find no watchers any more from here on.
    ~Watchers() { self_.reset(); }
    Watchers(const Watchers&) = delete;

    Connection add(Watcher watcher);
    void stop(WatcherId id);
    bool active(WatcherId id) const { return all_.contains(id); }
    /// nullptr once it was stopped.
    Watcher* find(WatcherId id) const;
    std::size_t size() const { return all_.size(); }
    WatcherId last_id() const { return last_id_; }

    // Those who want to hear, in order of registration; only those registered up to `until`.
    void of_change(const Change& change, WatcherId until, List& out) const;
    List of_event(Handle instance, const Event& event, WatcherId until) const;
    List of_event(std::uint32_t index, const Class& instance_class, const Event& event,
                  WatcherId until) const;
    List of_creation(const Class& instance_class, WatcherId until) const;
    std::vector<WatcherId> of_deletion(std::uint32_t index, const Class& instance_class,
                                       bool only_own) const;

    /// Whether any pattern or class watcher wants this property of this instance.
    bool broadly_watched(Handle instance, const Property& property) const;
    /// Whether this one, which must be broad, wants it.
    bool wants(const Watcher& watcher, Handle instance, const Property& property) const;
    /// Whether it may want the property of some instance: cheap.
    static bool may_want(const Watcher& watcher, const Property& property);
    /// Whether a watcher of this very cell or of its instance exists.
    bool directly_watched(Cell cell) const {
        return cells_.contains(cell) || instances_.contains(cell.index);
    }
    bool any_on(std::uint32_t index) const { return on_index_.contains(index); }
    bool any_broad() const { return broad_ != 0; }
    bool any_created() const { return !created_.empty(); }
    bool any_deleted() const { return !deleted_.empty(); }
    /// Slots of instances with watchers of their own.
    std::vector<std::uint32_t> watched_slots() const;
    /// How many broad watchers may want a property of that name: kept in `Property::interest`.
    std::uint32_t interest(const Property& property) const;

    /// The instance is gone: its watchers are no longer found by it (its slot may be somebody
    /// else's soon). Those in `keep` stay callable until they are stopped.
    void retire(std::uint32_t index, const std::vector<WatcherId>& keep);

    /// While handlers run, a watcher that is stopped lives on until they are done: it may be the
    /// one that runs. Handlers may be asked questions while others run.
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
    WatcherList* list_of(const Watcher& watcher);
    void unlist(Watcher& watcher);

    Changes& changes_;
    std::shared_ptr<Watchers*> self_;
    WatcherId last_id_ = 0;
    std::unordered_map<WatcherId, std::unique_ptr<Watcher>> all_;
    std::vector<std::unique_ptr<Watcher>> stopped_;  // while handlers run
    int handlers_run_ = 0;                           // calls of handlers, one in the other
    std::unordered_map<Cell, WatcherList, CellHash> cells_;
    std::unordered_map<std::uint32_t, WatcherList> instances_;
    std::unordered_map<std::uint32_t, WatcherList> deleted_on_;
    std::unordered_map<Cell, WatcherList, CellHash> events_;
    std::unordered_map<std::uint32_t, WatcherList> on_index_;  // of any of these kinds
    // By the property they are about; those about several under the empty symbol.
    std::unordered_map<Symbol, WatcherList> broad_lists_;
    std::size_t broad_ = 0;
    WatcherList created_, deleted_, class_events_;
};

}  // namespace fettle::property
