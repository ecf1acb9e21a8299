#pragma once

#include <fettle/physics/physics.h>

#include <cmath>
#include <vector>

// Worlds and checks that many tests use.

namespace scenes {

using namespace fettle::physics;

inline constexpr float frame = 1.0f / 60.0f;

/// Steps for a time; every step leaves the world consistent, which costs too much to check each
/// time.
inline void run(World& world, float seconds) {
    const int steps = int(std::lround(seconds / frame));
    for (int i = 0; i < steps; ++i) world.step(frame);
}

/// A static floor whose top is at y = 0.
inline Body add_floor(World& world, float half_width = 50.0f, const ShapeDef& surface = {}) {
    Body floor = world.create_body({.type = BodyType::static_body, .position = {0.0f, -0.5f}});
    floor.add(Box{.width = 2.0f * half_width, .height = 1.0f}, surface);
    return floor;
}

inline Body add_box(World& world, const Vec2& position, float size = 1.0f,
                    const ShapeDef& surface = {}) {
    Body box = world.create_body({.position = position});
    box.add(Box{.width = size, .height = size}, surface);
    return box;
}

/// A box of a given mass, kg.
inline Body add_box(World& world, const Vec2& position, float width, float height, float mass) {
    Body box = world.create_body({.position = position});
    box.add(Box{.width = width, .height = height});
    box.set_mass(mass);
    return box;
}

inline Body add_ball(World& world, const Vec2& position, float radius = 0.5f,
                     const ShapeDef& surface = {}) {
    Body ball = world.create_body({.position = position});
    ball.add(Circle{.radius = radius}, surface);
    return ball;
}

/// Root of the mean square of the speeds, m/s.
inline float rms_speed(const std::vector<Body>& bodies) {
    float sum = 0.0f;
    for (const Body& body : bodies) sum += body.velocity().length_squared();
    return std::sqrt(sum / float(bodies.size()));
}

/// `count` points of an ellipse, counterclockwise from its right end.
inline std::vector<Vec2> ellipse_points(float rx, float ry, int count,
                                        const Vec2& center = {0.0f, 0.0f}) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const float t = 6.2831853f * float(i) / float(count);
        points.push_back(center + Vec2(rx * std::cos(t), ry * std::sin(t)));
    }
    return points;
}

/// A box at rest on a static slope of this angle, friction as given on both; the slope passes
/// through the origin.
struct Slope {
    Body ground;
    Body box;
    Vec2 down;  ///< direction of the slope downwards
};
inline Slope add_slope(World& world, float angle, float friction) {
    Slope slope;
    slope.ground = world.create_body({.type = BodyType::static_body, .angle = angle});
    slope.ground.add(Box{.width = 400.0f, .height = 1.0f}, {.friction = friction});
    const Vec2 normal = {-std::sin(angle), std::cos(angle)};
    slope.box = world.create_body({.position = normal * 1.0f, .angle = angle});
    slope.box.add(Box{}, {.friction = friction});
    slope.down = Vec2(-std::cos(angle), -std::sin(angle));
    return slope;
}

}  // namespace scenes
