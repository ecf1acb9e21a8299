#include <collision/extreme_points.h>

namespace fettle::physics::detail {
namespace {

/// True if u comes before v, counted counter-clockwise from `base`.
bool turned_less(Vec2 base, Vec2 u, Vec2 v) {
    const auto half = [base](Vec2 w) {
        const float k = cross(base, w);
        return k < 0.0f || (k == 0.0f && dot(base, w) < 0.0f);
    };
    const bool far_u = half(u), far_v = half(v);
    return far_u != far_v ? far_v : cross(u, v) > 0.0f;
}

}  // namespace

int farthest_vertex(const Convex& polygon, Vec2 direction) {
    const int n = polygon.count;
    int vertex = 0;
    float most = dot(direction, polygon.vertices[0]);
    if (n <= most_small_vertices) {
        for (int i = 1; i < n; ++i) {
            const float d = dot(direction, polygon.vertices[i]);
            if (d > most) {
                most = d;
                vertex = i;
            }
        }
        return vertex;
    }
    // Vertex i is farthest for directions from the normal of edge i - 1 to that of edge i.
    int low = 0, high = n;  // the first edge whose normal is not before the direction
    while (low < high) {
        const int middle = (low + high) / 2;
        if (turned_less(polygon.normals[0], polygon.normals[middle], direction))
            low = middle + 1;
        else
            high = middle;
    }
    vertex = low < n ? low : 0;
    // Rounding may cause an error of one vertex.
    most = dot(direction, polygon.vertices[vertex]);
    for (int way : {1, n - 1}) {
        for (int i = (vertex + way) % n, left = n; left > 0; i = (i + way) % n, --left) {
            const float d = dot(direction, polygon.vertices[i]);
            if (d <= most) break;
            most = d;
            vertex = i;
        }
    }
    return vertex;
}

}  // namespace fettle::physics::detail
