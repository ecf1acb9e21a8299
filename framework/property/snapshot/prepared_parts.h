#pragma once
// The data that the parts of a snapshot have read and will put into place.

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

#include <fettle/property/snapshot.h>

#include <tree/state.h>

namespace fettle::property {

/// A restore calls lifecycle functions, which may destroy parts. So `Tree::remove_part` drops the
/// data of the removed part here.
class PreparedParts {
  public:
    explicit PreparedParts(SnapshotState& snapshots) : snapshots_(snapshots) {
        snapshots_.prepared.push_back(this);
    }
    ~PreparedParts() { std::erase(snapshots_.prepared, this); }
    PreparedParts(const PreparedParts&) = delete;

    void add(SnapshotPart* part, std::function<void()> put) {
        const auto& there = snapshots_.parts;
        if (std::find(there.begin(), there.end(), part) == there.end())
            return;  // the part has removed itself
        all_.emplace_back(part, std::move(put));
    }
    void forget(const SnapshotPart* part) {
        for (auto& [of, put] : all_)
            if (of == part) of = nullptr, put = nullptr;
    }
    /// The functions should not throw. If one does, the first exception goes into `problem`, and
    /// the other functions are still called.
    void put_all(std::exception_ptr& problem) {
        for (auto& entry : all_) {
            // The function may remove its own part.
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
