#pragma once
// The instances that were made since the last barrier.

#include <cstdint>
#include <unordered_set>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::property {

class FreshInstances {
  public:
    bool empty() const { return in_order_.empty(); }
    bool contains(Handle instance) const { return keys_.contains(instance.key()); }
    void add(Handle instance) {
        if (keys_.insert(instance.key()).second) in_order_.push_back(instance);
    }
    /// False if it is not one of them.
    bool remove(Handle instance) {
        if (keys_.erase(instance.key()) == 0) return false;
        if (keys_.empty()) in_order_.clear();
        return true;
    }
    /// In the order in which they were made. Some may be deleted.
    const std::vector<Handle>& in_order() const { return in_order_; }
    void clear() {
        in_order_.clear();
        keys_.clear();
    }

  private:
    std::vector<Handle> in_order_;
    std::unordered_set<std::uint64_t> keys_;
};

}  // namespace fettle::property
