#pragma once

#include <geometry/vector.h>

namespace fettle::physics::detail {

/// The motion of a body in a step, which lasts from 0 to 1. The body moves uniformly between
/// `since` and `until`, and stands before and after.
struct Motion {
    Position from;  ///< center of mass at `since`
    Vec2 velocity;  ///< m per step
    /// Rotation at `since`, relative to the pose in which the vertices of its shapes are, rad.
    float angle = 0.0f;
    float turn = 0.0f;  ///< rad per step
    float since = 0.0f, until = 1.0f;

    float passed(float t) const { return clamp(t, since, until) - since; }
    Position center(float t) const { return from + passed(t) * velocity; }
    /// Relative to the pose of the vertices.
    double rotation(float t) const { return double(angle) + double(turn) * double(passed(t)); }
    bool moves_after(float t) const { return t < until; }
};

/// True if a body neither moves nor turns.
template <class Body>
bool stands_still(const Body& body) {
    return body.velocity == Vec2{} && body.angular_velocity == 0.0f;
}

inline Motion at_rest(Position center, float angle = 0.0f) {
    Motion motion;
    motion.from = center;
    motion.angle = angle;
    motion.until = 0.0f;
    return motion;
}

}  // namespace fettle::physics::detail
