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
    /// Only the latest deletions are kept: fewer if their names and paths are long, since a path
    /// may have a million characters.
    static constexpr std::size_t max_count = 8192;
    static constexpr std::size_t max_bytes = std::size_t{16} << 20;

    void add(Tombstone gone) {
        bytes_ += bytes_of(gone);
        latest_.push_back(std::move(gone));
        while (latest_.size() > max_count || (bytes_ > max_bytes && latest_.size() > 1)) {
            bytes_ -= bytes_of(latest_.front());
            latest_.pop_front();
        }
    }
    /// nullptr if the instance lives or was deleted too long ago.
    const Tombstone* find(Handle handle) const {
        const auto found = std::find_if(latest_.rbegin(), latest_.rend(),
                                        [&](const Tombstone& t) { return t.handle == handle; });
        return found == latest_.rend() ? nullptr : &*found;
    }

  private:
    static std::size_t bytes_of(const Tombstone& gone) {
        return gone.name.size() + gone.path.size();
    }

    std::deque<Tombstone> latest_;
    std::size_t bytes_ = 0;
};

}  // namespace fettle::property
