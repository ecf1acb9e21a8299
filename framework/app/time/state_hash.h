#pragma once
// A hash of the state of a game. It is equal in runs with the same state.

#include <cstdint>
#include <string_view>

#include <fettle/property/tree.h>

namespace fettle::app {

class StateHash {
  public:
    void add(std::uint64_t bits);
    void add(double number);
    void add(std::string_view text);
    void add(const property::Value& value, const property::Tree& tree);
    /// Adds the instances in the order of the tree, with names, classes, and all saved values that
    /// the tree itself stores. Modules hash their own values; services are skipped, except for
    /// their ad hoc properties.
    void add_stored_values(const property::Tree& tree);
    std::uint64_t result() const { return state_; }

  private:
    std::uint64_t state_ = 0x9e3779b97f4a7c15u;
};

}  // namespace fettle::app
