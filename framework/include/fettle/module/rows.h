#pragma once
// The values that a module keeps for the instances of a class, one row each.

#include <cstddef>
#include <vector>

#include <fettle/module/export.h>
#include <fettle/property/class.h>

FETTLE_MODULE_BEGIN

namespace fettle::module {

/// Rows of ended instances are used again. A `T` has a member `self`, the handle of its instance.
/// `Store`: std::vector, or std::deque where rows must stay where they are in memory.
template <class T, template <class...> class Store = std::vector>
class Rows {
  public:
    property::Row add(property::Handle self) {
        property::Row row = static_cast<property::Row>(rows_.size());
        if (free_.empty()) {
            rows_.emplace_back();
        } else {
            row = free_.back();
            free_.pop_back();
        }
        rows_[row].self = self;
        return row;
    }
    void remove(property::Row row) {
        rows_[row] = {};
        free_.push_back(row);
    }
    T& operator[](property::Row row) { return rows_[row]; }
    const T& operator[](property::Row row) const { return rows_[row]; }
    auto begin() { return rows_.begin(); }
    auto end() { return rows_.end(); }
    auto begin() const { return rows_.begin(); }
    auto end() const { return rows_.end(); }

  private:
    Store<T> rows_;
    std::vector<property::Row> free_;
};

}  // namespace fettle::module

FETTLE_MODULE_END
