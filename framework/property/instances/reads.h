#pragma once
// Reads during the run of a formula. The formula depends on all of them.

#include <utility>
#include <vector>

#include <fettle/property/class.h>

#include "cell.h"

namespace fettle::property {

/// A read of a value, of a name, or of `Reads::structure`.
struct Read {
    Cell cell;
    Handle instance{};
    const Property* property = nullptr;  // null for a name
};

class Reads {
  public:
    /// Stands for the structure of the tree: it changes when an instance is created, deleted or
    /// moved.
    static const Cell structure;

    /// Whether a formula runs, so that reads are noted.
    bool noted() const { return list_ != nullptr; }
    /// From now on reads are appended to `list`; nullptr: they are not noted. Returns the previous
    /// list.
    std::vector<Read>* note_in(std::vector<Read>* list) { return std::exchange(list_, list); }

    void note_value(Handle instance, const Property& property) const {
        if (noted()) [[unlikely]]
            add({instance.index, property.symbol}, instance, &property);
    }
    /// Notes a look-up of a name, also one that finds nothing.
    void note_name(Handle instance, Symbol name) const {
        if (noted()) [[unlikely]]
            add({instance.index, name}, instance);
    }
    void note_structure() const {
        if (noted()) [[unlikely]]
            add(structure);
    }

  private:
    // Not inline, so that reads outside of formulas stay short.
    void add(Cell cell, Handle instance = {}, const Property* property = nullptr) const;

    std::vector<Read>* list_ = nullptr;
};

}  // namespace fettle::property
