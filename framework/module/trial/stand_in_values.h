#pragma once
// The values and results of a class whose module is not there.

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <fettle/property/tree.h>

#include "../bridge/c_values.h"

namespace fettle::module {

/// The rows of all instances.
struct StandInRows {
    property::Row last = 0;
};

/// The values of a property that the tree does not store, by row; of one that belongs to the
/// structure of the tree, by `Handle::key`.
struct StandInValues {
    property::Value default_value;  // of rows without an entry in `all`
    std::unordered_map<std::uint64_t, property::Value> all;
    std::unordered_set<std::uint64_t> overridden;
    // Only of a column in C: the memory of all rows.
    std::size_t cell_size = 0;
    std::vector<std::byte> cells;
    const StandInRows* rows = nullptr;
    Outgoing outgoing;  // keeps the last value that was given to C

    /// The context of a binding.
    static StandInValues& in(void* context) { return *static_cast<StandInValues*>(context); }

    const property::Value& at(std::uint64_t key) const;
    void set(std::uint64_t key, const property::Value& value);
    void reset(std::uint64_t key);
    std::byte* column();
};

/// The result of a method that nothing computes.
struct StandInAnswer {
    std::vector<property::Field> returns;
    bool many = false;
    Outgoing outgoing;

    /// The defaults of its fields. A reference refers to a new instance of its class, so that the
    /// module can go on with it. `this` must outlive the result.
    property::Result get(property::Tree& tree) const;
};

}  // namespace fettle::module
