#pragma once
// What is read while a formula runs. The formula depends on all of it.

#include <utility>
#include <vector>

#include <fettle/property/class.h>

#include "cell.h"

namespace fettle::property {

/// A value, a name, or `Reads::structure`.
struct Read {
    Cell cell;
    Handle instance{};
    const Property* property = nullptr;  // of a value
};

class Reads {
  public:
    /// Stands for all instances together: it changes when one comes, goes or moves.
    static const Cell structure;

    /// Whether a formula runs.
    bool noted() const { return list_ != nullptr; }
    /// From now on reads are appended to `list`; nullptr: they are not noted. Returns the list
    /// before.
    std::vector<Read>* note_in(std::vector<Read>* list) { return std::exchange(list_, list); }

    void note_value(Handle instance, const Property& property) const {
        if (noted()) [[unlikely]]
            add({instance.index, property.symbol}, instance, &property);
    }
    /// What a name stands for, also "nothing".
    void note_name(Handle instance, Symbol name) const {
        if (noted()) [[unlikely]]
            add({instance.index, name}, instance);
    }
    void note_structure() const {
        if (noted()) [[unlikely]]
            add(structure);
    }

  private:
    // A call, so that reads outside of formulas stay short.
    void add(Cell cell, Handle instance = {}, const Property* property = nullptr) const;

    std::vector<Read>* list_ = nullptr;
};

}  // namespace fettle::property
