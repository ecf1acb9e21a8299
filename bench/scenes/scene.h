#pragma once
// A scene: bodies and shapes in a form that does not depend on an engine, so that every engine
// builds the same scene. Units: meters, kilograms, seconds, radians; y is up.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fettle::bench {

struct Point {
    float x = 0;
    float y = 0;
    friend bool operator==(const Point&, const Point&) = default;
};

// Geometry, in body coordinates.

struct CircleShape {
    float radius = 0.5f;
    Point center{};
};

struct BoxShape {
    Point half = {0.5f, 0.5f};
    Point center{};
    float rounding = 0;  // radius added all around
};

/// A segment with a radius is a capsule.
struct SegmentShape {
    Point from{};
    Point to{};
    float radius = 0;
};

/// Convex, counter-clockwise.
struct PolygonShape {
    std::vector<Point> vertices;
    float rounding = 0;  // radius added all around
};

struct EllipseShape {
    Point radii{};
};

/// Solid on its left side in the order of the points.
struct ChainShape {
    std::vector<Point> points;
    bool closed = false;
};

using Geometry =
    std::variant<CircleShape, BoxShape, SegmentShape, PolygonShape, EllipseShape, ChainShape>;

struct SceneShape {
    Geometry geometry;
    float density = 1;      // kg/m²
    float friction = 0.6f;  // a contact uses the geometric mean of both
    float restitution = 0;  // a contact uses the larger of both
    std::uint16_t category = 1;
    std::uint16_t mask = 0xffff;  // categories it collides with; both shapes must agree
    std::int32_t group = 0;       // shapes with the same negative group do not collide
    bool hit_events = false;      // reports impacts, if the engine has such events
};

inline constexpr float unlimited = std::numeric_limits<float>::infinity();

/// A pin that holds two bodies together at a point; with a motor, it turns b relative to a.
struct SceneJoint {
    std::size_t body_a = 0;  // indices of bodies in the scene
    std::size_t body_b = 0;
    Point anchor{};          // world coordinates at the start; the bodies have angle 0 then
    float motor_speed = 0;   // rad/s, of b relative to a
    float motor_torque = 0;  // maximum torque in N m; 0: no motor
    float reference = 0;     // rad; the angle of b relative to a that counts as 0
    float lower = -unlimited, upper = unlimited;  // rad
    float hertz = 0, damping_ratio = 0;           // spring to angle 0; 0 Hz: no spring
};

enum class Motion : std::uint8_t { fixed, kinematic, dynamic };

struct SceneBody {
    Motion motion = Motion::dynamic;
    Point position{};
    float angle = 0;
    Point velocity{};
    float angular_velocity = 0;
    bool awake = true;
    bool bullet = false;
    bool can_sleep = true;
    float linear_damping = 0;  // 1/s
    std::vector<SceneShape> shapes{};
    /// Target of a kinematic body in every step, by the time at the end of the step.
    std::function<Point(double time)> path{};
};

/// Bodies that are added and removed together, with joints between them.
struct SceneGroup {
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};  // between bodies of the group
};

/// Before a step, a group is removed (if it exists) and added again in its initial state.
struct Arrival {
    int step = 0;  // the first step is 0
    std::size_t group = 0;
};

struct Scene {
    std::string name;
    int steps = 500;
    Point gravity = {0, -10};
    bool sleeping = true;
    bool continuous = true;
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};
    std::vector<SceneGroup> groups{};
    std::vector<Arrival> arrivals{};  // sorted by step
    /// Engines that can represent the scene; nullopt: all.
    std::optional<std::vector<std::string_view>> peers{};
    bool runs_on(std::string_view engine) const;

    /// The anchor of a joint in the coordinates of its bodies.
    Point anchor_a(const SceneJoint& joint) const;
    Point anchor_b(const SceneJoint& joint) const;
};

/// The anchor in the coordinates of one of these bodies.
Point local_anchor(const std::vector<SceneBody>& bodies, std::size_t body, Point anchor);

/// Length of a step in every scene, s.
inline constexpr float time_step = 1.0f / 60;

/// A body with one shape at `position`.
SceneBody body_of(Motion motion, Point position, Geometry geometry);
SceneBody dynamic_box(Point position, float half);
SceneBody fixed_box(Point position, Point half);

}  // namespace fettle::bench
