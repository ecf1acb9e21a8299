#pragma once

#include <collision/solid.h>
#include <fettle/physics/definitions.h>
#include <fettle/physics/field.h>
#include <geometry/mass.h>
#include <geometry/vector.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <type_traits>

// What a world keeps per body, shape, contact and joint. Indices instead of pointers and no
// ownership anywhere, so that the vectors of these records can be copied as they are.

namespace fettle::physics::detail {

inline constexpr uint32_t none = 0xffffffffu;

/// One sequence of numbers for all objects of a world: an identity never comes back. 0 is not
/// given.
struct Generations {
    uint32_t next = 1;

    uint32_t take() {
        const uint32_t given = next++;
        if (next == 0) next = 1;
        return given;
    }
};

/// How a body takes part in the step. An infinitely heavy dynamic body is fixed.
enum class Mobility : uint8_t { fixed, kinematic, dynamic };

/// A place in a list of a body: what links two bodies is in the lists of both.
struct ListEdge {
    uint32_t previous = none, next = none;  ///< edges: index << 1 | side
};

/// Puts an edge at the front of the list that begins with `first`; `at(edge)` is its place.
void link_edge(uint32_t& first, uint32_t edge, auto&& at) {
    at(edge) = {none, first};
    if (first != none) at(first).previous = edge;
    first = edge;
}
void unlink_edge(uint32_t& first, uint32_t edge, auto&& at) {
    const auto [previous, next] = at(edge);
    (previous != none ? at(previous).next : first) = next;
    if (next != none) at(next).previous = previous;
}

/// A value that was given in place of the one that follows from the shapes; NaN: none was given.
inline constexpr float not_given = std::numeric_limits<float>::quiet_NaN();
inline bool is_given(float value) {
    return !std::isnan(value);
}

struct BodyRecord {
    // What the step gathers of an awake body.
    V2 center;        ///< center of mass, world
    V2 local_center;  ///< center of mass, body coordinates
    float inverse_mass = 0.0f;
    float inverse_inertia = 0.0f;
    float gravity_scale = 1.0f;
    float linear_damping = 0.0f;
    float angular_damping = 0.0f;
    V2 force;
    float torque = 0.0f;
    V2 step_force;  ///< for the next step only
    float step_torque = 0.0f;
    float angle_rest =
        0.0f;  ///< what the float `angle` could not hold: slow turning adds up at any angle
    float extent = 0.0f;  ///< farthest point of the shapes from the center of mass, m
    float thickness =
        0.0f;  ///< least half width of the shapes, m: moving farther in a step is fast
    float sleep_time = 0.0f;    ///< s under the sleep speed
    uint32_t solver_index = 0;  ///< 1 + place among the awake; 0: fixed or asleep
    // In one byte: both are written with one access.
    Mobility mobility : 4 = Mobility::fixed;
    uint8_t listed : 4 = 0;  ///< in the list of bodies to refresh
    BodyType type = BodyType::dynamic_body;
    bool locked_x = false, locked_y = false, locked_rotation = false;
    bool can_sleep = true;
    bool bullet = false;
    bool never_awake = false;  ///< made asleep: gets its shapes without waking

    bool mass_dirty = false;
    bool placement_dirty =
        false;  ///< moved by an edit: rotated vertices, boxes and proxies are out of date
    uint32_t first_shape = none, last_shape = none;
    uint32_t first_contact = none;  ///< edge: contact << 1 | side
    uint32_t contact_count = 0;
    uint32_t touching = 0;   ///< contacts, sensors not counted
    uint32_t island = none;  ///< among the sleeping islands
    uint32_t next = none;    ///< body in the same sleeping island; of a free slot: the next one
    uint32_t first_joint = none;  ///< edge: joint << 1 | side
    uint32_t joint_count = 0;

    float mass = 0.0f, inertia = 0.0f;
    float given_mass = not_given, given_inertia = not_given;
    V2 given_center = {not_given, not_given};
    uint32_t rebuilds = 0;
    uint64_t user_data = 0;

    bool asleep() const { return solver_index == 0 && mobility != Mobility::fixed; }
    uint32_t& next_free() { return next; }

    void prefetch() const {
        for (size_t at = 0; at < sizeof(BodyRecord); at += 64)
            __builtin_prefetch(reinterpret_cast<const char*>(this) + at, 1);
    }
};

/// What the narrow phase needs of a shape, packed.
struct ShapeForm {
    uint32_t begin = 0;  ///< in the vertex pool
    uint32_t count : 24 = 0;
    FormKind kind : 8 = FormKind::convex;
    float radius = 0.0f;
    uint32_t body = none;
    V2 center;  ///< of mass of the body: what the vertices are relative to, world

    bool is_small_polygon() const { return kind == FormKind::convex && (count == 3 || count == 4); }
};

/// A value of any plain type, which is known from elsewhere. All types use the same memory.
template <size_t capacity>
class PlainValue {
  public:
    template <class Type>
    Type& as() {
        static_assert(sizeof(Type) <= capacity && alignof(Type) <= alignof(float));
        static_assert(std::is_trivially_destructible_v<Type>);
        return *std::launder(reinterpret_cast<Type*>(bytes_));
    }
    template <class Type>
    const Type& as() const {
        return const_cast<PlainValue*>(this)->as<Type>();
    }
    template <class Type>
    void become(const Type& value) {
        new (bytes_) Type(value);
    }

  private:
    alignas(float) std::byte bytes_[capacity] = {};
};

/// Circle, Box, Segment or Ellipse, as the type of the shape says.
using Figure = PlainValue<24>;

/// What a polygon has besides its vertices.
struct PolygonFigure {
    float rounding = 0.0f;
};

struct ShapeRecord {
    ShapeDef surface;
    Figure figure;
    ShapeType type = ShapeType::circle;
    Mobility tree = Mobility::fixed;  ///< which tree the proxy is in: fixed or another
    bool closed = false;              ///< a chain
    bool geometry_dirty = false;
    bool moved = false;     ///< in the list of shapes to find pairs for
    bool listed = false;    ///< in the list of shapes to refresh
    uint32_t capacity = 0;  ///< vertices reserved in the pool

    // A chain or a concave polygon collides as its parts, which are shapes that only the library
    // sees. It is in no tree itself and owns the surface, which the parts have a copy of.
    uint32_t outline = 0;                          ///< how many points it has in the pool
    uint32_t owner = none;                         ///< of a part
    uint32_t first_part = none, next_part = none;  ///< of an owner, of a part

    int32_t proxy = -1;
    uint32_t previous = none, next = none;  ///< in the body; of a free slot: the next one
    uint32_t touching = 0;
    uint32_t rebuilds = 0;
    float area = 0.0f, moment = 0.0f;  ///< m², m⁴ about the centroid
    V2 centroid;

    uint32_t& next_free() { return next; }
    void set_moments(const AreaMoments& m) {
        area = float(m.area);
        moment = float(m.moment);
        centroid = {float(m.center_x), float(m.center_y)};
    }
};

static_assert(sizeof(ShapeForm) == 24);
// A world may have a hundred thousand of each: every member costs that many times its size.
static_assert(sizeof(BodyRecord) <= 168 && sizeof(ShapeRecord) <= 144);

/// Both plain convex.
inline bool usual_forms(const ShapeForm& a, const ShapeForm& b) {
    return (uint8_t(a.kind) | uint8_t(b.kind)) == 0;
}

/// A pair of shapes whose fat boxes overlap. It has a slot; the slots of awake contacts are listed.
struct alignas(64) ContactRecord {
    uint32_t shape_a = none, shape_b = none;  ///< shape_a < shape_b
    uint32_t body_a = none, body_b = none;
    uint32_t awake_index = none;
    bool touching = false;  ///< as events tell it
    bool sensor = false;
    bool special = false;  ///< rolling resistance, surface speed or restitution
    bool hit_events = false;
    bool disabled = false;  ///< in this step, by a callback
    bool curved = false;    ///< of an ellipse: it runs along the rim within the step
    float friction = 0.0f;
    Manifold manifold;
    float restitution = 0.0f, rolling_resistance = 0.0f, surface_speed = 0.0f;
    float rolling_impulse = 0.0f;

    void prefetch() const {
        __builtin_prefetch(this, 1);
        __builtin_prefetch(reinterpret_cast<const char*>(this) + 64, 1);
    }
};
static_assert(sizeof(ContactRecord) == 128);

/// The part of a contact that few stages of a step read.
struct ContactLinks {
    ListEdge edges[2];   ///< in the contact lists of body a and b; of a free slot: the next one
    uint32_t began = 0;  ///< the last digits of the step in which it began to touch

    uint32_t& next_free() { return edges[0].next; }
};

inline constexpr size_t joint_type_count = size_t(JointType::ratchet) + 1;

struct JointRecord {
    JointType type = JointType::mouse;
    bool enabled = true;
    bool collide = false;         ///< the two bodies, with each other
    bool broken = false;          ///< it does not act until it is repaired
    uint32_t awake_index = none;  ///< in the list of the awake ones of its type
    uint32_t bodies[2] = {0, 0};  ///< 0: the world
    V2 anchors[2];                ///< body coordinates
    ListEdge edges[2];            ///< in the joint lists of body a and b; of a free slot: the next
    V2 force;                     ///< of the last step, on body b
    float torque = 0.0f;
    float break_force = infinity, break_torque = infinity;  ///< N, N m: it breaks above
    PlainValue<44> settings;                                ///< `Settings` of its type
    PlainValue<24> impulses;  ///< `Impulses` of its type, of the last sub-step; all 0: none
    uint64_t user_data = 0;

    uint32_t& next_free() { return edges[0].next; }
    bool acts() const { return enabled && !broken; }
    bool breakable() const { return break_force < infinity || break_torque < infinity; }
};

struct FieldRecord {
    FieldDef def;
    uint32_t generation = 0;  ///< 0: the slot is free
    uint32_t next = none;     ///< of a free slot: the next one

    uint32_t& next_free() { return next; }
};

/// Bodies that fell asleep together and wake together, a list through their records.
struct Island {
    uint32_t first = none;
    uint32_t next = none;  ///< of a free slot: the next one

    uint32_t& next_free() { return next; }
};

}  // namespace fettle::physics::detail
