#pragma once

#include <distance/distance.h>
#include <fettle/physics/query.h>
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

/// The shapes that a query has found, since parts of one may be found several times. They lie in
/// memory of the thread, above those of the query whose visitor makes this one.
class FoundShapes {
  public:
    FoundShapes() : begin_(ids().size()) {}
    ~FoundShapes() { ids().resize(begin_); }
    FoundShapes(const FoundShapes&) = delete;
    FoundShapes& operator=(const FoundShapes&) = delete;
    /// False if the shape was found before.
    bool add(ShapeId id) {
        std::vector<ShapeId>& all = ids();
        if (std::find(all.begin() + ptrdiff_t(begin_), all.end(), id) != all.end()) return false;
        all.push_back(id);
        return true;
    }

  private:
    static std::vector<ShapeId>& ids() {
        thread_local std::vector<ShapeId> all;
        return all;
    }
    size_t begin_;
};

/// A point as a shape.
struct PointForm {
    Vec2 zero;
    Solid form() const { return {{&zero, nullptr, nullptr, 1, 0.0f}}; }
};

}  // namespace fettle::physics::detail
