#pragma once
// The base class of modules. A module registers classes whose properties lie in its own memory; the
// loop steps the module.

#include <cstdint>
#include <string_view>

#include <fettle/module/export.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/tree.h>

FETTLE_MODULE_BEGIN

namespace fettle::module {

/// A module whose classes are saved natively (`property::Snapshots`) writes its rows in `save`,
/// reads them in `restore`, and calls `tree.add_part(*this)` in `attach`. Other modules need none
/// of this: their instances are saved value by value.
class Module : public property::SnapshotPart {
  public:
    ~Module() override;
    virtual std::string_view name() const = 0;  ///< unique in a tree: "physics"
    std::string_view part_name() const override { return name(); }
    property::Memory save(property::ByteWriter&) const override { return {}; }
    std::function<void()> restore(property::ByteReader&, const property::Memory&) override {
        return [] {};
    }
    /// Registers its classes and creates its services (`game.world`). Called once; the module must
    /// outlive the tree.
    virtual void attach(property::Tree& tree) = 0;
    /// One fixed step of `dt` seconds. Writes the module's own memory only; no handler runs during
    /// it.
    virtual void step(double dt) = 0;
    /// Reports the events of the step to the tree; the next barrier delivers them.
    virtual void report(property::Tree& tree) = 0;
    /// Hash of all data that influence later steps, in a fixed order.
    virtual std::uint64_t hash() const = 0;
};

}  // namespace fettle::module

FETTLE_MODULE_END
