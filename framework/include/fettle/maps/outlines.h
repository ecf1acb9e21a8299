#pragma once
// Merges the collision shapes of tiles into few outlines, so that nothing catches where two tiles
// meet.

#include <span>
#include <vector>

#include <fettle/maps/export.h>
#include <fettle/property/value.h>

FETTLE_MAPS_BEGIN

namespace fettle::maps {

using Outline = std::vector<property::Vec2>;

/// The outlines of the union of polygons that touch along their edges: common edges vanish, and
/// corners on a straight line too. A polygon is simple, its vertices clockwise or
/// counter-clockwise; one with fewer than three vertices or without area is skipped. The solid side
/// is to the left of each outline: outer outlines are counter-clockwise in a system with y up,
/// holes clockwise. Where two corners meet in a point, the outlines stay separate. Polygons that
/// overlap give outlines that cross. Coordinates are rounded to 1/256. Throws Error(out_of_range)
/// for coordinates of 4 000 000 and more.
std::vector<Outline> merged_outlines(std::span<const Outline> polygons);

}  // namespace fettle::maps

FETTLE_MAPS_END
