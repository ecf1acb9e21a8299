#pragma once
// A tree that stands in for that of a game in a trial: it has the same classes, instances and
// values, but none of the game's code.
//
// A property is a value that can be read and written. A method changes nothing and returns the
// defaults of what it returns. So a module that is tried out finds everything that it looks for by
// name.

#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include <fettle/property/tree.h>

#include "../bridge/class_bridge.h"
#include "stand_in_values.h"
#include "tree_description.h"

namespace fettle::module {

class StandIn {
  public:
    /// Fills `tree`, which it must outlive. The classes of the module that is reloaded are
    /// registered with `host` and added to `reloaded`. Throws property::Error.
    StandIn(property::Tree& tree, const TreeDescription& from, HostTable& host,
            std::vector<std::unique_ptr<BridgedClass>>& reloaded);
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

  private:
    void define(const ClassDescription& from);
    std::unique_ptr<BridgedClass> bridge(const ClassDescription& from, HostTable& host);
    void make_instances(const std::vector<InstanceDescription>& from);
    void set_values(const InstanceDescription& from, property::Handle to);
    void set_value(property::Handle to, const property::Property& property,
                   const property::Value& value, bool overridden);
    /// The value with references to the instances of this tree.
    property::Value translated(const property::Value& value) const;

    property::Tree& tree_;
    StandInRows rows_;
    std::deque<StandInValues> values_;  // deques: the tree keeps pointers to the elements
    std::deque<StandInAnswer> answers_;
    std::unordered_map<const void*, StandInValues*> by_context_;   // of a binding
    std::unordered_map<std::uint64_t, property::Handle> handles_;  // by the key in the game
};

}  // namespace fettle::module
