#pragma once
// Shadows: the last known values of cells that the simulation writes and of derived cells. The
// simulation does not announce its writes; they are found at the barrier by comparing the cells
// with their shadows. Only watched cells have shadows.

#include <unordered_map>
#include <vector>

#include <fettle/property/change.h>
#include <fettle/property/tree.h>

#include <instances/instances.h>
#include <writes/writes_log.h>

#include "watchers.h"

namespace fettle::property {

/// One cell that changed without an edit.
struct CellChange {
    Handle instance;
    const Property* property = nullptr;
    Value old_value, new_value;
};

class Shadows {
  public:
    /// `log`: while there are shadows, writes do not take the shortest path.
    explicit Shadows(WritesLog& log) : log_(log) {}
    /// Adds and removes shadows of one instance as its watchers need them now. Idempotent.
    void refresh(const Tree& tree, const Watchers& watchers, Handle instance);
    void forget(const Tree& tree, Handle instance);
    /// Adds a shadow of one cell unless it has one.
    void keep(const Tree& tree, Handle instance, const Property& property) {
        if (!holds({instance.index, property.symbol})) add(tree, instance, property);
    }
    void drop(Cell cell) { remove(cell); }
    /// Sets the shadow to the value of a change that is already queued.
    void update(Cell cell, const Value& value);
    bool holds(Cell cell) const { return places_.contains(cell); }
    bool empty() const { return places_.empty(); }
    void clear();
    /// Whether any of the cells may change because another cell is edited.
    bool any_derived() const { return derived_ != 0; }

    /// Returns each cell that differs from its shadow, and updates the shadow. `step`: the step at
    /// which the simulation wrote the cells; 0 if an edit changed them.
    std::vector<CellChange> compare(const Instances& instances, std::uint64_t step);
    /// The step at which the simulation last changed the cell. 0 if it is unknown, or if an edit
    /// came later.
    std::uint64_t simulated_at(Cell cell) const;

  private:
    struct Row {
        Handle instance;
        const Property* property;
        Value last;
        std::uint64_t step = 0;
    };
    struct Group {  // cells with one property name, in the order of their first watcher
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
    std::size_t derived_ = 0;  // number of derived cells
};

}  // namespace fettle::property
