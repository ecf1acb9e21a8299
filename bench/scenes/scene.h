#pragma once
// A scene: bodies and their shapes in words that no engine owns, so that every engine builds the
// same one. Metres, kilograms, seconds, radians; y is up.

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
    float rounding = 0;  // grows it all round
};

/// With a radius a capsule.
struct SegmentShape {
    Point from{};
    Point to{};
    float radius = 0;
};

/// Convex, counter-clockwise.
struct PolygonShape {
    std::vector<Point> vertices;
    float rounding = 0;  // grows it all round
};

struct EllipseShape {
    Point radii{};
};

/// Solid on its left, as one walks from point to point.
struct ChainShape {
    std::vector<Point> points;
    bool closed = false;
};

using Geometry =
    std::variant<CircleShape, BoxShape, SegmentShape, PolygonShape, EllipseShape, ChainShape>;

struct SceneShape {
    Geometry geometry;
    float density = 1;      // kg/m²
    float friction = 0.6f;  // a contact has the geometric mean of both
    float restitution = 0;  // a contact has the greater of both
    std::uint16_t category = 1;
    std::uint16_t mask = 0xffff;  // what it collides with: both must agree
    std::int32_t group = 0;       // shapes of the same negative one do not collide
    bool hit_events = false;      // reports impacts, in engines that have such events
};

inline constexpr float unlimited = std::numeric_limits<float>::infinity();

/// A pin that holds two bodies together at a point, and turns b against a where it has a motor.
struct SceneJoint {
    std::size_t body_a = 0;  // indices into the scene's bodies
    std::size_t body_b = 0;
    Point anchor{};          // world, when the scene begins; the bodies have no angle then
    float motor_speed = 0;   // rad/s, of b relative to a
    float motor_torque = 0;  // N m, at most; 0: no motor
    float reference = 0;     // rad, of b relative to a: counts as 0 below
    float lower = -unlimited, upper = unlimited;  // rad
    float hertz = 0, damping_ratio = 0;           // of a spring to 0; 0 Hz: none
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
    /// Where a kinematic body heads for in every step, by the time at the end of the step.
    std::function<Point(double time)> path{};
};

/// Bodies that come together and go together, with joints among themselves.
struct SceneGroup {
    std::vector<SceneBody> bodies{};
    std::vector<SceneJoint> joints{};  // of bodies of the group
};

/// Before a step, a group goes (if it is there) and comes again as it was.
struct Arrival {
    int step = 0;  // the first is 0
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
    std::vector<Arrival> arrivals{};  // by step
    /// The peers that can express it; nothing: all.
    std::optional<std::vector<std::string_view>> peers{};
    bool runs_on(std::string_view engine) const;

    /// Where the joint holds its bodies, in their coordinates.
    Point anchor_a(const SceneJoint& joint) const;
    Point anchor_b(const SceneJoint& joint) const;
};

/// The same where the joint is one of these bodies.
Point local_anchor(const std::vector<SceneBody>& bodies, std::size_t body, Point anchor);

/// Length of a step of every scene, s.
inline constexpr float time_step = 1.0f / 60;

/// A body of one shape at `position`.
SceneBody body_of(Motion motion, Point position, Geometry geometry);
SceneBody dynamic_box(Point position, float half);
SceneBody fixed_box(Point position, Point half);

}  // namespace fettle::bench
