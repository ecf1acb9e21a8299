#pragma once
// A module plugs native objects into the tree: it registers classes whose properties are bound to
// memory of its own, and is stepped by whoever runs the loop.

#include <cstdint>
#include <string_view>

#include <fettle/module/export.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

FETTLE_MODULE_BEGIN

namespace fettle::module {

/// A module whose classes are saved natively (`property::Snapshots`) writes what its rows are in
/// `save`, reads it in `restore`, and calls `tree.add_part(*this)` in `attach`. The others have
/// nothing to do: their instances are saved value by value.
class Module : public property::SnapshotPart {
  public:
    ~Module() override;
    virtual std::string_view name() const = 0;
    std::string_view part_name() const override { return name(); }
    property::Memory save(property::ByteWriter&) const override { return {}; }
    std::function<void()> restore(property::ByteReader&, const property::Memory&) override {
        return [] {};
    }
    /// Registers its classes and creates the services it offers (`game.world`). Called once; the
    /// module outlives the tree's use of it.
    virtual void attach(property::Tree& tree) = 0;
    /// One fixed step of `dt` seconds. Writes its own memory only; no handler runs meanwhile.
    virtual void step(double dt) = 0;
    /// Tells the tree what happened in the step (events); the barrier that delivers it follows.
    virtual void report(property::Tree& tree) = 0;
    /// Of everything that influences later steps, in a fixed order.
    virtual std::uint64_t hash() const = 0;
};

}  // namespace fettle::module

FETTLE_MODULE_END
