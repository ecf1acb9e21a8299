#pragma once
// Begin events that were not delivered, or not to all watchers, because an instance in them was
// deleted first. Those watchers do not get the end event either, so that a script that counts
// begins and ends stays correct.

#include <cstddef>
#include <optional>
#include <vector>

#include <fettle/property/change.h>

namespace fettle::property {

class Tree;

/// Whether a value is a deleted instance or a list with one.
bool names_deleted(const Tree& tree, const Value& value);

class UndeliveredBegins {
  public:
    /// How far a begin event came before an instance in it was deleted.
    struct Reached {
        std::size_t watchers = 0;   ///< number of its watchers
        std::size_t delivered = 0;  ///< number of those that got it, the first ones

        /// Whether watcher number `i` of `all`, to the end event, is for it. A script with a
        /// watcher of the end for each one of the begin registers them in the same order.
        bool is_for(std::size_t i, std::size_t all) const {
            return all == watchers ? i < delivered : delivered > 0;
        }
    };
    void note(const Tree& tree, const Occurrence& beginning, const Reached& reached);
    /// If `end` is the end of an event in this list, that event is removed from it, and the result
    /// says how far it came.
    std::optional<Reached> take(const Occurrence& end);
    void clear() { list_.clear(); }

  private:
    struct Undelivered {
        Handle instance;
        const Event* event;
        std::vector<Value> names;  // values of the fields that the end event has as well
        Reached reached;
    };
    std::vector<Undelivered> list_;
};

}  // namespace fettle::property
