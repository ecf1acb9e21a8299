#pragma once
// A class that a module described in C, as the tree knows it.
//
// The tree's descriptors hold functions and a context. The context of a bridged member is one of
// the structures below, which holds the module's own function and context. So a module that is
// taken in anew needs no change in the tree: its new functions are put where the old ones were.

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
    bool gone = false;  // the module as it is now has it no more
};

struct BridgedMethod {
    HostTable* host = nullptr;
    const property::Method* declared = nullptr;
    fettle_method native{};
    bool gone = false;
};

class BridgedClass {
  public:
    /// Registers the class with the host's tree. Throws property::Error.
    BridgedClass(HostTable& host, const fettle_class& native);
    BridgedClass(const BridgedClass&) = delete;
    BridgedClass& operator=(const BridgedClass&) = delete;

    const property::Class& declared() const { return *declared_; }
    /// Snapshots have its rows from the module, not value by value.
    bool saved_natively() const { return (native_.flags & FETTLE_SAVED_NATIVELY) != 0; }
    /// Those that the module has a row for, also instances of classes that derive from this one.
    const std::set<std::pair<std::uint32_t, std::uint32_t>>& instances() const {
        return instances_;
    }
    /// Of an instance that the tree has already: its row in the module, as when it was made.
    void revive(property::Handle self);
    /// Ends the row and leaves the instance.
    void retire(property::Handle self);
    /// After a snapshot was restored: instances have come back and gone without being made.
    void recount();
    /// The bridged property behind a declared one; null when it is none of this class.
    const BridgedProperty* find(const property::Property& declared) const;
    /// No function of the module is called any more.
    void abandon();

    /// From now on the module's new functions are called. What the new one does not have any more
    /// reads as its default and refuses to be written; what it has in addition is added to `notes`,
    /// as is what is gone. Throws std::runtime_error when a property has changed its type or the
    /// class its base.
    void replace(const fettle_class& native, std::vector<std::string>& notes);

  private:
    fettle_row create(property::Handle self);
    property::Property bridged(const fettle_property& native);
    property::Method bridged(const fettle_method& native);
    void write_tags();
    static property::Lifecycle lifecycle_of(const fettle_class& native, BridgedClass& self);

    HostTable& host_;
    fettle_class native_{};
    const property::Class* declared_ = nullptr;
    std::deque<BridgedProperty> properties_;  // contexts: they stay where they are
    std::deque<BridgedMethod> methods_;
    std::set<std::pair<std::uint32_t, std::uint32_t>> instances_;  // index, generation
    bool abandoned_ = false;
};

}  // namespace fettle::module
