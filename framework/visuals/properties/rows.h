#pragma once
// The values that a class computes for its instances, one row each. Rows of ended instances are
// used again.

#include <cstddef>
#include <vector>

#include <fettle/property/class.h>

namespace fettle::visuals {

/// A `T` has a member `self`, the handle of its instance.
template <class T>
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
    std::vector<T> rows_;
    std::vector<property::Row> free_;
};

}  // namespace fettle::visuals
