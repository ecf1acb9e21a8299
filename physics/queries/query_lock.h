#pragma once

#include <distance/distance.h>
#include <fettle/physics/query.h>
#include <geometry/kept_list.h>
#include <world/world_data.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace fettle::physics::detail {

/// Locks the world while a query may call `QueryFilter::accept` or a visitor.
class QueryLock {
  public:
    QueryLock(const WorldData& data, const QueryFilter& filter, bool visits = false) {
        if (visits || filter.accept)
            lock_.emplace(data.self, WorldLock::During::query, visits ? in_visitor : in_accept);
    }
    void finish() {
        if (lock_) lock_->finish();
    }

  private:
    std::optional<WorldLock> lock_;
};

/// True if the filter of a query accepts the shape.
bool is_accepted(const WorldData& data, const QueryFilter& filter, uint32_t shape);

/// Calls a visitor; returns true if the query continues.
template <class Found>
bool goes_on(const WorldData& data, const Visitor<Found>& visitor, const Found& found) {
    const bool going = visitor(found);
    if (data.self.orphaned()) data.self.throw_orphaned();
    return going;
}

/// Passes the shapes that a query finds to a visitor.
inline auto to_visitor(const WorldData& data, const Visitor<Shape>& visitor) {
    return [&](const Shape& shape) { return goes_on(data, visitor, shape); };
}

/// Adds the shapes that a query finds to a list.
inline auto to_list(std::vector<Shape>& list) {
    return [&list](const Shape& shape) {
        list.push_back(shape);
        return true;
    };
}

/// The shapes that a query has found, since parts of one may be found several times.
class FoundShapes {
  public:
    /// False if the shape was found before.
    bool add(ShapeId id) {
        if (std::find(ids_->begin(), ids_->end(), id) != ids_->end()) return false;
        ids_->push_back(id);
        return true;
    }

  private:
    KeptList<ShapeId> ids_;
};

/// A point as a shape.
struct PointForm {
    Vec2 zero;
    Solid form() const { return {{&zero, nullptr, nullptr, 1, 0.0f}}; }
};

}  // namespace fettle::physics::detail
