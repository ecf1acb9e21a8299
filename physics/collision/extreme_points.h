#pragma once

#include <collision/manifold.h>

// Searches for extreme points and edges of a convex polygon. Its normals are sorted by angle, so
// the searches do not examine all of it.

namespace fettle::physics::detail {

/// In polygons with at most this many vertices all are examined; larger ones are searched.
inline constexpr int most_small_vertices = 8;

/// The vertex that is farthest along a direction, by bisection.
int farthest_vertex(const Convex& polygon, Vec2 direction);

/// An edge, and the distance of a point or shape outside of it, m.
struct EdgeGap {
    int edge = 0;
    float separation = -1e30f;
};

/// Finds the maximum of values in a cycle that rise in one direction from `start` to it. The
/// strides double while the value rises; then bisection searches the last stride. Values that are
/// not `within` are ignored. `way`: 1 or -1; the value after `start` is higher.
template <class Value, class Within>
EdgeGap climb(int count, int start, int way, Value&& value, Within&& within) {
    const auto at = [count](int i) { return ((i % count) + count) % count; };
    const auto of = [&](int i) { return value(at(i)); };
    int low = start, high = start + way, stride = 1;
    float here = of(high);
    while (stride < count) {
        const int ahead = high + way * stride;
        const float then = within(at(ahead)) ? of(ahead) : here;
        if (then <= here) break;
        low = high;
        high = ahead;
        here = then;
        stride *= 2;
    }
    // The maximum is between low and one stride after high.
    int a = low, b = high + way * stride;
    while ((b - a) * way > 2) {
        const int middle = a + (b - a) / 2;
        if (within(at(middle + way)) && of(middle) < of(middle + way))
            a = middle;
        else
            b = middle + way;
    }
    EdgeGap best;
    for (int i = a;; i += way) {
        const float v = of(i);
        if (v > best.separation) best = {at(i), v};
        if (i == b) return best;
    }
}

/// The higher of the maxima on both sides of `start`. A flat polygon may have a maximum on each of
/// its long sides, with lower values at the tip between them.
template <class Value, class Within>
EdgeGap climb(int count, int start, Value&& value, Within&& within) {
    EdgeGap best = {start, value(start)};
    const float first = best.separation;
    for (const int way : {-1, 1}) {
        const int next = (start + way + count) % count;
        if (!within(next) || !(value(next) > first)) continue;
        const EdgeGap found = climb(count, start, way, value, within);
        if (found.separation > best.separation) best = found;
    }
    return best;
}

/// A convex polygon with its vertices in memory, for `deepest_edge`.
class Facets {
  public:
    explicit Facets(const Convex& form) : form_(form) {}

    int count() const { return form_.count; }
    float offset(int edge) const { return form_.offsets[edge]; }
    Vec2 normal(int edge) const { return form_.normals[edge]; }
    Vec2 middle() const { return 0.5f * (form_.vertices[0] + form_.vertices[form_.count / 2]); }
    int previous(int i) const { return i > 0 ? i - 1 : form_.count - 1; }
    int farthest(Vec2 direction) const { return farthest_vertex(form_, direction); }

  private:
    const Convex& form_;
};

/// The edge of a polygon with the greatest separation from another shape. `nearest` returns the
/// coordinate of the shape's nearest point along a unit vector, `inside` is a point of the shape.
/// In small polygons all edges are examined; large ones are climbed. Where an edge separates them,
/// the separation rises from every such edge to the maximum. Where the climb finds none, there may
/// still be one, because a flat polygon has several maxima below zero: then edges all around are
/// examined, and the climb begins again from the best of them.
template <class Polygon, class Nearest>
EdgeGap deepest_edge(const Polygon& polygon, Vec2 inside, Nearest&& nearest) {
    const auto separation = [&](int i) { return nearest(polygon.normal(i)) - polygon.offset(i); };
    const int count = polygon.count();
    EdgeGap best;
    const auto examine = [&](int i) {
        const float s = separation(i);
        if (s > best.separation) best = {i, s};
    };
    if (count <= most_small_vertices) {
        for (int i = 0; i < count; ++i) examine(i);
        return best;
    }
    const Vec2 towards = inside - polygon.middle();
    best = climb(count, polygon.farthest(towards), separation,
                 [&](int i) { return dot(polygon.normal(i), towards) >= 0.0f; });
    if (best.separation > 0.0f) return best;
    constexpr int most_examined = 24;
    const float found = best.separation;
    const int stride = (count + most_examined - 1) / most_examined;
    for (int i = 0; i < count; i += stride) examine(i);
    if (stride > 1 && best.separation > found)
        best = climb(count, best.edge, separation, [](int) { return true; });
    return best;
}

/// The more opposed of the two edges at the vertex that is deepest along a normal.
int incident_edge_of(const auto& polygon, Vec2 normal) {
    const int vertex = polygon.farthest(-normal), before = polygon.previous(vertex);
    return dot(polygon.normal(before), normal) < dot(polygon.normal(vertex), normal) ? before
                                                                                     : vertex;
}

}  // namespace fettle::physics::detail
