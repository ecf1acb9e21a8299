#pragma once
// The shortest way over the cells of a grid.

#include <functional>
#include <optional>
#include <vector>

namespace fettle::visuals {

struct CellPlace {
    int x = 0, y = 0;
    bool operator==(const CellPlace&) const = default;
};

/// The cells from the one after `from` to `to`; nullopt if there is no way, or if it is not found
/// in the first 250 000 cells. `is_free`: whether the cell is in the grid and not solid; `from`
/// need not be free. With `diagonals`, a step may also lead over a corner if both cells beside it
/// are free.
std::optional<std::vector<CellPlace>> shortest_way(CellPlace from, CellPlace to, bool diagonals,
                                                   const std::function<bool(CellPlace)>& is_free);

}  // namespace fettle::visuals
