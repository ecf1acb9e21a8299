#pragma once
// What a tree holds, for the files that implement it.

#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <fettle/property/acceptance.h>
#include <fettle/property/observer.h>
#include <fettle/property/question.h>
#include <fettle/property/tree.h>

#include <classes/class_registry.h>
#include <values/weight.h>

#include "formulas.h"
#include "history.h"
#include "nodes.h"
#include "shadows.h"
#include "stored_columns.h"
#include "untold.h"
#include "watchers.h"
#include "writes_log.h"

namespace fettle::property {

class WriteLog;

/// What the simulation did to watched cells, found at one barrier.
struct Motion {
    std::vector<CellChange> changes;
    Cause cause;
};

/// Something to deliver at a barrier.
struct QueueItem {
    enum class Kind : std::uint8_t { change, motion, initial, created, deleted, event };
    Kind kind = Kind::change;
    std::variant<Change, Motion, Existence, Occurrence> what;
    WatcherId until = 0;                // watchers registered later have seen the result already
    std::vector<WatcherId> recipients;  // fixed when queued (deletions, initial values)
    bool retire = false;                // the recipients' instance is gone: they end with this
    std::ptrdiff_t trigger = -1;        // item of the generation before whose handler caused this
    std::size_t trigger_part = 0;       // of a motion: which of its changes
};

struct Tombstone {
    Handle handle;
    const Class* of = nullptr;
    std::string name;
    std::string path;
    Cause cause;
};

struct Tree::State {
    explicit State(Tree& owner) : tree(owner), watchers(owner), formulas(owner), history(owner) {}

    static std::uint64_t next_number();

    Tree& tree;
    const std::uint64_t number = next_number();  // no other tree of the process has it
    ClassRegistry classes;
    Nodes nodes;
    std::vector<std::unique_ptr<StoredColumns>>
        stored;  // by class id; null where a class stores nothing
    std::unordered_map<std::uint32_t, std::map<std::string, std::pair<const Property*, Value>>>
        ad_hoc;
    std::unordered_map<Symbol, std::unique_ptr<Property>>
        ad_hoc_properties;  // one descriptor a name
    static constexpr std::size_t most_tombstones = 8192;
    std::deque<Tombstone> tombstones;  // the latest deletions

    Watchers watchers;
    Shadows shadows;
    Formulas formulas;
    History history;
    WritesLog writes;
    std::vector<std::uint32_t> fresh;  // slots of instances made since the last barrier
    std::vector<QueueItem> queue;
    std::unordered_map<Cell, std::size_t, CellHash>
        queued_changes;  // cell -> its place in the queue
    std::ptrdiff_t delivering = -1;
    std::size_t delivering_part = 0;
    Watchers::List called;  // by the delivery at hand
    UntoldBeginnings untold;
    bool in_barrier = false;
    bool stepped = false;  // since the shadows were last compared
    bool edited = false;
    std::uint64_t upheavals = 1;  // what `epoch` counts beside writes in the log
    std::uint64_t structure = 0;  // comings, goings and moves
    bool ending = false;          // the tree itself is being destroyed
    std::shared_ptr<const Tree*> life = std::make_shared<const Tree*>(&tree);
    int uses = 0;                   // calls that call handlers or methods
    std::unique_ptr<State> orphan;  // itself, when one of those destroyed the tree
    Cause last_edit;  // kept while anything is shadowed; its place, while what is derived
    std::function<void(const HandlerError&)> error_sink;
    void tell_error(const HandlerError& error) const;
    /// In a handler of exceptions: the one at hand goes to the sink. Without a sink, and where that
    /// throws, it is kept in `first` unless there is one: the others are told all the same.
    void report(std::exception_ptr& first, const std::function<std::string()>& path,
                const std::string& where = {}) const;
    std::exception_ptr* failure = nullptr;  // where what handlers throw goes without a sink
    /// Where in a program the writes come from, as the innermost CauseScope tells it.
    std::string place() const;
    std::vector<std::function<void()>> at_barrier;  // when it is between steps
    std::vector<SnapshotPart*> parts;
    mutable std::size_t snapshot_size = 0;  // of the last one
    std::vector<Handle> to_come;            // of whom is made again inside of what is done again
    const Inquiry* inquiry = nullptr;       // the innermost that is being made
    bool replaying = false;  // what is done now was done before: nobody is told, nothing settles

    std::int64_t weight = 0;
    std::int64_t weight_mark = INT64_MAX;
    std::function<void()> mark_passed;  // told once

    std::uint64_t step = 0;
    Writer writer = Writer::module;
    bool records = false;  // history.recording(writer), kept by note_recording
    std::function<std::string()>* locate = nullptr;
    std::vector<Observer*> observers;  // null: it left while they were told
    int telling = 0;                   // calls of them that go on
    std::vector<WriteLog*> logs;       // told of numbers, too
    std::vector<std::string> remarks;  // what could not be as it was, of the last restore
    const char* pinned = nullptr;      // what is called and must not destroy the tree, if anything
    int deletions = 0;                 // that go on, one inside the other
    std::vector<Handle> making;        // whose modules make them, one inside the other
    bool restoring = false;
    FormulaCompiler formula_compiler;
    Handle root;
    const Event* ready_event = nullptr;
    const Event* deleted_event = nullptr;
    const Event* restored_event = nullptr;

    /// Another after whatever may have changed a value that nobody announces. What the shortest way
    /// takes back it had before: nobody can have looked in between.
    std::uint64_t epoch() const { return upheavals + writes.ever(); }

    /// While it lives, what is called may destroy the tree: its state lives on as long.
    class Use {
      public:
        explicit Use(State& state) : state_(state) { ++state_.uses; }
        ~Use() {
            if (--state_.uses == 0) const std::unique_ptr<State> dead = std::move(state_.orphan);
        }
        Use(const Use&) = delete;
        /// At the end: throws Error(deleted) if that happened.
        void finish() const;

      private:
        State& state_;
    };

    /// While it lives, what is called must not destroy the tree: when it does so nevertheless, the
    /// program is ended with a message that names `what`: "a lifecycle function".
    class Pin {
      public:
        Pin(State& state, const char* what)
            : state_(state), outer_(std::exchange(state.pinned, what)) {}
        ~Pin() { state_.pinned = outer_; }
        Pin(const Pin&) = delete;

      private:
        State& state_;
        const char* outer_;
    };
    /// Throws where the tree must not be destroyed; from its destructor, which ends the program.
    void require_unpinned() const;
    /// Throws where the instance, or one below it, is being deleted. `what`: "move an instance".
    void require_staying(Handle instance, std::string_view what) const;
    /// While it lives, the module of an instance makes it and must not delete it.
    class Making {
      public:
        Making(State& state, Handle self) : state_(state) { state_.making.push_back(self); }
        ~Making() { state_.making.pop_back(); }
        Making(const Making&) = delete;

      private:
        State& state_;
    };
    /// Throws where the instance, or one below it, is being made.
    void require_made(Handle instance, std::string_view what) const;
    /// Throws while anything is being deleted, for what changes the tree as a whole.
    void require_no_deletion(std::string_view what) const;

    // membership.cpp: what is handed in belongs to this tree, and to that instance
    bool has(const Node& node, const Property& property) const {
        const Class& of = classes[node.class_id];
        return property.owner == &of || has_otherwise(node, property);
    }
    /// Inherited, or added to this very instance.
    bool has_otherwise(const Node& node, const Property& property) const;
    const Node& require(Handle handle, const Property& property) const {
        const Node& node = require(handle);
        if (!has(node, property)) [[unlikely]]
            refuse_foreign(handle, property);
        return node;
    }
    [[noreturn]] void refuse_foreign(Handle handle, const Property& property) const;
    void require_own(const Class& of) const;
    void require_event(const Class& of, const Event& event) const;
    /// Of an instance of this tree.
    void require_event(Handle instance, const Event& event) const;
    static void refuse_unless_of(const Class& of, const Event& event);
    void require_values(Handle instance, const Event& event,
                        const std::vector<Value>& values) const;
    void require_method(Handle handle, const Method& method) const;
    void add_weight(std::int64_t bytes) {
        weight += bytes;
        if (weight > weight_mark) [[unlikely]]
            pass_mark();
    }
    void pass_mark();

    Node& require(Handle handle) {
        Node* node = nodes.find(handle);
        if (node == nullptr) throw_deleted(handle);
        return *node;
    }
    const Node& require(Handle handle) const { return const_cast<State*>(this)->require(handle); }
    [[noreturn]] void throw_deleted(Handle handle) const;
    /// Throws where nothing may be changed: formulas compute and functions that are asked answer.
    /// `what`: "delete an instance".
    void require_changeable(std::string_view what) const;
    void bury(Tombstone tombstone);
    /// nullptr where the instance lives, or was deleted too long ago.
    const Tombstone* tombstone(Handle handle) const;
    /// To be called whenever the writer is another, or an edit begins or ends.
    void note_recording() {
        records = history.recording(writer);
        note_listeners();
    }
    /// To be called whenever a formula begins or ends to compute or an inquiry to be made, and when
    /// there may be other shadows.
    void note_listeners() { writes.open(shadows.empty() && !only_the_long_way()); }
    /// What is written is an edit to be recorded, or not allowed.
    bool only_the_long_way() const { return records || formulas.tracking() || inquiry != nullptr; }
    void structure_changed(std::uint32_t parent, const NodeName& name);

    /// Calls `what(observer)` for each observer.
    template <class What>
    void tell(What what) {
        tell_plain_writes();
        if (!replaying && !observers.empty()) tell_each(what);
    }
    /// Who is told may come and go meanwhile.
    template <class What>
    void tell_each(What what) {
        struct Telling {
            State& state;
            Pin pin{state, "an observer"};
            explicit Telling(State& s) : state(s) { ++state.telling; }
            ~Telling() {
                if (--state.telling == 0) std::erase(state.observers, nullptr);
            }
        } now(*this);
        for (std::size_t i = 0; i < observers.size(); ++i)
            if (Observer* const observer = observers[i]) what(*observer);
    }
    void tell_plain_writes() {
        if (writes.any_untold()) tell_untold();
    }

    // tree.cpp
    void define_object();
    /// `again`: the instance comes back with its old identity.
    std::uint32_t make(const Class& of, std::uint32_t parent, NodeName name, bool named,
                       Handle again = {});
    void check_child_name(Handle parent, std::string_view name) const;
    /// Bytes of a name of an instance, or of a property that is added to one: a person reads it.
    static constexpr std::size_t longest_name = 1000;
    static void check_length(std::string_view name);
    /// Whether something of that name is below `parent`: a child, a property or a method.
    bool is_taken(std::uint32_t parent, const NodeName& name) const;
    /// `stem_1`, `stem_2` ...: never one used before under this parent.
    NodeName free_name(std::uint32_t parent, std::string_view stem);
    /// Logs note the number that was given last, so that a step that is made again gives the same
    /// ones. To be called where it may have changed and nothing is told that changes it again.
    void note_number(std::uint32_t parent, Symbol stem);
    /// `stem`, `stem_2` ...: the first that is free.
    NodeName plain_name(std::uint32_t parent, std::string_view stem) const;
    void require_columns(const Class& of) const;
    void finish_making(Handle self, const Class& of);
    void unmake(Handle self);
    /// `remember`: who asks for it later is told who deleted it.
    /// What a module throws is kept in `problem`, the first of it, and the deletion goes on.
    void destroy_one(std::uint32_t index, const Cause& cause, bool remember, std::string& problem);
    /// What modules have thrown, the first of it; "": nothing.
    std::string destroy_below(std::uint32_t top);
    void visit_below(std::uint32_t top, const std::function<void(std::uint32_t)>& visit) const;

    // tree_placing.cpp
    void require_movable(Handle instance) const;
    void require_room_below(Handle parent, std::size_t levels) const;
    void place_subtree(Handle top);
    void hang(Handle instance, const Position& at);
    void hang_back(Handle instance, const Position& was);
    void hang_or_leave(Handle instance, const Position& at);
    void told_of_move(Handle instance);

    // tree_edit.cpp
    Value read(std::uint32_t index, const Node& node, const Property& property) const;
    Value coerce(Handle instance, const Property& property, const Value& value) const;
    void write(std::uint32_t index, const Node& node, const Property& property, const Value& value);
    void written(Handle handle, const Node& node, const Property& property, const Value& old_value);
    const Property& ad_hoc_property(Symbol name);
    void put_ad_hoc(Handle instance, const Property& added, const Value& value);
    const Property& add_ad_hoc(Handle instance, std::string_view name, const Value& value);
    void drop_formula(Handle instance, const Property& property);
    std::string cell_path(Handle handle, const Property& property) const;

    // typed_ways.cpp
    template <class T>
    Put write_at_once(Handle instance, const Property& property, T value);
    template <class T>
    bool write_by_way(Handle instance, const Property& property, T value);
    template <class T>
    bool end_write(Put begun, Handle instance, const Property& property, const T& value);
    [[noreturn]] void refused(Handle instance, const Property& property) const;
    void tell_untold();

    // delivery.cpp
    void note_edit();
    void watcher_added(const Watcher& watcher);
    void watcher_removed(const Watcher& watcher);
    void count_interest(const Watcher& watcher, int sign);
    std::uint32_t top_of(const Pattern& pattern) const;
    template <class Visit>
    void each_cell_wanted(const Watcher& watcher, Visit visit);
    void refresh_shadows_below(std::uint32_t top);
    void queue_change(Handle handle, const Property& property, const Value& old_value,
                      const Value& new_value, const Cause& cause);
    void queue_item(QueueItem item);
    void queue_deletion(Handle handle, const Class& of, const Cause& cause);
    /// The same for one that is gone already. `own`: only its own watchers knew it.
    void queue_farewell(Existence gone, bool only_own);
    bool wants_farewell(Handle handle, const Class& of, bool only_own) const;
    void deliver_all(std::exception_ptr& first_error);
    void run_actions(std::exception_ptr& first_error);
    void compare_shadows();
    void join_queued(Motion& motion);
    void deliver(QueueItem& item);
    void deliver_change(const Change& change, WatcherId until);
    void deliver_motion(Motion& motion, WatcherId until, std::exception_ptr& error);
    void deliver_event(const Occurrence& occurrence, WatcherId until);
    template <class What>
    void deliver_to(const QueueItem& item, const What& what);
    template <class What>
    void call(const Watcher& watcher, const What& what);
    std::string describe(const Change& change) const;
    std::string describe(const Existence& existence) const;
    std::string describe(const Occurrence& occurrence) const;
    std::string describe(const QueueItem& item, std::size_t part) const;
    void barrier_overrun(const std::vector<std::vector<QueueItem>>& generations);
};

}  // namespace fettle::property
