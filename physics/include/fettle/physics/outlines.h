#pragma once

#include <fettle/physics/definitions.h>
#include <fettle/physics/export.h>

#include <span>
#include <vector>

// Chains from drawings and grids.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// The direction of a closed chain, which decides on which side it is solid.
enum class Winding : uint8_t {
    as_given,          ///< the direction of its first line
    clockwise,         ///< an island: solid for bodies outside
    counter_clockwise  ///< a container: solid for bodies inside
};

/// How `join_lines` joins.
struct JoinOptions {
    float reach = 1e-3f;    ///< m; ends of lines that are nearer to each other are joined
    float straight = 0.0f;  ///< m; points this near to the line through the points that remain are
                            ///< dropped
    Winding closed = Winding::as_given;  ///< direction of closed chains
};

/// Joins lines, which may be in any order and direction, into as few chains as their ends allow. A
/// chain has the direction of the first of its lines, and is closed if its ends meet. Where more
/// than two ends meet, the nearest are joined; among equals the end that keeps the direction of its
/// line, then the earlier line. A line with less than two points, or a closed chain with less than
/// three, is dropped. Throws std::invalid_argument for a negative or infinite option, and for
/// coordinates beyond ±1e6 m.
[[nodiscard]] std::vector<Chain> join_lines(std::span<const std::vector<Vec2>> lines,
                                            const JoinOptions& options = {});

/// Drops points of a line that are at most `straight` (m) from the line through the points that
/// remain (the algorithm of Douglas and Peucker). Both ends of an open line remain.
[[nodiscard]] std::vector<Vec2> without_straight_points(std::span<const Vec2> points, bool closed,
                                                        float straight);

/// Where the samples of a grid are: sample (column, row) at `origin` + `cell` · (column, row).
struct GridLayout {
    uint32_t columns = 0;  ///< samples in a row
    uint32_t rows = 0;     ///< number of rows
    Vec2 origin = {};      ///< m
    float cell = 1.0f;     ///< m between two samples, positive
};

/// The outlines of the area where a grid of numbers (row after row) is above `threshold`, by
/// marching squares; between two samples the number changes linearly. The area outside of the grid
/// is empty: the outline passes half a cell beyond the last samples. All chains are closed:
/// clockwise around an area, counter-clockwise around a hole in it, so bodies collide with the
/// area. Where two areas meet at a corner, the mean of the four samples decides. Points on a
/// straight line are dropped as `join_lines` does. Throws std::invalid_argument if the number of
/// values is not columns · rows (at most 2^24), or if a value is not finite.
[[nodiscard]] std::vector<Chain> grid_outlines(std::span<const float> values,
                                               const GridLayout& layout, float threshold = 0.5f,
                                               float straight = 0.0f);
/// The same for cells that are filled or not.
[[nodiscard]] std::vector<Chain> grid_outlines(std::span<const bool> filled,
                                               const GridLayout& layout, float straight = 0.0f);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
