#pragma once
// The live property tree: instances with classes, parents, ordered children and properties.
// Everything can be reached by a path.
//
// The module that computes with a value owns its memory; the tree knows where it is. Reading a
// property reads the module's own memory. An edit goes through these steps: coerce -> validate ->
// stop if equal -> setter -> invalidate hook -> queue the change. The simulation writes its own
// memory and does not call the tree: its watched values are compared with shadow values at the
// barrier after the step. Handlers run only at barriers.
//
// One thread owns a tree. Throwing members throw property::Error with path, value, expectation and
// nearest spelling. Exceptions of a getter or a lifecycle function of a class reach the caller
// unchanged. A handle belongs to its tree: in another tree, the same number may refer to another
// instance.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
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

class Drawer;
class EditObserver;
class Observer;

/// Data of a deleted instance.
struct DeletedInfo {
    const Class& of;   ///< its class
    std::string name;  ///< its last name
};

/// By stem, the number with which `Tree::move` begins to look for a free plain name. So many
/// children of one parent get their names in linear time. It is valid while no child leaves this
/// parent.
using PlainNames = std::map<std::string, std::uint32_t, std::less<>>;

/// All instances of a game, with their classes, values, watchers, formulas and history.
///
/// Lifetimes: handles are numbers. After the end of the tree they refer to nothing and do no
/// harm. Connections, values, records and snapshots may outlive it. Classes, properties, methods
/// and events live as long as the tree that they were registered with, and any other tree refuses
/// them. Modules, parts of snapshots and observers are not owned: they must live until the tree is
/// destroyed, or until `remove_part` and `unobserve`. As soon as its destruction begins, the tree
/// calls no part, observer or formula any more, so lifecycle functions may destroy these then.
/// A script::Runtime, a WriteLog and Tweaks may outlive the tree, but cannot be used then. The
/// function of `placement_restorer` does nothing then. A handler, a function given to `at_barrier`
/// or a method may destroy the tree that calls it: `barrier` or `call` throws Error(deleted) after
/// the function has returned. The following must not destroy the tree: formulas, lifecycle
/// functions, setters, observers, functions that are called in the middle of a step or of a search
/// (question.h, acceptance.h), and functions given to `each_below`, `mark_weight` or `restore`. If
/// one does, the program ends with a message that names it. Getters, and setters that the typed
/// functions call, must not do it either, but this is not checked, because a check would cost time
/// in every read and write.
class Tree {
  public:
    Tree();
    ~Tree();
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    /// For objects that refer to the tree and may outlive it. It expires as soon as the destruction
    /// of the tree begins.
    std::weak_ptr<const Tree*> lifetime() const;

    // --- Classes

    /// Throws Error, which names class and member, for an invalid descriptor: a name that is taken
    /// or invalid, also within the class; an unknown base; an accessor without `get`, a column
    /// without `base` or of another type, a method without `call`; a range that ends before it
    /// begins; a default that its own property would refuse. A property of a base class may be
    /// declared again only with another default or doc.
    const Class& define(ClassDescriptor descriptor);
    const Class* find_class(std::string_view name) const;  ///< null if there is none
    /// Throws Error(unknown_name) with the nearest spelling.
    const Class& class_named(std::string_view name) const;
    std::vector<const Class*> classes() const;  // in order of definition
    /// The base class of all classes: plain nodes, `Object {}`.
    const Class& object_class() const;

    // --- Instances

    Handle root() const;  // `game`
    /// Without a parent the instance is detached: alive, editable, not simulated. Without a name it
    /// gets a name from the stem of its class: "body_1", then "body_2"; detached, "body".
    Handle create(const Class& instance_class, Handle parent = {}, std::string_view name = {});
    /// Deletes the instance and everything below it. Handles become invalid at once; `deleted` is
    /// delivered at the barrier. Exceptions of modules (`Lifecycle::destroy`) do not stop this:
    /// after all instances are deleted, the first is thrown as Error(rejected).
    void destroy(Handle instance);
    bool alive(Handle instance) const;  ///< false for a null handle, too
    /// Throws Error(deleted) "world.ball was deleted at step 412 by console" if it is not alive.
    void require(Handle instance) const;
    const Class& class_of(Handle instance) const;  ///< throws Error(deleted)
    /// Data of a deleted instance, for messages about its handle; nullopt while it lives, and for
    /// instances that were deleted long ago.
    std::optional<DeletedInfo> deleted_info(Handle instance) const;
    /// The number of the instance's object in its module; throws Error(deleted).
    Row row(Handle instance) const;
    /// For modules whose object moved to another row outside `Lifecycle::place`. The tree does not
    /// check the row: from then on it reads and writes the module's memory there.
    void set_row(Handle instance, Row row);

    Handle parent(Handle instance) const;        // null for the root and for detached instances
    Handle first_child(Handle instance) const;   ///< null if there is none
    Handle next_sibling(Handle instance) const;  ///< null if there is none
    std::vector<Handle> children(Handle instance) const;  ///< in order
    std::size_t child_count(Handle instance) const;       ///< without what is below them
    /// Counts from 1; a null handle if there are fewer. Fast if called in order.
    Handle nth_child(Handle instance, std::uint64_t n) const;
    /// A null handle if there is none.
    Handle child(Handle instance, std::string_view name) const;
    /// Whether `ancestor` is a parent of it, or a parent of its parent, and so on.
    bool is_below(Handle instance, Handle ancestor) const;
    /// A number that changes whenever an instance is created, deleted, moved or renamed.
    std::uint64_t structure() const;
    /// Number of living instances.
    std::size_t size() const;
    /// Calls `visit` for all instances below `top` in a fixed order, parents before children.
    void each_below(Handle top, const std::function<void(Handle)>& visit) const;

    std::string name(Handle instance) const;  ///< among its siblings
    /// "world.ball"; "game" for the root; "(detached ball)" for a detached instance.
    std::string path(Handle instance) const;
    std::string path(Handle instance, const Property& property) const;
    /// Throws Error(bad_name): empty, taken by a sibling, or a property or method of the parent.
    void rename(Handle instance, std::string_view name);
    /// Gives the instance another parent (null: detaches it). If `name` is empty, it keeps its own
    /// name, numbered if that is taken; below the root, "game" is taken. An instance that was never
    /// given a name gets one from its class's stem: "circle_1", then "circle_2"; with
    /// `plain_names`, "circle", then "circle_2". Throws Error(bad_structure) for a parent below the
    /// instance itself, and if a module is making or placing the instance or one below it
    /// (`Lifecycle`). After an error nothing has changed; a module may refuse (Error(rejected)).
    void move(Handle instance, Handle new_parent, std::string_view name = {},
              PlainNames* plain_names = nullptr);
    /// Deletes `old` and gives its name and its parent to `by`, which must be detached. After an
    /// error nothing has changed; throws as `move` does. If a module throws when it is notified of
    /// the deletion, all is done, and then Error(rejected) is thrown, as by `destroy`.
    void replace(Handle old, Handle by);
    /// Returns a function that undoes a later move: it moves the instance back to its current place
    /// and name, numbered if that is taken meanwhile. It never throws. It does nothing where `move`
    /// would throw (in a formula, for example), but can be called again later, and nothing if the
    /// instance, its parent or the tree does not exist any more.
    std::function<void()> placement_restorer(Handle instance);

    // --- Properties

    /// Declared or ad-hoc; nullptr if the instance has none of that name.
    const Property* find(Handle instance, Symbol name) const;
    const Property* find(Handle instance, std::string_view name) const;
    /// Throws Error(unknown_name) with the nearest spelling.
    const Property& property(Handle instance, std::string_view name) const;
    /// Declared ones, then ad-hoc ones by name.
    std::vector<const Property*> properties(Handle instance) const;
    std::vector<const Property*> ad_hoc(
        Handle instance) const;  ///< those that its class does not declare

    /// The value; throws the error of a formula, and Error(deleted).
    Value get(Handle instance, const Property& property) const;
    Value get(Handle instance, std::string_view name) const;
    /// The value in its owner's memory, even if its formula fails. It does not become a dependency
    /// of a running formula.
    Value peek(Handle instance, const Property& property) const;
    /// Writes the value after checking type, range and owner; throws Error, and changes nothing
    /// then.
    void set(Handle instance, const Property& property, const Value& value);
    void set(Handle instance, std::string_view name, const Value& value);
    /// Writes an element of the list that the property holds, from 1; one after the last is added.
    /// It has the effects of `set` with the whole list, but only the element is checked and, if
    /// nothing else holds the list (a snapshot, a watcher that waits for the change), nothing is
    /// copied: a list grows in constant time for each element.
    void set_element(Handle instance, const Property& property, std::size_t index,
                     const Value& element);
    /// Removes the last element, in the same way.
    void remove_last_element(Handle instance, const Property& property);
    /// The typed functions, for numbers and vec2s in the usual cases. The instance must have the
    /// property; this is not checked. They return false if `get` or `set` must be used (another
    /// type, a formula, a deleted instance, a watcher, a value that is not finite or out of range).
    /// Observers receive these writes before any other change, and before the writer or the step
    /// changes, but not at once.
    bool read(Handle instance, const Property& property, double& number) const;
    bool read(Handle instance, const Property& property, Vec2& vector) const;
    /// For the fastest reads: the row of the instance, for the `get` of the bindings of properties
    /// whose `shortcut.read` is `number` or `vec2`; nullptr if `read` must be used. Valid until the
    /// next change of the tree.
    const Row* readable(Handle instance) const;
    /// As `read`, for writing.
    bool write(Handle instance, const Property& property, double number) {
        const WriteResult begun = begin_write(instance, property, number);
        return begun == WriteResult::done || end_write(begun, instance, property, number);
    }
    /// As `read`, for writing.
    bool write(Handle instance, const Property& property, const Vec2& vector) {
        const WriteResult begun = begin_write(instance, property, vector);
        return begun == WriteResult::done || end_write(begun, instance, property, vector);
    }
    /// Restores the default (or the value that its owner computes).
    void reset(Handle instance, const Property& property);
    bool overridden(Handle instance,
                    const Property& property) const;  ///< whether `reset` would change it

    /// Sets a property, and adds it to this instance if it has none of that name. Throws
    /// Error(near_miss) if the name is similar to a declared one, Error(bad_name) if a child or a
    /// method has it.
    void set_or_add(Handle instance, std::string_view name, const Value& value);
    /// Removes a property that the class does not declare.
    void remove_ad_hoc(Handle instance, std::string_view name);

    /// `value` coerced to the type of that property by the rules of the tree; throws like `set`.
    /// Changes nothing.
    Value coerce(Handle instance, const Property& property, const Value& value) const;
    /// The value as the console prints it: references by path, numbers of float properties short.
    std::string text(const Value& value, Precision precision = Precision::double_precision) const;

    // --- Formulas

    /// From now on the function *is* the value of the property. Its dependencies are found by
    /// running it; a read of the property gives its result, and a plain write replaces it. Reads
    /// throw its error, also that of a cycle; the owner's memory keeps the last valid value.
    void set_formula(Handle instance, const Property& property, Formula formula);
    /// Adds the property first if the instance has none of that name; throws as `set_or_add` does.
    void set_formula(Handle instance, std::string_view name, Formula formula);
    /// nullptr if the value is a plain one. Valid until the formula is replaced.
    const Formula* formula(Handle instance, const Property& property) const;
    /// Removes the formula; its last valid value stays as a plain one.
    void remove_formula(Handle instance, const Property& property);
    /// Computes the formula and returns its error; "" if there is no error or no formula.
    std::string problem(Handle instance, const Property& property) const;
    /// The sources of the value, their sources, and so on, up to 3000 levels. If there are more
    /// levels, the last one has one source, "…".
    Explanation why(Handle instance, const Property& property) const;
    /// Number of properties with a formula.
    std::size_t formula_count() const;
    /// True while a formula runs: nothing may be changed then.
    bool in_formula() const;
    /// Throws Error "..., it cannot `what`" with the name of the running formula or question
    /// (`Inquiry`). Changes of the tree check this themselves; call it before other changes of a
    /// game. `what`: "call quit".
    void require_changeable(std::string_view what) const;
    /// False while a formula or an inquiry runs.
    bool changeable() const;
    /// Sets the compiler that makes formulas from their text, so that files can hold them. Empty:
    /// there is none.
    void compile_formulas_with(FormulaCompiler compiler);
    /// The function of `compile_formulas_with`.
    const FormulaCompiler& formula_compiler() const;

    // --- History

    /// Writes by people (console, inspector, remote) can be undone, each write by itself. All
    /// writes between `begin_edit` and `end_edit` are one step of undo. With `scripts`, writes by
    /// scripts and modules in between are part of the edit; a drag uses false, because the game
    /// continues during it. Edits may be nested.
    void begin_edit(std::string name, bool scripts = true);
    void end_edit();  ///< of the last `begin_edit`
    /// Undoes at once, as a new edit at the current time. Throws Error(bad_structure) inside an
    /// edit that has changed something. Before the first change, it undoes the step before the
    /// edit; this is for a console command that is only `undo()`.
    UndoResult undo();
    UndoResult redo();  ///< makes the step again that was undone last
    /// The latest first.
    std::vector<HistoryEntry> history() const;
    /// Memory limit of the history, 64 MiB by default; the oldest entries are dropped first. An
    /// entry that takes more than three quarters of it keeps only its name.
    void set_history_limit(std::size_t bytes);
    /// Memory of the history, estimated, and the sum of everything it ever contained: snapshots may
    /// hold entries that it has dropped.
    std::size_t history_bytes() const;
    std::size_t history_bytes_ever() const;  ///< with the entries that were dropped
    Provenance last_writer(Handle instance, const Property& property) const;  ///< the last writer
    /// Call this before the state of another past is restored that is the same up to `step`:
    /// `last_writer` then says `restore` for values that were written after that step.
    void forget_writers_after(std::uint64_t step);
    /// Whether `last_writer` has the place in a script of each write from now on. Otherwise it has
    /// the places of edits and of changes of watched values only, because finding the place takes
    /// longer than the write.
    void locate_writes(bool on);

    /// Calls a method. Throws Error for arguments that it does not take, and what the method
    /// throws.
    Result call(Handle instance, const Method& method, std::span<const Value> arguments);
    Result call(Handle instance, std::string_view method, std::initializer_list<Value> arguments);

    /// Draws `top` and the instances below it in the order of their `z`, with the draw functions of
    /// their classes and with `also`. If these functions change the tree, the instances that
    /// existed at the beginning and still live are drawn.
    void draw(Handle top, Painter& painter, double alpha, Drawer* also = nullptr) const;

    // --- Watching

    /// Watches one property of one instance.
    Connection watch(Handle instance, const Property& property, ChangeHandler handler,
                     WatchOptions options = {});
    Connection watch(Handle instance, std::string_view name, ChangeHandler handler,
                     WatchOptions options = {});
    /// Watches every property of one instance, ad-hoc ones included.
    Connection watch(Handle instance, ChangeHandler handler, WatchOptions options = {});
    /// Watches one property (or, with nullptr, every property) of every instance of a class or of
    /// one derived from it.
    Connection watch(const Class& of, const Property* property, ChangeHandler handler,
                     WatchOptions options = {});
    /// Watches all properties whose paths match a pattern (`Pattern`).
    Connection watch_pattern(std::string_view pattern, ChangeHandler handler,
                             WatchOptions options = {});
    /// Instances of a class, or of one derived from it, that were created.
    Connection watch_created(const Class& of, ExistenceHandler handler, WatchOptions options = {});
    /// Instances of a class, or one instance, that were deleted.
    Connection watch_deleted(const Class& of, ExistenceHandler handler, WatchOptions options = {});
    Connection watch_deleted(Handle instance, ExistenceHandler handler, WatchOptions options = {});

    /// Calls the handler for an event of an instance, or of all instances of a class.
    Connection on(Handle instance, const Event& event, EventHandler handler,
                  WatchOptions options = {});
    Connection on(const Class& of, const Event& event, EventHandler handler,
                  WatchOptions options = {});
    /// True if there is a handler. Check it before making a record.
    bool listens(Handle instance, const Event& event) const;
    bool listens(const Event& event) const;
    /// Queues the event for the next barrier. Throws Error, even without handlers, for an event of
    /// another class or tree, and for a number of values that differs from its fields.
    void emit(Handle instance, const Event& event, std::vector<Value> values);

    /// The action runs at the end of the next barrier between steps, after all deliveries; its
    /// changes are delivered in the same barrier. Its errors are treated as errors of handlers.
    void at_barrier(std::function<void()> action);

    /// Delivers everything queued, and compares the watched values of the simulation. Errors of
    /// handlers go to the error sink. Without a sink, the first error is thrown after all
    /// deliveries; so is the first exception of the sink. Throws Error(no_barrier_end) after 16
    /// generations of handlers that make changes. `between_steps` is false in the middle of a step,
    /// when functions given to `at_barrier` must wait.
    void barrier(bool between_steps = true);
    /// Sets the function that receives the errors of handlers.
    void on_handler_error(std::function<void(const HandlerError&)> sink);
    /// Number of registered watchers.
    std::size_t watcher_count() const;

    /// Not owned. Receives all changes from outside the simulation, until `unobserve` or the
    /// beginning of the tree's destruction.
    void observe(Observer& observer);
    void unobserve(Observer& observer);  ///< ends `observe`
    /// Not owned. Receives the edits of people and replaces the previous observer. Null: none.
    void observe_edits(EditObserver* observer);

    // --- Growth

    /// Memory of instances, values, watchers and other lasting data, in bytes. The estimate is the
    /// same in every run. It serves to measure how much something adds.
    std::int64_t weight() const;
    /// Adds memory that was allocated permanently, or subtracts freed memory.
    void add_weight(std::int64_t bytes);
    /// `passed` is called, once, when the weight exceeds `mark`. It may set another mark. It is
    /// called in the middle of the change that makes the tree grow: a change of its own throws
    /// Error.
    void mark_weight(std::int64_t mark, std::function<void()> passed);

    // --- Snapshots

    /// Not owned; its state becomes part of snapshots until `remove_part`. Throws Error(bad_name)
    /// if the name is taken.
    void add_part(SnapshotPart& part);
    void remove_part(SnapshotPart& part);             ///< ends `add_part`
    const std::vector<SnapshotPart*>& parts() const;  ///< in the order in which they were added
    /// A part must call this before a *read* makes it update memory that edits left out of date, if
    /// an earlier or later update could differ in the last bit. It is not for updates by an edit
    /// itself. `what` is passed back by `SnapshotPart::refresh`.
    void refreshing(SnapshotPart& part, std::uint64_t what);
    /// The whole state: instances, values, formulas, the history of edits, the step, and the parts.
    /// It is an `Inquiry`: getters and parts that are called cannot change the tree.
    Snapshot snapshot() const;
    /// Like `snapshot`, but written into `room`, which the snapshot keeps. For many snapshots, pass
    /// the memory of an old one (`Snapshot::release_payload`): getting new pages from the system
    /// takes longer than filling them.
    Snapshot snapshot(std::vector<std::byte> room) const;
    /// Restores the tree in place. Instances of the snapshot have their old handles again; later
    /// ones are deleted, and their handles will never refer to another instance. An instance that
    /// its module refuses to create (`Lifecycle::create`) is missing with all instances below it:
    /// see `restore_remarks`. Watchers stay with the instances that exist before and after, and get
    /// the changes, with cause `restore`, at the next barrier; so do handlers of `restored` of the
    /// root. Classes stay. Changes that were not yet delivered are dropped.
    ///
    /// A snapshot of another tree can be restored if this one has its classes and parts. Data that
    /// is bound to that tree is left out, as in `Snapshot::to_bytes`: formulas are compiled again
    /// from their text (`compile_formulas_with`), and the history of edits is empty.
    ///
    /// Throws Error(damaged) or, for a class or a module that this game does not have,
    /// Error(unknown_name), and nothing has changed then; Error(bad_structure) in a handler, and in
    /// functions that must not destroy the tree (Lifetimes): see `at_barrier`.
    void restore(const Snapshot& snapshot);
    /// Like `restore`; then `go_on` repeats the later changes, before any handler is called.
    void restore(const Snapshot& snapshot, const std::function<void()>& go_on);
    /// Reads the whole snapshot as `restore` does, and changes nothing: throws Error(damaged,
    /// unknown_name) where `restore` would.
    void check(const Snapshot& snapshot) const;

    // --- Time and cause

    /// Number of the current step of the simulation.
    std::uint64_t step() const;
    /// To be called before a step.
    void set_step(std::uint64_t step);
    /// Must be called after a step of the simulation: the next barrier compares its watched values.
    void stepped();
    /// Sets the current writer. `locate`, if given, is called only when the place is needed.
    class CauseScope {
      public:
        /// From now on, `writer` makes all changes.
        CauseScope(Tree& tree, Writer writer, std::function<std::string()>* locate = nullptr);
        /// Makes the previous writer current again.
        ~CauseScope();
        CauseScope(const CauseScope&) = delete;

      private:
        Tree& tree_;
        Writer writer_;
        std::function<std::string()>* locate_;
    };
    Cause cause() const;  ///< of changes that are made now

    struct FETTLE_PROPERTY_PRIVATE State;
    /// For the library itself.
    State& state() { return *state_; }
    /// For the library itself.
    const State& state() const { return *state_; }

  private:
    // `write` in two calls, for the fastest writes. The first call tries the fastest path and never
    // throws. Unless it returns `done`, the second must be called with the same arguments before
    // anything else is done to the tree; it does the rest, and returns and throws what `write`
    // does.
    WriteResult begin_write(Handle instance, const Property& property, double number);
    WriteResult begin_write(Handle instance, const Property& property, const Vec2& vector);
    bool end_write(WriteResult begun, Handle instance, const Property& property, double number);
    bool end_write(WriteResult begun, Handle instance, const Property& property,
                   const Vec2& vector);

    std::unique_ptr<State> state_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
