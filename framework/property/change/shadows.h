#pragma once
// Shadows: the last known values of what the simulation writes, and of what is derived, kept only
// for watched cells. The simulation tells nobody; comparing these few cells at the barrier finds
// what it did.

#include <unordered_map>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/tree.h>

#include <instances/instances.h>
#include <writes/writes_log.h>

#include "watchers.h"

namespace fettle::property {

/// One cell that changed by itself.
struct CellChange {
    Handle instance;
    const Property* property = nullptr;
    Value old_value, new_value;
};

class Shadows {
  public:
    /// `log`: writes go the long way while there are shadows.
    explicit Shadows(WritesLog& log) : log_(log) {}
    /// Starts and stops shadowing cells of one instance, as its watchers want it now. Idempotent.
    void refresh(const Tree& tree, const Watchers& watchers, Handle instance);
    void forget(const Tree& tree, Handle instance);
    /// Starts shadowing one cell, unless it is shadowed.
    void keep(const Tree& tree, Handle instance, const Property& property) {
        if (!holds({instance.index, property.symbol})) add(tree, instance, property);
    }
    void drop(Cell cell) { remove(cell); }
    /// After a queued change of a cell: what it holds now is known.
    void update(Cell cell, const Value& value);
    bool holds(Cell cell) const { return places_.contains(cell); }
    bool empty() const { return places_.empty(); }
    void clear();
    /// Whether an edit elsewhere may change any of them.
    bool any_derived() const { return derived_ != 0; }

    /// Compares, remembers, and returns each cell that differs. `step`: at which the simulation
    /// wrote them, 0 when an edit did.
    std::vector<CellChange> compare(const Instances& instances, std::uint64_t step);
    /// The step at which the simulation last changed the cell; 0 when it did not, or is not known
    /// to have, or an edit came after it.
    std::uint64_t simulated_at(Cell cell) const;

  private:
    struct Row {
        Handle instance;
        const Property* property;
        Value last;
        std::uint64_t step = 0;
    };
    struct Group {  // one property name: visited in the order of first watching
        Symbol property;
        std::vector<Row> rows;
    };
    struct Position {
        std::uint32_t group, row;
    };
    void add(const Tree& tree, Handle instance, const Property& property);
    void remove(Cell cell);

    WritesLog& log_;
    std::vector<Group> groups_;
    std::unordered_map<Cell, Position, CellHash> places_;
    std::size_t derived_ = 0;  // cells
};

}  // namespace fettle::property
