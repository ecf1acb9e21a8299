#pragma once
// Observers: told of everything that is done to a tree from outside the simulation, at the moment
// it has been done. Logs that play it again and journals that keep it are fed by them; game logic
// watches instead.

#include <memory>
#include <span>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/symbol.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class SnapshotPart;
class Tree;

/// A number (in `x`) or a vec2 that was written to a declared property. One of nobody (an empty
/// instance) was refused after all.
struct PlainWrite {
    Handle instance;
    const Property* property = nullptr;
    double x = 0, y = 0;
    /// As the property holds it.
    Value value() const;
};

/// Some of them in their order. Who wants to look at them later keeps `owner` rather than a copy.
struct PlainWrites {
    std::span<const PlainWrite> list;
    std::shared_ptr<const void> owner;
};

/// Members are called in the middle of a write, scripts' writes included: an implementation costs
/// the game what it costs, must not throw, and must not change the tree. Who writes is
/// `Tree::cause()`; what a formula computes is written by Writer::formula.
class Observer {
  public:
    virtual ~Observer() = default;
    /// A plain value was written; it replaced a formula, if there was one. The property may be an
    /// ad-hoc one that came with it.
    virtual void wrote(Handle, const Property&, const Value& /*now*/) {}
    /// Several writes of the typed ways (`Tree::write`), in their order: what scripts write most,
    /// told together because a call for each would cost more than the write. Told before anything
    /// else is, and before the writer or the step changes. Calls `wrote` for
    /// each unless it is overridden.
    virtual void wrote_plain(const PlainWrites& writes);
    /// The property was given back to its owner, or its default.
    virtual void was_reset(Handle, const Property&) {}
    /// An ad-hoc property ended.
    virtual void removed(Handle, const Property&) {}
    /// A formula became the value of the property, or ended and left its last value:
    /// `Tree::formula` tells which.
    virtual void formula_changed(Handle, const Property&) {}
    /// Its row and its defaults exist. Instances that its class makes below it come first.
    virtual void created(Handle) {}
    /// Before the instance, and everything below it, goes.
    virtual void destroying(Handle) {}
    /// It has another name, parent or place among its siblings.
    virtual void moved(Handle) {}
    /// Around a call of a method that changes its module's own memory (`Method::effect`). What it
    /// does to the tree meanwhile is told as well.
    virtual void call_begins(Handle, const Method&, std::span<const Value> /*arguments*/) {}
    virtual void call_ends(Handle, const Method&) {}
    /// Somebody reads what edits have left out of date in a module's memory, and it is about to be
    /// brought up to date (`Tree::refreshing`).
    virtual void refreshing(SnapshotPart&, std::uint64_t /*what*/) {}
    /// A snapshot was restored: anything may be different. Nothing else is told of it.
    virtual void restored() {}
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
