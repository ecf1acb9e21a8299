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

/// How a sweep moves from a time on, and until when.
struct Course {
    Vec2 velocity;      ///< m per step
    float turn = 0.0f;  ///< rad per step
    float until = 1.0f;
};

Course course_after(const Motion& motion, float t) {
    if (!motion.moves_after(t)) return {};
    return {motion.velocity, motion.turn, motion.until};
}

/// The time in which no point of `a` can move farther than `travel` in the frame that turns with
/// `b`. There a body that is carried along, as in a drum, stands still. `apart`: the center of mass
/// of a minus that of b. The relative velocity of the center changes at most by turn times
/// velocity.
float time_to_travel(const Course& a, float extent_a, const Course& b, Vec2 apart, float travel) {
    const Vec2 velocity = a.velocity - b.velocity;
    const float speed =
        length(velocity - cross(b.turn, apart)) + std::fabs(a.turn - b.turn) * extent_a;
    const float change = std::fabs(b.turn) * length(velocity);
    const float sum = speed + std::sqrt(speed * speed + 2.0f * change * travel);
    return sum > 0.0f ? 2.0f * travel / sum : 2.0f;
}

/// B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, section 2.3: no
/// point of a shape moves faster than its center of mass and its rotation together, so two shapes
/// cannot meet before they have moved by their distance. `gap_at(t)` measures it.
template <class GapAt>
float advance(const Sweep& a, const Sweep& b, float gap, float t, GapAt&& gap_at) {
    for (int round = 0; round < most_rounds; ++round) {
        const Gap found = gap_at(t);
        if (found.distance <= gap) return t;
        const Course of_a = course_after(a.motion, t), of_b = course_after(b.motion, t);
        const float end = min(of_a.until, of_b.until);  // then the first of them stops
        const float spin = std::fabs(of_a.turn) * a.extent + std::fabs(of_b.turn) * b.extent;
        const float speed = max(dot(of_a.velocity - of_b.velocity, found.direction), 0.0f) + spin;
        const float clearance = found.distance - 0.5f * gap;
        if (speed * (end - t) <= clearance) {
            t = end;
        } else {
            float time = clearance / speed;
            if (of_b.turn != 0.0f)
                time =
                    max(time, time_to_travel(of_a, a.extent, of_b,
                                             a.motion.center(t) - b.motion.center(t), clearance));
            t = min(t + time, end);
        }
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
    const Sweep plane = {{}, at_rest({}), 0.0f};
    return advance(sweep, plane, gap, start, [&](float t) {
        const float reached = reach(turning.at(t), -normal);
        return Gap{float(dot(normal, sweep.motion.center(t)) - reached - depth), -normal};
    });
}

}  // namespace fettle::physics::detail
