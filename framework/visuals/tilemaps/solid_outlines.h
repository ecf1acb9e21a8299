#pragma once
// The solid cells of a layer as few lines, so that nothing catches where two tiles meet.

#include <vector>

#include <tilemaps/grid.h>
#include <tilemaps/loaded_map.h>

namespace fettle::visuals {

/// Bodies stay on its left side.
struct SolidLine {
    std::vector<property::Vec2> points;  // px from the upper left corner of cell (0, 0), y up
    bool closed = false;
};

/// Throws Error(out_of_range) for cells that are more than 4 000 000 pixels away.
std::vector<SolidLine> solid_lines(const Grid& grid, const LoadedMap& map);

}  // namespace fettle::visuals
