#pragma once

#include <cstddef>
#include <cstdint>

#include <fettle/property/symbol.h>

namespace fettle::property {

/// A cell: one property of one instance. It is identified by name, so a class may redeclare the
/// property.
struct Cell {
    std::uint32_t index = 0;
    Symbol property;
    friend bool operator==(const Cell&, const Cell&) = default;
};

struct CellHash {
    std::size_t operator()(const Cell& cell) const noexcept {
        return (std::uint64_t{cell.index} << 32 | cell.property.id()) * 0x9e3779b97f4a7c15u >> 13;
    }
};

}  // namespace fettle::property
