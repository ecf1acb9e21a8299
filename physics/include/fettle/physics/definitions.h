#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <optional>
#include <variant>
#include <vector>

// What is needed to create things: plain aggregates for designated initializers, with the defaults
// of the library. Every value in here can be changed later on the live object.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// How the values of two surfaces make that of a contact.
enum class MixRule : uint8_t { average, minimum, maximum, multiply, geometric };

/// How contacts and joints are solved; docs/design/solvers.md compares the three.
enum class Solver : uint8_t {
    soft_step,   ///< sequential impulses with memory on small steps, soft contacts
    sequential,  ///< one pass over the contacts in order of severity, near ones included, no memory
    direct       ///< each island as one complementarity problem
};

struct WorldDef {
    Vec2 gravity = {0.0f, -10.0f};    ///< m/s²
    int substeps = 4;                 ///< solver sub-steps a step, 1 … 64
    std::optional<Aabb> bounds = {};  ///< walls that keep dynamic bodies inside; none: open world
    float bounds_friction = 0.6f;     ///< of those walls
    float bounds_restitution = 0.0f;  ///< of those walls
    bool sleeping = true;             ///< resting islands stop costing time
    bool continuous = true;           ///< fast bodies do not pass through static ones
    float restitution_threshold = 1.0f;  ///< m/s; slower impacts do not bounce
    float hit_threshold = 1.0f;          ///< m/s; slower impacts make no hit event
    float sleep_speed = 0.05f;    ///< m/s; an island slower than this for `sleep_delay` sleeps
    float sleep_delay = 0.5f;     ///< s
    float contact_hertz = 60.0f;  ///< of a contact under load; an idle one has ¾ of it. At most a
                                  ///< quarter of the sub-step rate counts
    float contact_damping = 10.0f;  ///< damping ratio of contacts
    float push_speed = 3.0f;        ///< m/s; the fastest that an overlap is pushed apart
    MixRule friction_mix = MixRule::geometric;
    MixRule restitution_mix = MixRule::maximum;
    Solver solver = Solver::soft_step;
    bool persist_events = false;  ///< tell of every touch in every step that it lasts
};

struct BodyDef {
    BodyType type = BodyType::dynamic_body;
    Vec2 position = Vec2::Zero();   ///< m
    float angle = 0.0f;             ///< rad
    Vec2 velocity = Vec2::Zero();   ///< m/s
    float angular_velocity = 0.0f;  ///< rad/s
    Vec2 force = Vec2::Zero();      ///< N, applied at the center of mass in every step
    float torque = 0.0f;            ///< N m, applied in every step
    float gravity_scale = 1.0f;
    float linear_damping = 0.0f;        ///< 1/s
    float angular_damping = 0.0f;       ///< 1/s
    std::optional<float> mass = {};     ///< kg; none: from the shapes; infinity: does not move
    std::optional<float> inertia = {};  ///< kg m² about the center of mass; none: from the shapes;
                                        ///< infinity: does not turn
    std::optional<Vec2> center = {};  ///< center of mass in body coordinates; none: from the shapes
    bool awake = true;
    bool can_sleep = true;
    bool bullet = false;  ///< swept against moving bodies too
    bool locked_x = false;
    bool locked_y = false;
    bool locked_rotation = false;
    uint64_t user_data = 0;
};

/// Surface, mass and filter of a shape, whatever its geometry.
struct ShapeDef {
    float density = 1.0f;  ///< kg/m²
    float friction =
        0.6f;  ///< Coulomb coefficient; a contact mixes both by `WorldDef::friction_mix`
    float restitution = 0.0f;  ///< 0 … 1; mixed by `WorldDef::restitution_mix`
    float rolling_resistance =
        0.0f;  ///< lever of the resisting torque over the radius, for round shapes
    float surface_speed =
        0.0f;             ///< m/s, conveyor: along the surface, counter-clockwise round the shape
    bool sensor = false;  ///< reports overlaps, pushes nothing
    bool hit_events = false;       ///< report impacts above `WorldDef::hit_threshold`
    uint64_t category = 1;         ///< what it is
    uint64_t mask = ~uint64_t{0};  ///< what it collides with: both must agree
    int32_t group = 0;  ///< same non-zero group: positive always collides, negative never
    uint64_t user_data = 0;
};

// Geometry, in body coordinates.

struct Circle {
    float radius = 0.5f;
    Vec2 center = Vec2::Zero();
};

struct Box {
    float width = 1.0f;  ///< full width, rounding included
    float height = 1.0f;
    Vec2 center = Vec2::Zero();
    float angle = 0.0f;
    float rounding = 0.0f;  ///< corner radius; more than half the smaller side counts as half
};

/// Ends at the same point make it as short as one can be.
struct Segment {
    Vec2 from = {-0.5f, 0.0f};
    Vec2 to = {0.5f, 0.0f};
    float rounding = 0.0f;  ///< radius: a capsule when positive
};

/// The convex hull of these points is what counts: in any order, duplicates and inner points are
/// dropped.
struct Polygon {
    std::vector<Vec2> vertices = {};
    float rounding = 0.0f;  ///< radius added all round
};

/// Exact: no polygon stands for it.
struct Ellipse {
    float radius_x = 0.5f;  ///< half its width before it is turned
    float radius_y = 0.25f;
    Vec2 center = Vec2::Zero();
    float angle = 0.0f;
};

/// A polygon that may be concave, in either sense of rotation: its outline must not touch itself.
/// One shape, though it collides in convex pieces.
struct Concave {
    std::vector<Vec2> vertices = {};
};

/// A line of segments that things slide along as if it had no seams. One-sided: solid for what
/// comes from its left, as one walks from point to point. Points from left to right are ground; a
/// closed counter-clockwise chain holds what is inside, a clockwise one is an island. From behind
/// everything passes. Points that follow each other in the same place count once.
struct Chain {
    std::vector<Vec2> points = {};
    bool closed = false;  ///< from the last point back to the first
};

using Geometry = std::variant<Circle, Box, Segment, Polygon, Ellipse, Concave, Chain>;

/// What every joint starts with; the rest is set on the joint.
struct JointDef {
    BodyId body_a = {};  ///< the default is the world: anchor in world coordinates
    BodyId body_b = {};
    Vec2 anchor_a = Vec2::Zero();  ///< body coordinates, m
    Vec2 anchor_b = Vec2::Zero();
    bool collide = false;  ///< whether the two bodies collide with each other
    bool enabled = true;
    uint64_t user_data = 0;
};

/// A soft pull of a point of a body towards a target: how a mouse drags.
struct MouseJointDef {
    BodyId body = {};
    Vec2 target = Vec2::Zero();       ///< world, m
    std::optional<Vec2> anchor = {};  ///< body coordinates; none: the point that is at `target` now
    float hertz = 5.0f;               ///< stiffness
    float damping_ratio = 0.7f;
    float max_force = infinity;  ///< N
    bool enabled = true;
    uint64_t user_data = 0;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
