#pragma once
// The live property tree: instances with classes, parents, ordered children and properties,
// reachable by path.
//
// Whoever computes with a value owns its memory; the tree is the map to it. Reading a property
// reads the module's own memory; an edit goes coerce -> validate -> equal? stop -> setter ->
// invalidate hook -> queue the change. The simulation writes its own memory and calls nothing here:
// what is watched of it is compared with a shadow value at the barrier after the step. Handlers run
// at barriers only.
//
// One thread owns a tree. Throwing members throw property::Error with path, value, expectation and
// nearest spelling; what a getter or a lifecycle function of a class throws goes on to the caller
// as it is. A handle belongs to the tree that gave it: another tree may have an instance of its own
// under the same number, and takes it for that.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/class.h>
#include <fettle/property/error.h>
#include <fettle/property/export.h>
#include <fettle/property/formula.h>
#include <fettle/property/history.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/symbol.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class EditObserver;
class Observer;

/// Of an instance that was deleted.
struct Remains {
    const Class& of;
    std::string name;
};

/// **Lifetimes.** Handles are numbers: after the tree they mean nothing and do no harm.
/// Connections, values, records and snapshots may outlive it. Classes, properties, methods and
/// events live as long as the tree that they were registered with, and are refused by any other.
/// Modules, parts of snapshots and observers are not owned: they live until the tree is gone, or
/// until `remove_part` and `unobserve`. A script::Runtime, a WriteLog and Tweaks may outlive the
/// tree, and are of no use then. A handler, a function given to `at_barrier` or a method may
/// destroy the tree that calls it: `barrier` or `call` throws Error(deleted) when it has returned.
/// Formulas, lifecycle functions, setters, observers, what is asked in the middle of a step or of a
/// search (question.h, acceptance.h), and what is given to `each_below`, `mark_weight` or `restore`
/// must not: the program is ended then, with a message that names them. Getters, and setters that
/// the typed ways call, must not either, and nobody looks: that would cost every read and write.
class Tree {
  public:
    Tree();
    ~Tree();
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    /// For objects that hold a reference to the tree and may outlive it: expired from the beginning
    /// of its destruction on.
    std::weak_ptr<const Tree*> lifetime() const;

    // --- Classes
    // ----------------------------------------------------------------------------------------------------

    /// Throws Error, which names class and member, for what a class cannot be: a name that is taken
    /// or is none, within the class too; an unknown base; an accessor without `get`, a column
    /// without `base` or of another type, a method without `call`; a range that ends before it
    /// begins; a default that its own property would refuse. What a base class declares may be
    /// declared again with another default or doc alone.
    const Class& define(ClassDescriptor descriptor);
    const Class* find_class(std::string_view name) const;
    /// Throws Error(unknown_name) with the nearest spelling.
    const Class& class_named(std::string_view name) const;
    std::vector<const Class*> classes() const;  // in order of definition
    /// The class every other derives from: plain nodes, `Object {}`.
    const Class& object_class() const;

    // --- Instances
    // --------------------------------------------------------------------------------------------------

    Handle root() const;  // `game`
    /// Without a parent the instance is detached: alive, editable, not simulated. Without a name it
    /// gets its class's stem: "circle", then "circle_2" under a parent when `first_plain`, else
    /// "body_1", "body_2".
    Handle create(const Class& instance_class, Handle parent = {}, std::string_view name = {});
    /// Deletes the instance and everything below it. Handles die at once; `deleted` is delivered at
    /// the barrier. What a module throws as it is told (`Lifecycle::destroy`) changes nothing of
    /// that: when all is gone the first is thrown as Error(rejected).
    void destroy(Handle instance);
    bool alive(Handle instance) const;
    /// Throws Error(deleted) "world.ball was deleted at step 412 by console" unless alive.
    void require(Handle instance) const;
    const Class& class_of(Handle instance) const;
    /// What is still known of an instance that was deleted, so that who kept its handle can tell
    /// what it was; nothing while it lives, and of those that were deleted long ago.
    std::optional<Remains> remains(Handle instance) const;
    Row row(Handle instance) const;
    /// For modules whose object moved to another row outside `Lifecycle::place`. The tree does not
    /// know which rows there are: from then on it reads and writes the module's memory there.
    void set_row(Handle instance, Row row);

    Handle parent(Handle instance) const;  // null for the root and for what is detached
    Handle first_child(Handle instance) const;
    Handle next_sibling(Handle instance) const;
    std::vector<Handle> children(Handle instance) const;
    std::size_t child_count(Handle instance) const;
    /// From 1; a null handle when there are not so many. Fast when they are asked for in order.
    Handle nth_child(Handle instance, std::uint64_t n) const;
    /// Null handle when there is none.
    Handle child(Handle instance, std::string_view name) const;
    bool is_below(Handle instance, Handle ancestor) const;
    /// Another number whenever an instance came, went or got another place or name.
    std::uint64_t structure() const;
    /// Number of living instances, and their visit in a fixed order (parents before children).
    std::size_t size() const;
    void each_below(Handle top, const std::function<void(Handle)>& visit) const;

    std::string name(Handle instance) const;
    /// "world.ball"; "game" for the root; "(detached ball)" when it hangs nowhere.
    std::string path(Handle instance) const;
    std::string path(Handle instance, const Property& property) const;
    /// Throws Error(bad_name): empty, taken by a sibling, or a property or method of the parent.
    void rename(Handle instance, std::string_view name);
    /// Gives the instance another parent (null: detaches it). `name` empty: keeps its own, numbered
    /// when taken. Throws Error(bad_structure) for a parent below the instance itself.
    /// All of it, or nothing: a module may refuse (Error(rejected)).
    void move(Handle instance, Handle new_parent, std::string_view name = {},
              bool first_plain = false);
    /// Deletes `old` and gives its name and its parent to `by`, which is detached. All of it, or
    /// nothing; throws as `move` does.
    void replace(Handle old, Handle by);
    /// For who may have to take a move back: puts the instance where it hangs now, under the name
    /// it has. Does nothing when it, or what it hung under, is gone; throws nothing.
    std::function<void()> way_back(Handle instance);

    // --- Properties
    // -------------------------------------------------------------------------------------------------

    /// Declared or ad-hoc; nullptr when the instance has none of that name.
    const Property* find(Handle instance, Symbol name) const;
    const Property* find(Handle instance, std::string_view name) const;
    /// Throws Error(unknown_name) with the nearest spelling.
    const Property& property(Handle instance, std::string_view name) const;
    /// Declared ones, then ad-hoc ones by name.
    std::vector<const Property*> properties(Handle instance) const;
    std::vector<const Property*> ad_hoc(Handle instance) const;

    Value get(Handle instance, const Property& property) const;
    Value get(Handle instance, std::string_view name) const;
    /// The value in its owner's memory, whatever a formula in error says of it. No dependency of a
    /// running formula.
    Value peek(Handle instance, const Property& property) const;
    void set(Handle instance, const Property& property, const Value& value);
    void set(Handle instance, std::string_view name, const Value& value);
    /// The typed ways, for numbers and vec2s in ordinary circumstances, of a property that the
    /// instance has: here that is not checked. False when `get` or `set`
    /// has to do it (another type, a formula, a dead instance, somebody to be told, a value that is
    /// not finite or out of range). Observers hear of what was written this way before they hear of
    /// anything else, and before the writer or the step changes, but not at once.
    bool read(Handle instance, const Property& property, double& number) const;
    bool read(Handle instance, const Property& property, Vec2& vector) const;
    /// For those who mind each nanosecond: the row of the instance, where properties with a
    /// `shortcut.read` of `number` or `vec2` may be read by their bindings' own `get`; nullptr when
    /// `read` has to be asked. Holds until anything is done to the tree.
    const Row* readable(Handle instance) const;
    bool write(Handle instance, const Property& property, double number) {
        const Put begun = begin_write(instance, property, number);
        return begun == Put::done || end_write(begun, instance, property, number);
    }
    bool write(Handle instance, const Property& property, const Vec2& vector) {
        const Put begun = begin_write(instance, property, vector);
        return begun == Put::done || end_write(begun, instance, property, vector);
    }
    /// `write` in two calls, for those who mind each nanosecond. The first takes the shortest way
    /// and throws nothing. Unless it returns Put::done, the second has to be called with the same
    /// arguments before anything else is done to the tree; it does the rest, and returns and throws
    /// what `write` does.
    Put begin_write(Handle instance, const Property& property, double number);
    Put begin_write(Handle instance, const Property& property, const Vec2& vector);
    bool end_write(Put begun, Handle instance, const Property& property, double number);
    bool end_write(Put begun, Handle instance, const Property& property, const Vec2& vector);
    /// Back to the default (or to what its owner computes).
    void reset(Handle instance, const Property& property);
    bool overridden(Handle instance, const Property& property) const;

    /// Sets a property, adding it to this instance when it has none of that name. Throws
    /// Error(near_miss) when the name is nearly a declared one, Error(bad_name) when a child or a
    /// method has it.
    void set_or_add(Handle instance, std::string_view name, const Value& value);
    void remove_ad_hoc(Handle instance, std::string_view name);

    /// What `value` becomes as that property: the coercion rules of the tree; throws like `set`.
    /// Changes nothing.
    Value coerce(Handle instance, const Property& property, const Value& value) const;
    /// As the console prints it, references by path, numbers of float properties short.
    std::string text(const Value& value, Precision precision = Precision::double_precision) const;

    // --- Formulas
    // ----------------------------------------------------------------------------------------------------

    /// The function *is* the value of the property from now on: what it reads is discovered by
    /// running it, a read of the property gives the settled value, and a plain write replaces the
    /// formula. An error in it, a cycle included, is thrown by reads; the owner's memory keeps the
    /// last good value meanwhile.
    void set_formula(Handle instance, const Property& property, Formula formula);
    /// Adds the property first when the instance has none of that name; throws as `set_or_add`
    /// does.
    void set_formula(Handle instance, std::string_view name, Formula formula);
    /// nullptr where the value is a plain one. Valid until the formula is replaced.
    const Formula* formula(Handle instance, const Property& property) const;
    /// Leaves the last good value as a plain one.
    void remove_formula(Handle instance, const Property& property);
    /// Settles the formula and tells what is wrong with it; "" when nothing is, or when there is
    /// none.
    std::string problem(Handle instance, const Property& property) const;
    /// Where the value comes from: the formula's sources, theirs, and so on, 3000 levels deep.
    /// Where more are below, the last has one source, "…".
    Explanation why(Handle instance, const Property& property) const;
    /// Of how many properties a formula is the value.
    std::size_t formula_count() const;
    /// True while a formula runs: nothing may be changed then.
    bool in_formula() const;
    /// Throws Error "..., it cannot `what`", naming the formula that runs or what is asked
    /// (`Inquiry`). What changes the tree does so by itself; this is for what changes a game
    /// otherwise. `what`: "call quit".
    void require_changeable(std::string_view what) const;
    /// False while a formula runs or a function is asked something.
    bool changeable() const;
    /// Whoever knows the language formulas are written in says how they are made of their text, so
    /// that files can hold them. Empty: nobody does.
    void compile_formulas_with(FormulaCompiler compiler);
    const FormulaCompiler& formula_compiler() const;

    // --- History
    // ----------------------------------------------------------------------------------------------------

    /// What people write (console, inspector, remote) is undoable, each write by itself; between
    /// `begin_edit` and `end_edit` all of it is one step of undo. With `scripts` what scripts and
    /// modules write meanwhile is an edit too; a drag, during which the game goes on, leaves that
    /// out. May be nested.
    void begin_edit(std::string name, bool scripts = true);
    void end_edit();
    /// Acts at once, as a new edit at the current time. Throws Error(bad_structure) in the middle
    /// of an edit that has changed something; before that, it undoes the step before the edit, as a
    /// console command does that is nothing but `undo()`.
    UndoResult undo();
    UndoResult redo();
    /// The latest first.
    std::vector<HistoryEntry> history() const;
    /// What the history may hold, 64 MiB unless told; the oldest entries go first. One that takes
    /// more than three quarters of it by itself stays in the list by its name only.
    void set_history_limit(std::size_t bytes);
    /// What the history takes, about, and what it ever took: snapshots hold what it has forgotten
    /// since they were taken.
    std::size_t history_bytes() const;
    std::size_t history_bytes_ever() const;
    Provenance who(Handle instance, const Property& property) const;

    Result call(Handle instance, const Method& method, std::span<const Value> arguments);
    Result call(Handle instance, std::string_view method, std::initializer_list<Value> arguments);

    /// Draws what is below `top`, by the classes' own drawing.
    void draw(Handle top, Painter& painter, double alpha) const;

    // --- Watching
    // ---------------------------------------------------------------------------------------------------

    Connection watch(Handle instance, const Property& property, ChangeHandler handler,
                     WatchOptions options = {});
    Connection watch(Handle instance, std::string_view name, ChangeHandler handler,
                     WatchOptions options = {});
    /// Every property of one instance, ad-hoc ones included.
    Connection watch(Handle instance, ChangeHandler handler, WatchOptions options = {});
    /// One property (or, with nullptr, every property) of every instance of a class or of one
    /// derived from it.
    Connection watch(const Class& of, const Property* property, ChangeHandler handler,
                     WatchOptions options = {});
    Connection watch_pattern(std::string_view pattern, ChangeHandler handler,
                             WatchOptions options = {});
    Connection watch_created(const Class& of, ExistenceHandler handler, WatchOptions options = {});
    Connection watch_deleted(const Class& of, ExistenceHandler handler, WatchOptions options = {});
    Connection watch_deleted(Handle instance, ExistenceHandler handler, WatchOptions options = {});

    Connection on(Handle instance, const Event& event, EventHandler handler,
                  WatchOptions options = {});
    Connection on(const Class& of, const Event& event, EventHandler handler,
                  WatchOptions options = {});
    /// Whether anyone listens: ask before making a record.
    bool listens(Handle instance, const Event& event) const;
    bool listens(const Event& event) const;
    /// Queued; delivered at the next barrier. Throws Error, though nobody listens, for an event of
    /// another class or tree, and another number of values than it has fields.
    void emit(Handle instance, const Event& event, std::vector<Value> values);

    /// Runs at the end of the next barrier between steps, when all is delivered; what it changes is
    /// delivered in the same barrier. Errors go the way of handlers' errors.
    void at_barrier(std::function<void()> action);

    /// Delivers everything queued, and compares what is watched of the simulation. Errors of
    /// handlers go to the error sink; without one the first is thrown when all are delivered, and
    /// so is the first that the sink throws. Throws Error(no_barrier_end) after 16 generations of
    /// handlers that make changes. `between_steps` is false in the middle of a step, when what
    /// `at_barrier` was given has to wait.
    void barrier(bool between_steps = true);
    void on_handler_error(std::function<void(const HandlerError&)> sink);
    /// How many watchers are registered.
    std::size_t watcher_count() const;

    /// Not owned; told of everything done from outside the simulation, until `unobserve`.
    void observe(Observer& observer);
    void unobserve(Observer& observer);
    /// Not owned; told of what people edit, instead of the one before. Null: nobody.
    void observe_edits(EditObserver* observer);

    // --- Growth
    // --------------------------------------------------------------------------------------------------

    /// About how many bytes instances, values, watchers and what else lasts have come to take, an
    /// estimate that is the same in every run: for telling how much something adds.
    std::int64_t weight() const;
    /// Something else that was made for good, or given back.
    void add_weight(std::int64_t bytes);
    /// `passed` is called, once, when the weight comes to be more than `mark`; it may set another
    /// mark, and changes nothing else. It is called in the middle of what makes the tree grow.
    void mark_weight(std::int64_t mark, std::function<void()> passed);

    // --- Snapshots
    // --------------------------------------------------------------------------------------------------

    /// Not owned; what it is becomes part of snapshots until `remove_part`. Throws Error(bad_name)
    /// for a name taken.
    void add_part(SnapshotPart& part);
    void remove_part(SnapshotPart& part);
    const std::vector<SnapshotPart*>& parts() const;
    /// To be called by a part, before it does so, when a *read* makes it bring memory up to date
    /// that edits had left behind, where doing it earlier or later may differ in the last bit; not
    /// for what an edit does itself. `what` is given back to it by `SnapshotPart::refresh`.
    void refreshing(SnapshotPart& part, std::uint64_t what);
    /// All of it: instances, values, formulas, the history of edits, the step, and the parts.
    Snapshot snapshot() const;
    /// The same, written over `room`, which it keeps. Who takes many gives the memory of an old one
    /// (`Snapshot::take_payload`): finding new pages takes the system longer than filling them.
    Snapshot snapshot(std::vector<std::byte> room) const;
    /// Puts the tree back, in place. Who existed then has their handles again; who came since is
    /// deleted, and no handle to them will ever mean anybody else. Whom its module would not make
    /// again (`Lifecycle::create`) is missing with all below: `restore_remarks` tells. Watchers
    /// stay with the instances that exist on both sides and are told of what changed, cause
    /// `restore`, at the next barrier; so is who listens to `restored` of the root. Classes stay.
    /// Changes that were still to be delivered are not.
    ///
    /// Throws Error(damaged) or, for what this game does not have (a class, a module),
    /// Error(unknown_name), and nothing has changed then; Error(bad_structure) in a handler, and in
    /// anything that must not destroy the tree (Lifetimes): see `at_barrier`.
    void restore(const Snapshot& snapshot);
    /// The same; `go_on` then redoes what happened since, before anybody is told.
    void restore(const Snapshot& snapshot, const std::function<void()>& go_on);
    /// Reads all of it as `restore` does, and changes nothing: throws Error(damaged, unknown_name)
    /// where `restore` would.
    void check(const Snapshot& snapshot) const;

    // --- Time and cause
    // ---------------------------------------------------------------------------------------------

    std::uint64_t step() const;
    void set_step(std::uint64_t step);
    /// The simulation has written without telling: the next barrier compares what is watched of it.
    void stepped();
    /// Who is writing now. `locate`, when given, is asked for the place only when somebody needs
    /// it.
    class CauseScope {
      public:
        CauseScope(Tree& tree, Writer writer, std::function<std::string()>* locate = nullptr);
        ~CauseScope();
        CauseScope(const CauseScope&) = delete;

      private:
        Tree& tree_;
        Writer writer_;
        std::function<std::string()>* locate_;
    };
    Cause cause() const;

    struct FETTLE_PROPERTY_PRIVATE State;
    State& state() { return *state_; }
    const State& state() const { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
