#pragma once
// A class of the tree that a module described in C.
//
// The tree's descriptors hold functions and a context. The context of a bridged member is one of
// the structures below, which holds the module's own function and context. So a reload changes
// nothing in the tree: the new functions replace the old ones in these structures.

#include <deque>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fettle/module/abi.h>
#include <fettle/property/class.h>

#include "host_table.h"

namespace fettle::module {

struct BridgedProperty {
    HostTable* host = nullptr;
    const property::Property* declared = nullptr;
    fettle_property native{};
    Named named{};
    bool removed = false;  // the current module does not have this property
};

struct BridgedMethod {
    HostTable* host = nullptr;
    const property::Method* declared = nullptr;
    fettle_method native{};
    Named named{};
    bool removed = false;
};

class BridgedClass {
  public:
    /// Registers the class with the host's tree. Throws property::Error.
    BridgedClass(HostTable& host, const fettle_class& native);
    BridgedClass(const BridgedClass&) = delete;
    BridgedClass& operator=(const BridgedClass&) = delete;

    const property::Class& declared() const { return *declared_; }
    /// True if the module saves and restores the rows of this class itself. False if a snapshot
    /// stores each property.
    bool saved_natively() const { return (native_.flags & FETTLE_SAVED_NATIVELY) != 0; }
    /// Index and generation of all instances with a row in the module, including those of derived
    /// classes.
    const std::set<std::pair<std::uint32_t, std::uint32_t>>& instances() const {
        return instances_;
    }
    /// Makes the row of an instance that is being created.
    fettle_row create(property::Handle self);
    /// Makes a row in the new module for an instance that already exists in the tree.
    void revive(property::Handle self);
    /// Destroys the row of the instance and keeps the instance.
    void retire(property::Handle self);
    /// Updates `instances()` after a snapshot was restored, which adds and removes instances
    /// without `create` and `destroy`.
    void recount();
    /// The bridged property of a declared one; null if it does not belong to this class.
    const BridgedProperty* find(const property::Property& declared) const;
    /// After this, no function of the module is called for this class.
    void abandon();

    /// Uses the functions of the new module from now on. A removed property reads as its default
    /// and refuses writes. `notes` gets a line for each added and removed member. Throws
    /// std::runtime_error if a property has another type, or the class another base or another way
    /// of saving.
    void replace(const fettle_class& native, std::vector<std::string>& notes);

  private:
    property::Property bridged(const fettle_property& native);
    property::Method bridged(const fettle_method& native);
    void write_tags();
    void destroy(property::Handle self, property::Row row);
    /// True if the same module makes the rows of the class `base`.
    bool makes_rows_of(const property::Class& base) const;
    static property::Lifecycle lifecycle_of(const fettle_class& native, BridgedClass& self);

    HostTable& host_;
    fettle_class native_{};
    Named named_{};
    const property::Class* declared_ = nullptr;
    std::deque<BridgedProperty> properties_;  // deques: the tree keeps pointers to the elements
    std::deque<BridgedMethod> methods_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> instances_;  // index, generation
    bool abandoned_ = false;
};

}  // namespace fettle::module
