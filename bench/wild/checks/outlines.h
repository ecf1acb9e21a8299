#pragma once
// Outlines of shapes and points deep in them, computed from the plan alone, so that checks do not
// rely on the collision code that they judge.

#include <optional>
#include <vector>

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// The front, where bodies may be, is on its left.
struct Edge {
    Vec2 from = {};
    Vec2 to = {};
};

struct Outline {
    enum class Kind {
        solid,     // closed, with an inside
        line,      // stops bodies on both sides
        one_sided  // stops bodies on its left
    };
    Kind kind = Kind::solid;
    std::vector<Edge> edges;  // body coordinates, without rounding
    Aabb box;
};
Outline outline_of(const Geometry& geometry);

/// A convex part of a shape: a point deep in it, and how deep that is.
struct Core {
    Vec2 point = {};  // body coordinates
    float depth = 0;  // distance to the nearest edge, m
};
std::vector<Core> cores_of(const Geometry& geometry);

float distance_to(const Edge& edge, const Vec2& point);

/// How the line from p to q crosses an edge: 1 from its front, -1 from behind, 0: not at all.
int crossing(const Edge& edge, const Vec2& p, const Vec2& q);
/// How much of a way from p to q that crosses the line of an edge lies before it, 0 to 1.
float part_of_way(const Edge& edge, const Vec2& p, const Vec2& q);

}  // namespace fettle::bench::wild
