#pragma once
// What is still known of instances that were deleted.

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

class Graves {
  public:
    /// The latest deletions; older ones are forgotten.
    static constexpr std::size_t most = 8192;

    void add(Tombstone gone) {
        latest_.push_back(std::move(gone));
        if (latest_.size() > most) latest_.pop_front();
    }
    /// nullptr where the instance lives, or was deleted too long ago.
    const Tombstone* find(Handle handle) const {
        const auto found = std::find_if(latest_.rbegin(), latest_.rend(),
                                        [&](const Tombstone& t) { return t.handle == handle; });
        return found == latest_.rend() ? nullptr : &*found;
    }

  private:
    std::deque<Tombstone> latest_;
};

}  // namespace fettle::property
