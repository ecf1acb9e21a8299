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

/// Finds the maximum of values in a cycle that has only one rising direction from the start. The
/// strides double while the value rises; then bisection searches the last stride. Values that are
/// not `within` are ignored.
template <class Value, class Within>
EdgeGap climb(int count, int start, Value&& value, Within&& within) {
    const auto at = [count](int i) { return ((i % count) + count) % count; };
    const auto of = [&](int i) { return value(at(i)); };
    float here = of(start);
    const float left = of(start - 1), right = of(start + 1);
    if (left <= here && right <= here) return {at(start), here};
    const int way = right > left ? 1 : -1;
    int low = start, high = start + way, stride = 1;
    here = max(left, right);
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
/// In small polygons all edges are examined; large ones are climbed. The separation rises from the
/// edge that faces any point of the shape to the maximum, which is within a quarter of a turn. Up
/// to there, the farthest vertices along the normals are on the near side of the nearest point.
/// Beyond it there may be another maximum, that of the far side.
template <class Polygon, class Nearest>
EdgeGap deepest_edge(const Polygon& polygon, Vec2 inside, Nearest&& nearest) {
    const auto separation = [&](int i) { return nearest(polygon.normal(i)) - polygon.offset(i); };
    if (polygon.count() > most_small_vertices) {
        const Vec2 towards = inside - polygon.middle();
        return climb(polygon.count(), polygon.farthest(towards), separation,
                     [&](int i) { return dot(polygon.normal(i), towards) >= 0.0f; });
    }
    EdgeGap best;
    for (int i = 0; i < polygon.count(); ++i) {
        const float s = separation(i);
        if (s > best.separation) best = {i, s};
    }
    return best;
}

/// The more opposed of the two edges at the vertex that is deepest along a normal.
int incident_edge_of(const auto& polygon, Vec2 normal) {
    const int vertex = polygon.farthest(-normal), before = polygon.previous(vertex);
    return dot(polygon.normal(before), normal) < dot(polygon.normal(vertex), normal) ? before
                                                                                     : vertex;
}

}  // namespace fettle::physics::detail
