#pragma once
// Shadows: the last known values of what the simulation writes, and of what is derived, kept only
// for watched cells. The simulation tells nobody; comparing these few cells at the barrier finds
// what it did.

#include <unordered_map>
#include <vector>

#include <fettle/property/change.h>

#include "watchers.h"

namespace fettle::property {

class Shadows {
  public:
    /// Starts and stops shadowing cells of one instance, as its watchers want it now. Idempotent.
    void refresh(const Tree& tree, const Watchers& watchers, Handle instance);
    void forget(const Tree& tree, Handle instance);
    /// After a queued change of a cell: what it holds now is known.
    void update(Cell cell, const Value& value);
    bool holds(Cell cell) const { return places_.contains(cell); }
    std::size_t size() const { return places_.size(); }
    bool empty() const { return places_.empty(); }
    /// Whether an edit elsewhere may change any of them.
    bool any_derived() const { return derived_ != 0; }

    /// Compares, remembers, and hands over each cell that differs: (instance, property, old, new).
    /// Cells that only a step can change are looked at when `stepped`.
    template <class Found>
    void compare(const Tree& tree, bool stepped, Found found);

  private:
    struct Row {
        Handle instance;
        const Property* property;
        Value last;
    };
    struct Group {  // one property name: visited in the order of first watching
        Symbol property;
        bool only_stepped;
        std::vector<Row> rows;
    };
    struct Position {
        std::uint32_t group, row;
    };
    void add(const Tree& tree, Handle instance, const Property& property);
    void remove(Cell cell);

    std::vector<Group> groups_;
    std::unordered_map<Cell, Position, CellHash> places_;
    std::size_t derived_ = 0;  // cells
};

}  // namespace fettle::property

#include <fettle/property/tree.h>

namespace fettle::property {

template <class Found>
void Shadows::compare(const Tree& tree, bool stepped, Found found) {
    for (Group& group : groups_) {
        if (group.only_stepped && !stepped) continue;
        for (Row& row : group.rows) {
            Value now = tree.peek(row.instance, *row.property);
            if (now == row.last) continue;
            row.last.swap(now);
            found(row.instance, *row.property, now, row.last);
        }
    }
}

}  // namespace fettle::property
