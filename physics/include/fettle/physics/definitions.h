#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <concepts>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

// Definitions of the objects that a world creates: plain aggregates for designated initializers,
// with the defaults of the library. All values can be changed later on the objects.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Rule by which a contact computes its value from the values of its two surfaces.
enum class MixRule : uint8_t { average, minimum, maximum, multiply, geometric };

/// How contacts and joints are solved; docs/design/solvers.md compares the three.
enum class Solver : uint8_t {
    soft_step,   ///< sequential impulses with warm start on small steps, soft contacts
    sequential,  ///< one pass over the contacts in order of severity, near ones included; no warm
                 ///< start
    direct       ///< each island as one complementarity problem
};

#ifdef FETTLE_PHYSICS_DOUBLE
// The type, and each function with it as a parameter, has another name for the linker. So a program
// does not link with a library whose positions have another precision.
inline namespace double_positions {
#endif

/// Settings of a world.
struct WorldDef {
    Vec2 gravity = {0.0f, -10.0f};  ///< m/s²
    /// Solver sub-steps per step of up to 1/60 s, 1 … 64. With `soft_step` and `direct`, a longer
    /// step gets more of them, up to four times as many: twice as many in 1/30 s. With `soft_step`,
    /// so does a step that is much longer than the last one.
    int substeps = 4;
    std::optional<Aabb> bounds = {};  ///< walls that keep dynamic bodies inside; none: open world
    float bounds_friction = 0.6f;     ///< friction of these walls
    float bounds_restitution = 0.0f;  ///< restitution of these walls
    bool sleeping = true;             ///< resting islands fall asleep and cost no time
    bool continuous = true;           ///< fast bodies do not pass through static ones
    float restitution_threshold = 1.0f;  ///< m/s; slower impacts do not bounce
    float hit_threshold = 1.0f;          ///< m/s; slower impacts make no hit event
    /// m/s; an island that is slower than this for `sleep_delay` sleeps. If none of its bodies
    /// touches anything, as it flies or hangs from a joint, it must be 20 times slower.
    float sleep_speed = 0.05f;
    float sleep_delay = 0.5f;     ///< s
    float contact_hertz = 60.0f;  ///< frequency of a contact under load; ¾ of it without load. The
                                  ///< solver uses at most a quarter of the sub-step rate
    float contact_damping = 10.0f;  ///< damping ratio of contacts
    float push_speed = 3.0f;        ///< m/s; limit for pushing overlapping shapes apart
    float max_speed = 1e4f;         ///< m/s, above 0, at most 1e4: limit of the speed of every body
    MixRule friction_mix = MixRule::geometric;   ///< how a contact computes its friction
    MixRule restitution_mix = MixRule::maximum;  ///< how a contact computes its restitution
    Solver solver = Solver::soft_step;           ///< how contacts and joints are solved
    bool persist_events = false;                 ///< report every continuing touch in every step
};

#ifdef FETTLE_PHYSICS_DOUBLE
}  // namespace double_positions
#endif

/// A body that a world is to create.
struct BodyDef {
    BodyType type = BodyType::dynamic_body;  ///< what moves it
    Position position = {};                  ///< m
    float angle = 0.0f;                      ///< rad
    Vec2 velocity = {};                      ///< m/s
    float angular_velocity = 0.0f;           ///< rad/s
    Vec2 force = {};                         ///< N, applied at the center of mass in every step
    float torque = 0.0f;                     ///< N m, applied in every step
    float gravity_scale = 1.0f;              ///< factor of the gravity of the world
    float linear_damping = 0.0f;             ///< 1/s
    float angular_damping = 0.0f;            ///< 1/s
    std::optional<float> mass = {};          ///< kg; none: from the shapes; infinity: does not move
    std::optional<float> inertia = {};  ///< kg m²; none: from the shapes; infinity: does not rotate
    /// Center of mass in body coordinates; none: from the shapes, or the origin of a kinematic
    /// body.
    std::optional<Vec2> center = {};
    bool awake = true;             ///< false: asleep until something wakes it
    bool can_sleep = true;         ///< false: it never falls asleep
    bool bullet = false;           ///< true: continuous collision with moving bodies, too
    bool locked_x = false;         ///< true: it does not move along x
    bool locked_y = false;         ///< true: it does not move along y
    bool locked_rotation = false;  ///< true: it does not rotate
    bool enabled = true;           ///< false: takes no part in steps and queries
    /// m/s; with its island, it rests below this. None: `WorldDef::sleep_speed`.
    std::optional<float> sleep_speed = {};
    float max_speed = infinity;  ///< m/s, limit of its speed, above 0
    std::string_view name = {};  ///< for messages and tools; at most 63 bytes, copied
    uint64_t user_data = 0;      ///< a number of the host, without effect
};

/// Surface, mass and filter of a shape, for any geometry.
struct ShapeDef {
    float density = 1.0f;  ///< kg/m²
    float friction =
        0.6f;  ///< Coulomb coefficient; a contact mixes both by `WorldDef::friction_mix`
    float restitution = 0.0f;  ///< 0 … 1; mixed by `WorldDef::restitution_mix`
    /// Lever arm of the resisting torque divided by the radius: of this shape, or of the other one
    /// if this one has no round side.
    float rolling_resistance = 0.0f;
    float surface_speed =
        0.0f;             ///< m/s, conveyor: along the surface, counter-clockwise round the shape
    bool sensor = false;  ///< reports overlaps, applies no force
    bool hit_events = false;       ///< report impacts above `WorldDef::hit_threshold`
    bool contact_events = true;    ///< report its touches; both shapes must agree
    bool sensor_events = true;     ///< report it as a sensor or in one; both shapes must agree
    uint64_t category = 1;         ///< categories of this shape, one bit each
    uint64_t mask = ~uint64_t{0};  ///< categories it collides with; both shapes must agree
    int32_t group = 0;         ///< same non-zero group: positive always collides, negative never
    uint16_t material = 0;     ///< a number of the host, without effect
    bool before_solve = true;  ///< call the before-solve callback; both shapes must agree
    uint64_t user_data = 0;    ///< a number of the host, without effect
};

/// Surface of one segment of a chain, in place of that of the shape. The members mean what they
/// mean in `ShapeDef`. A number that is `infinity`, or a material that is 65535, stands for the
/// value of the shape.
struct SegmentSurface {
    float friction = 0.6f;            ///< Coulomb coefficient, at least 0
    float restitution = 0.0f;         ///< 0 … 1
    float rolling_resistance = 0.0f;  ///< at least 0: lever arm divided by the radius
    float surface_speed = 0.0f;       ///< m/s, against the order of the points
    uint16_t material = 0;            ///< a number of the host, without effect
    friend bool operator==(const SegmentSurface&, const SegmentSurface&) = default;
};

/// All values are those of the shape, as for a segment without a surface of its own.
inline constexpr SegmentSurface surface_of_shape = {infinity, infinity, infinity, infinity, 65535};

// Geometry, in body coordinates.

/// A disc.
struct Circle {
    float radius = 0.5f;  ///< m, 1e-5 … 1e6
    Vec2 center = {};     ///< body coordinates, m
};

/// A rectangle, also with round corners.
struct Box {
    float width = 1.0f;     ///< full width, including rounding
    float height = 1.0f;    ///< full height, including rounding
    Vec2 center = {};       ///< body coordinates, m
    float angle = 0.0f;     ///< rad
    float rounding = 0.0f;  ///< corner radius; at most half of the smaller side is used
};

/// If both ends are at the same point, the segment gets the minimal length.
struct Segment {
    Vec2 from = {-0.5f, 0.0f};  ///< its start, m
    Vec2 to = {0.5f, 0.0f};     ///< its end, m
    float rounding = 0.0f;      ///< radius: a capsule when positive
};

/// The shape is the convex hull of these points. They may be in any order; duplicates and inner
/// points are dropped.
struct Polygon {
    std::vector<Vec2> vertices = {};  ///< body coordinates, m; at least three
    float rounding = 0.0f;            ///< radius added on all sides
};

/// Collides as an exact ellipse, not as a polygon.
struct Ellipse {
    float radius_x = 0.5f;   ///< half of its width before rotation
    float radius_y = 0.25f;  ///< half of its height before rotation
    Vec2 center = {};        ///< body coordinates, m
    float angle = 0.0f;      ///< rad
};

/// A polygon that may be concave, clockwise or counter-clockwise. Its outline must not touch
/// itself. It is one shape and collides as convex pieces. The time to find them grows faster than
/// the square of the number of vertices, up to a tenth of a second for 4096 of them and to seconds
/// for the most that there may be. A longer outline is a `Chain`, or several shapes of one body.
struct Concave {
    static constexpr size_t most_vertices = 16384;  ///< of the outline
    std::vector<Vec2> vertices = {};  ///< body coordinates, m; from 3 to `most_vertices`
};

/// A line of segments on which bodies slide without catching at its points. It is one-sided: solid
/// for bodies on its left, in the order of the points. Points from left to right make a ground; a
/// closed counter-clockwise chain holds the bodies inside, a clockwise one is an island. Bodies
/// pass through it from behind. Consecutive points at the same place count once.
struct Chain {
    std::vector<Vec2> points = {};  ///< body coordinates, m; at least two
    bool closed = false;            ///< true: a segment goes from the last point to the first
};

/// The geometry of a shape.
using Geometry = std::variant<Circle, Box, Segment, Polygon, Ellipse, Concave, Chain>;

/// A definition of a type of joint: joint_definitions.h.
template <class Def>
concept JointDefinition = std::convertible_to<decltype(Def::type), JointType>;

/// Settings that all types of joints have. It converts to the definition of any type of joint with
/// two bodies, whose other settings are the defaults of the type.
struct JointDef {
    BodyId body_a = {};              ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};              ///< the same for body b; not both may be the world
    Position anchor_a = {};          ///< body coordinates, m
    Position anchor_b = {};          ///< body coordinates, m
    bool collide = false;            ///< whether the two bodies collide with each other
    bool enabled = true;             ///< false: it does nothing
    uint64_t user_data = 0;          ///< a number of the host, without effect
    float break_force = infinity;    ///< N: `Joint::set_break_force`
    float break_torque = infinity;   ///< N m
    float report_force = infinity;   ///< N: `Joint::set_report_force`
    float report_torque = infinity;  ///< N m
    float constraint_hertz = 0.0f;   ///< `Joint::set_constraint_hertz`
    float constraint_damping_ratio = 2.0f;  ///< `Joint::set_constraint_damping_ratio`

    /// These settings in the definition of a type of joint.
    template <JointDefinition Def>
    operator Def() const {
        return {body_a,
                body_b,
                anchor_a,
                anchor_b,
                collide,
                enabled,
                user_data,
                break_force,
                break_torque,
                report_force,
                report_torque,
                constraint_hertz,
                constraint_damping_ratio};
    }
};

/// A soft pull of a point of a body towards a target, for dragging with a mouse.
struct MouseJointDef {
    BodyId body = {};                 ///< the body that is dragged; must be set
    Position target = {};             ///< world, m
    std::optional<Vec2> anchor = {};  ///< body coordinates; none: the point at `target`
    float hertz = 5.0f;               ///< stiffness
    float damping_ratio = 0.7f;       ///< of that stiffness, at least 0
    float max_force = infinity;       ///< N
    bool enabled = true;              ///< false: it does nothing
    uint64_t user_data = 0;           ///< a number of the host, without effect
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
