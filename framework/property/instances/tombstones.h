#pragma once
// Tombstones: data of deleted instances, kept for error messages.

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include <fettle/property/change.h>

namespace fettle::property {

struct Tombstone {
    Handle handle;
    const Class* of = nullptr;
    std::string name;
    std::string path;
    Cause cause;
};

class Tombstones {
  public:
    /// Only the latest deletions are kept.
    static constexpr std::size_t max_count = 8192;

    void add(Tombstone gone) {
        latest_.push_back(std::move(gone));
        if (latest_.size() > max_count) latest_.pop_front();
    }
    /// nullptr if the instance lives or was deleted too long ago.
    const Tombstone* find(Handle handle) const {
        const auto found = std::find_if(latest_.rbegin(), latest_.rend(),
                                        [&](const Tombstone& t) { return t.handle == handle; });
        return found == latest_.rend() ? nullptr : &*found;
    }

  private:
    std::deque<Tombstone> latest_;
};

}  // namespace fettle::property
