#pragma once

#include <distance/distance.h>
#include <fettle/physics/query.h>
#include <world/world_data.h>

#include <optional>

namespace fettle::physics::detail {

/// Locks the world while a query may call `QueryFilter::accept`.
class Asking {
  public:
    Asking(const WorldData& data, const QueryFilter& filter) {
        if (filter.accept) lock_.emplace(data.self, WorldLock::During::query, in_accept);
    }
    void finish() {
        if (lock_) lock_->finish();
    }

  private:
    std::optional<WorldLock> lock_;
};

/// Whether the filter of a query accepts the shape.
bool is_accepted(const WorldData& data, const QueryFilter& filter, uint32_t shape);

/// A point as a shape.
struct PointForm {
    Vec2 zero;
    Solid form() const { return {{&zero, nullptr, nullptr, 1, 0.0f}}; }
};

}  // namespace fettle::physics::detail
