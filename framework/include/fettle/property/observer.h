#pragma once
// Observers receive all changes of a tree from outside the simulation, right after they are made.
// They are for replay logs and journals; game logic uses watchers instead.

#include <memory>
#include <span>
#include <string>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/symbol.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class SnapshotPart;
class Tree;

/// A number (in `x`) or a vec2 that was written to a declared property. If the instance is empty,
/// the write was refused later.
struct PlainWrite {
    Handle instance;                     ///< that was written; empty: the write was refused
    const Property* property = nullptr;  ///< that was written
    double x = 0, y = 0;                 ///< the number in `x`, or the vector
    /// The value in the property.
    Value value() const;
};

/// Several writes in order. To read them later, keep `owner` instead of a copy.
struct PlainWrites {
    std::span<const PlainWrite> list;   ///< in order
    std::shared_ptr<const void> owner;  ///< keeps the list alive
};

/// Members are called in the middle of a write, also of writes by scripts: their time is part of
/// the game's time; they must not throw and must not change the tree. `Tree::cause()` is the
/// writer; it is Writer::formula for results of formulas.
class Observer {
  public:
    virtual ~Observer() = default;
    /// A plain value was written; it replaced a formula if there was one. The write may have added
    /// an ad-hoc property.
    virtual void wrote(Handle, const Property&, const Value& /*now*/) {}
    /// The list of a property got another or a further element, from 1. Null: the last element was
    /// removed. The default calls `wrote`.
    virtual void wrote_element(Handle instance, const Property& property, std::size_t /*index*/,
                               const Value* /*element*/, const Value& now) {
        wrote(instance, property, now);
    }
    /// Several writes of the typed functions (`Tree::write`), in order. Scripts use these most, and
    /// one call per write would cost more than the write. Called before any other member, and
    /// before the writer or the step changes. The default calls `wrote` for each.
    virtual void wrote_plain(const PlainWrites& writes);
    /// The override of the property was removed, or its default was restored.
    virtual void was_reset(Handle, const Property&) {}
    /// An ad-hoc property was removed.
    virtual void removed(Handle, const Property&) {}
    /// The property got a formula, or lost it and kept its last value: see `Tree::formula`.
    virtual void formula_changed(Handle, const Property&) {}
    /// The instance has its row and its defaults. Instances that its class creates below it are
    /// reported before it.
    virtual void created(Handle) {}
    /// Called before the instance and everything below it is deleted.
    virtual void destroying(Handle) {}
    /// The instance has another name, parent or place among its siblings.
    virtual void moved(Handle) {}
    /// Called before and after a method that changes its module's own memory (`Method::effect`).
    /// Its changes of the tree are reported, too.
    virtual void call_begins(Handle, const Method&, std::span<const Value> /*arguments*/) {}
    /// Called after such a method.
    virtual void call_ends(Handle, const Method&) {}
    /// A read is about to update memory of a module that edits left out of date
    /// (`Tree::refreshing`).
    virtual void refreshing(SnapshotPart&, std::uint64_t /*what*/) {}
    /// All that is written until `edit_ends` is one step of undo (`Tree::begin_edit`); edits may
    /// be in each other.
    virtual void edit_begins(const std::string& /*name*/, bool /*scripts*/) {}
    /// The edit that began last has ended.
    virtual void edit_ends() {}
    /// A snapshot was restored: everything may be different. Its changes are not reported one by
    /// one.
    virtual void restored() {}
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
