// The time at which a moving shape reaches an obstacle.

#include <collision/turned_copy.h>
#include <distance/distance.h>
#include <geometry/trigonometry.h>

namespace fettle::physics::detail {
namespace {

/// Smallest squared distance from the vertices of `points` to the edges of `shape`.
float vertices_to_edges(const Convex& points, const Convex& shape, V2 to_shape) {
    float least = 1e30f;
    for (int i = 0; i < points.count; ++i) {
        const V2 p = points.vertices[i] - to_shape;
        for (int k = 0; k < shape.count; ++k) {
            const int next = k + 1 < shape.count ? k + 1 : 0;
            least =
                min(least, squared_distance_to_edge(shape.vertices[k], shape.vertices[next], p));
        }
    }
    return least;
}

/// True if no edge normal of `a` separates b from it.
bool no_axis_between(const Convex& a, const Convex& b, V2 offset) {
    for (int i = 0; i < a.count && a.count > 1; ++i) {
        float nearest = 1e30f;
        for (int k = 0; k < b.count; ++k)
            nearest = min(nearest, dot(a.normals[i], b.vertices[k] + offset));
        if (nearest > a.offsets[i]) return false;
    }
    return true;
}

}  // namespace

float distance(const Convex& a, const Convex& b, V2 offset) {
    // Fast bodies are rare: a loop over all vertices and edges is short and exact.
    const bool solid = a.count > 2 || b.count > 2;
    if (solid && no_axis_between(a, b, offset) && no_axis_between(b, a, -offset)) return 0.0f;
    const float squared = min(vertices_to_edges(a, b, offset), vertices_to_edges(b, a, -offset));
    return max(0.0f, std::sqrt(squared) - a.radius - b.radius);
}

namespace {

/// The distance of a shape from an obstacle, and the unit vector to it; zero if they overlap.
struct Gap {
    float distance = 0.0f;
    V2 direction;
};

/// B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, section 2.3: no
/// point of the shape approaches the obstacle faster than the center of mass and the rotation
/// together, so the shape cannot reach the obstacle before it has moved by the distance. `gap_at`
/// measures the gap of a rotated copy of the shape with the center of mass at a point.
template <class GapAt>
float advance(const Sweep& sweep, float gap, GapAt&& gap_at) {
    const float spin = std::fabs(sweep.turn) * sweep.extent;
    TurnedCopy copy(sweep.end);
    float t = 0.0f;
    for (int round = 0; round < 32; ++round) {
        const Rotation back = rotation_of(double(sweep.turn) * double(t - 1.0f));
        const Gap found = gap_at(copy.by(back), sweep.start + t * sweep.shift);
        if (found.distance <= gap) return t;
        const float speed = max(dot(sweep.shift, found.direction), 0.0f) + spin;
        if (!(speed > 0.0f)) return 1.0f;
        t += (found.distance - 0.5f * gap) / speed;
        if (t >= 1.0f) return 1.0f;
    }
    return t;
}

}  // namespace

float time_of_impact(const Sweep& sweep, const Solid& obstacle, V2 center, float gap) {
    return advance(sweep, gap, [&](const Solid& shape, V2 at) {
        const Nearest found = nearest_points(shape, obstacle, center - at);
        return Gap{found.distance, found.normal};
    });
}

float time_of_impact(const Sweep& sweep, V2 normal, float depth, float gap) {
    return advance(sweep, gap, [&](const Solid& shape, V2 at) {
        return Gap{dot(normal, at) - reach(shape, -normal) - depth, -normal};
    });
}

}  // namespace fettle::physics::detail
