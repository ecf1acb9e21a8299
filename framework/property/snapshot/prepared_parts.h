#pragma once
// What the parts of a snapshot have read and are to put into place.

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

#include <fettle/property/snapshot.h>

#include <tree/state.h>

namespace fettle::property {

/// While it lives, `Tree::remove_part` takes out of it what it holds of a part that is removed:
/// lifecycle functions, which a restore calls meanwhile, may destroy parts.
class PreparedParts {
  public:
    explicit PreparedParts(SnapshotState& snapshots) : snapshots_(snapshots) {
        snapshots_.prepared.push_back(this);
    }
    ~PreparedParts() { std::erase(snapshots_.prepared, this); }
    PreparedParts(const PreparedParts&) = delete;

    void add(SnapshotPart* part, std::function<void()> put) {
        const auto& there = snapshots_.parts;
        if (std::find(there.begin(), there.end(), part) == there.end()) return;  // removed itself
        all_.emplace_back(part, std::move(put));
    }
    void forget(const SnapshotPart* part) {
        for (auto& [of, put] : all_)
            if (of == part) of = nullptr, put = nullptr;
    }
    /// Each is to throw nothing. What one throws nevertheless is kept, the first of it, and the
    /// others are put into place all the same.
    void put_all(std::exception_ptr& problem) {
        for (auto& entry : all_) {
            // It may remove its part.
            const std::function<void()> put = std::exchange(entry.second, {});
            if (!put) continue;
            try {
                put();
            } catch (...) {
                if (!problem) problem = std::current_exception();
            }
        }
    }

  private:
    SnapshotState& snapshots_;
    std::vector<std::pair<SnapshotPart*, std::function<void()>>> all_;
};

}  // namespace fettle::property
