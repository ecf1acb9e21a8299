#pragma once
// The cells of a layer: a list of numbers, or a text in CSV or base64, which may be compressed.

#include <vector>

#include <fettle/maps/map.h>

#include "fields.h"

namespace fettle::maps {

/// The cell that a number in a file stands for: its upper four bits are flips.
Cell cell_of(std::uint32_t number);

/// Reads `width` × `height` cells from the member `data` of `place`. Throws Error(damaged) if there
/// are fewer or more.
std::vector<Cell> read_cells(const Place& place, const std::string& encoding,
                             const std::string& compression, int width, int height);

}  // namespace fettle::maps
