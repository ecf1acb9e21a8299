// The time at which a moving shape reaches an obstacle.

#include <collision/turned_copy.h>
#include <distance/distance.h>
#include <geometry/trigonometry.h>

namespace fettle::physics::detail {
namespace {

/// Smallest squared distance from the vertices of `points` to the edges of `shape`.
float vertices_to_edges(const Convex& points, const Convex& shape, Vec2 to_shape) {
    float least = 1e30f;
    for (int i = 0; i < points.count; ++i) {
        const Vec2 p = points.vertices[i] - to_shape;
        for (int k = 0; k < shape.count; ++k) {
            const int next = k + 1 < shape.count ? k + 1 : 0;
            least =
                min(least, squared_distance_to_edge(shape.vertices[k], shape.vertices[next], p));
        }
    }
    return least;
}

/// True if no edge normal of `a` separates b from it.
bool no_axis_between(const Convex& a, const Convex& b, Vec2 offset) {
    for (int i = 0; i < a.count && a.count > 1; ++i) {
        float nearest = 1e30f;
        for (int k = 0; k < b.count; ++k)
            nearest = min(nearest, dot(a.normals[i], b.vertices[k] + offset));
        if (nearest > a.offsets[i]) return false;
    }
    return true;
}

}  // namespace

float distance(const Convex& a, const Convex& b, Vec2 offset) {
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
    Vec2 direction;
};

/// The shape of a sweep at any time.
class Turning {
  public:
    explicit Turning(const Sweep& sweep) : sweep_(sweep), copy_(sweep.shape) {}

    const Solid& at(float t) {
        const Motion& m = sweep_.motion;
        if (m.angle == 0.0f && m.turn == 0.0f) return sweep_.shape;
        return copy_.by(rotation_of(m.rotation(t)));
    }

  private:
    const Sweep& sweep_;
    TurnedCopy copy_;
};

constexpr int most_rounds = 128;

/// B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, section 2.3: no
/// point of a shape moves faster than its center of mass and its rotation together, so two shapes
/// cannot meet before they have moved by their distance. `gap_at(t)` measures it.
template <class GapAt>
float advance(const Sweep& a, const Sweep& b, float gap, float t, GapAt&& gap_at) {
    for (int round = 0; round < most_rounds; ++round) {
        const Gap found = gap_at(t);
        if (found.distance <= gap) return t;
        Vec2 velocity;
        float spin = 0.0f, end = 1.0f;  // of both: until the first of them stops
        if (a.motion.moves_after(t)) {
            velocity = a.motion.velocity;
            spin = std::fabs(a.motion.turn) * a.extent;
            end = min(end, a.motion.until);
        }
        if (b.motion.moves_after(t)) {
            velocity = velocity - b.motion.velocity;
            spin += std::fabs(b.motion.turn) * b.extent;
            end = min(end, b.motion.until);
        }
        const float speed = max(dot(velocity, found.direction), 0.0f) + spin;
        const float way = found.distance - 0.5f * gap;
        t = speed * (end - t) > way ? t + way / speed : end;
        if (t >= 1.0f) return 1.0f;
    }
    return t;
}

}  // namespace

float time_of_impact(const Sweep& a, const Sweep& b, float gap, float start) {
    Turning turning_a(a), turning_b(b);
    return advance(a, b, gap, start, [&](float t) {
        const Nearest found = nearest_points(turning_a.at(t), turning_b.at(t),
                                             b.motion.center(t) - a.motion.center(t));
        return Gap{found.distance, found.normal};
    });
}

Vec2 direction_between(const Sweep& a, const Sweep& b, float t) {
    Turning turning_a(a), turning_b(b);
    const Vec2 apart = b.motion.center(t) - a.motion.center(t);
    return nearest_points(turning_a.at(t), turning_b.at(t), apart).normal;
}

float time_of_impact(const Sweep& sweep, Vec2 normal, WorldCoordinate depth, float gap,
                     float start) {
    Turning turning(sweep);
    const Sweep plane = {{}, standing({}), 0.0f};
    return advance(sweep, plane, gap, start, [&](float t) {
        const float reached = reach(turning.at(t), -normal);
        return Gap{float(dot(normal, sweep.motion.center(t)) - reached - depth), -normal};
    });
}

}  // namespace fettle::physics::detail
