#pragma once

#include <geometry/vector.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fettle::physics::detail {

/// m², positive for counter-clockwise outlines.
double signed_area(std::span<const Vec2> outline);

/// The reason why these points are not a simple polygon: which edges cross or touch, and where;
/// nullopt if they are one. Vertices are numbered from 1; an edge is named by its two vertices.
std::optional<std::string> outline_problem(std::span<const Vec2> outline);

/// Divides a simple counter-clockwise polygon along diagonals into few convex ones. Returns the
/// vertices of each, as indices, counter-clockwise. No vertex is added.
std::vector<std::vector<uint32_t>> convex_pieces(std::span<const Vec2> outline);

}  // namespace fettle::physics::detail
