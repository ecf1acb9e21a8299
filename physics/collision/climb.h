#pragma once

#include <collision/manifold.h>

// What is extreme of a convex polygon, without looking at all of it: its normals are in order.

namespace fettle::physics::detail {

/// Polygons of more vertices are searched; of these or fewer all are looked at.
inline constexpr int most_small_vertices = 8;

/// The vertex that is farthest along a direction, by bisection.
int farthest_vertex(const Convex& polygon, V2 direction);

/// An edge, and how far outside of it something is, m.
struct EdgeGap {
    int edge = 0;
    float separation = -1e30f;
};

/// The greatest value round a cycle in which there is one way up from where one starts: strides
/// that double while it rises, then bisection of the last. What is not `within` is not looked for.
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
    // The summit is between low and one stride beyond high.
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

/// A convex polygon whose vertices are at hand, as `deepest_edge` asks for it.
class Facets {
  public:
    explicit Facets(const Convex& form) : form_(form) {}

    int count() const { return form_.count; }
    float offset(int edge) const { return form_.offsets[edge]; }
    V2 normal(int edge) const { return form_.normals[edge]; }
    V2 middle() const { return 0.5f * (form_.vertices[0] + form_.vertices[form_.count / 2]); }
    int previous(int i) const { return i > 0 ? i - 1 : form_.count - 1; }
    int farthest(V2 direction) const { return farthest_vertex(form_, direction); }

  private:
    const Convex& form_;
};

/// The edge of a polygon that something is farthest outside of: `nearest` tells the coordinate of
/// its nearest point along a unit vector, `inside` is a point of it. All edges of few are looked
/// at, many are climbed. The separation from something apart rises from the edge that faces any
/// point of it to the greatest, which is within a quarter of a turn: up to there the vertices that
/// are farthest along the normals are on the near side of the nearest point. Behind there may be
/// another summit, that of the far side.
template <class Polygon, class Nearest>
EdgeGap deepest_edge(const Polygon& polygon, V2 inside, Nearest&& nearest) {
    const auto separation = [&](int i) { return nearest(polygon.normal(i)) - polygon.offset(i); };
    if (polygon.count() > most_small_vertices) {
        const V2 towards = inside - polygon.middle();
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

/// Of the two edges at the vertex that is deepest along a normal, the one that faces it more.
int incident_edge_of(const auto& polygon, V2 normal) {
    const int vertex = polygon.farthest(-normal), before = polygon.previous(vertex);
    return dot(polygon.normal(before), normal) < dot(polygon.normal(vertex), normal) ? before
                                                                                     : vertex;
}

}  // namespace fettle::physics::detail
