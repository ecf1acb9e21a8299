#pragma once

#include <collision/solid.h>
#include <fettle/physics/definitions.h>
#include <fettle/physics/field.h>
#include <geometry/mass.h>
#include <geometry/vector.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <type_traits>

// Data of a world for each body, shape, contact and joint. They contain indices instead of pointers
// and own no memory, so vectors of these records can be copied byte by byte.

namespace fettle::physics::detail {

inline constexpr uint32_t none = 0xffffffffu;
/// The slots of shapes before this are the sides of the border of a world.
inline constexpr uint32_t border_sides = 4;

/// One sequence of generations for all objects of a world: no value is used twice. 0 is never used.
struct Generations {
    uint32_t next = 1;

    uint32_t create() {
        const uint32_t created = next++;
        if (next == 0) next = 1;
        return created;
    }
};

/// Mobility of a body in a step. An infinitely heavy dynamic body is fixed.
enum class Mobility : uint8_t { fixed, kinematic, dynamic };

/// An element of a list of a body. A contact or joint of two bodies is in the lists of both.
struct ListEdge {
    uint32_t previous = none, next = none;  ///< edges: index << 1 | side
};

/// Inserts an edge at the front of the list that begins with `first`; `at(edge)` is its element.
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

/// Value of an override that is not set (NaN). An override replaces the value that follows from the
/// shapes.
inline constexpr float not_given = std::numeric_limits<float>::quiet_NaN();
inline bool is_given(float value) {
    return !std::isnan(value);
}

/// The load at the center of mass of a body.
struct Load {
    Vec2 force;           ///< N
    float torque = 0.0f;  ///< N m

    /// The sum stays finite.
    void add(const Load& other) {
        constexpr float greatest = std::numeric_limits<float>::max();
        force = bounded(force + other.force, greatest);
        torque = bounded(torque + other.torque, greatest);
    }
};

/// Switches of a body that the user set, and marks of data that is out of date since an edit.
struct BodyFlags {
    bool locked_x = false, locked_y = false, locked_rotation = false;
    bool can_sleep = true;
    bool bullet = false;
    bool never_awake = false;  ///< created asleep; gets its shapes without waking
    bool mass_dirty = false;   ///< the mass is computed anew when it is needed
    /// Moved by an edit: rotated vertices, boxes and proxies are out of date.
    bool placement_dirty = false;
    bool disabled = false;  ///< fixed, in no tree, and without contacts
};

/// The lists of the objects of a body, and its place in the list of its sleeping island.
struct BodyLists {
    uint32_t first_shape = none, last_shape = none;
    uint32_t first_contact = none;  ///< edge: contact << 1 | side
    uint32_t contact_count = 0;
    uint32_t touching = 0;        ///< number of touching contacts, without sensors
    uint32_t island = none;       ///< index of its sleeping island
    uint32_t next = none;         ///< next body in its sleeping island, or next free slot
    uint32_t first_joint = none;  ///< edge: joint << 1 | side
    uint32_t joint_count = 0;
};

/// Overrides of values that follow from the shapes.
struct GivenMass {
    float mass = not_given, inertia = not_given;
    Vec2 center = {not_given, not_given};
};

struct BodyRecord {
    // Data that the step gathers from an awake body.
    Position center;    ///< center of mass, world
    Vec2 local_center;  ///< center of mass, body coordinates
    float inverse_mass = 0.0f;
    float inverse_inertia = 0.0f;
    float gravity_scale = 1.0f;
    float linear_damping = 0.0f;
    float angular_damping = 0.0f;
    Load load;                  ///< in every step
    Load step_load;             ///< in the next step only
    float angle_rest = 0.0f;    ///< part of the angle below the resolution of `angle`
    float extent = 0.0f;        ///< farthest point of the shapes from the center of mass, m
    float thickness = 0.0f;     ///< smallest half width, m; a longer motion per step is fast
    float sleep_time = 0.0f;    ///< s at rest: sleep/rest.h
    uint32_t solver_index = 0;  ///< 1 + index in the list of awake bodies; 0: fixed or asleep
    // Both are in one byte, so that one access writes them.
    Mobility mobility : 4 = Mobility::fixed;
    uint8_t listed : 4 = 0;  ///< in the list of bodies to refresh
    BodyType type = BodyType::dynamic_body;
    BodyFlags flags;
    bool may_be_crowded = false;  ///< by its joints: state/crowding.h
    BodyLists lists;

    float mass = 0.0f, inertia = 0.0f;
    GivenMass given;
    uint32_t rebuilds = 0;
    uint32_t traits = none;  ///< index of its `BodyTraits`; none: all have their default values
    uint64_t user_data = 0;

    bool asleep() const { return solver_index == 0 && mobility != Mobility::fixed; }
    uint32_t& next_free() { return lists.next; }

    void prefetch() const {
        for (size_t at = 0; at < sizeof(BodyRecord); at += 64)
            __builtin_prefetch(reinterpret_cast<const char*>(this) + at, 1);
    }
};

/// Values that few bodies have. Other bodies have the initial values and no such record.
struct BodyTraits {
    float sleep_speed = not_given;  ///< m/s; not given: that of the world
    float max_speed = std::numeric_limits<float>::infinity();  ///< m/s
    uint32_t next = none;            ///< for a free slot: the next free slot
    std::array<char, 64> name = {};  ///< ends with 0

    uint32_t& next_free() { return next; }
    bool are_default() const {
        return !is_given(sleep_speed) && name[0] == 0 &&
               max_speed == std::numeric_limits<float>::infinity();
    }
};

/// Where a body was when it came to rest, and how it has moved since: sleep/rest.h.
struct RestPose {
    Position center;
    float angle = 0.0f;       ///< rad
    Vec2 first_way;           ///< of the center in the first half of the delay, m
    float drawn_time = 0.0f;  ///< s for which it was slow, but drawn by a force
};

/// How an awake body moves in place: sleep/rocking.h.
struct Stay {
    uint32_t body = none;
    uint32_t returns = 0;  ///< how often it came back; at most 1 after a long way
    float angle = 0.0f;    ///< at the beginning, rad
    Position center;       ///< center of mass at the beginning, world
    float time = 0.0f;     ///< s since then
    float far = 0.0f;      ///< the greatest distance since then, m
    float back = 0.0f;     ///< the greatest distance from which it has come back, m
    float fastest = 0.0f;  ///< m/s
};

/// Data of a shape for the narrow phase, packed.
struct ShapeForm {
    uint32_t begin = 0;  ///< in the vertex pool
    uint32_t count : 24 = 0;
    FormKind kind : 8 = FormKind::convex;
    float radius = 0.0f;
    uint32_t body = none;
    Position center;  ///< center of mass of the body in the world: the vertices are relative to it
    float angle = 0.0f;  ///< of the body, rad
    float turn = 0.0f;   ///< in the last step, rad

    bool is_small_polygon() const { return kind == FormKind::convex && (count == 3 || count == 4); }
};

/// A value of any plain type; other data contain the type. All types use the same memory.
template <size_t capacity>
class PlainValue {
  public:
    template <class Type>
    Type& as() {
        static_assert(sizeof(Type) <= capacity && alignof(Type) <= alignof(WorldCoordinate));
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
    alignas(WorldCoordinate) std::byte bytes_[capacity] = {};
};

/// Circle, Box, Segment or Ellipse, according to the type of the shape.
using Figure = PlainValue<24>;

/// Data of a polygon in addition to its vertices.
struct PolygonFigure {
    float rounding = 0.0f;
};

/// Data of a part of an outline.
struct PartFigure {
    uint32_t number = 0;  ///< place among the parts
};

struct ShapeRecord {
    ShapeDef surface;
    Figure figure;
    ShapeType type = ShapeType::circle;
    Mobility tree = Mobility::fixed;  ///< tree with the proxy: of fixed bodies, or the other
    bool closed = false;              ///< a chain
    bool geometry_dirty = false;
    bool moved = false;     ///< in the list of shapes for which pairs are searched
    bool listed = false;    ///< in the list of shapes to refresh
    bool crowded = false;   ///< its pairs are searched separately: see contacts/crowded_shapes.h
    uint32_t capacity = 0;  ///< vertices reserved in the pool

    // A chain or a concave polygon collides as its parts, which are shapes that only the library
    // uses. The outline itself is in no tree. It owns the surface; the parts have copies.
    uint32_t outline = 0;                          ///< number of its points in the pool
    uint32_t owner = none;                         ///< outline of a part
    uint32_t first_part = none, next_part = none;  ///< first part of an owner; next part of a part

    int32_t proxy = -1;
    uint32_t previous = none, next = none;  ///< in the list of the body; or next free slot
    uint32_t touching = 0;
    uint32_t rebuilds = 0;
    float area = 0.0f, moment = 0.0f;  ///< m², m⁴ about the centroid
    Vec2 centroid;

    uint32_t& next_free() { return next; }
    void set_moments(const AreaMoments& m) {
        area = float(m.area);
        moment = float(m.moment);
        centroid = {float(m.center_x), float(m.center_y)};
    }
};

static_assert(sizeof(ShapeForm) == sizeof(Position) + 24);
// A world may have a hundred thousand records of each type, so their size matters.
static_assert(sizeof(BodyRecord) <= 160 + sizeof(Position) && sizeof(ShapeRecord) <= 144);

/// True if both shapes are plain convex.
inline bool usual_forms(const ShapeForm& a, const ShapeForm& b) {
    return (uint8_t(a.kind) | uint8_t(b.kind)) == 0;
}

/// Why a contact does not act although its shapes touch.
enum class Skipped : uint8_t {
    no,
    by_callback,  ///< in this step
    crushed,      ///< until the shapes part: contacts/overlaps/crushed_bodies.h,
                  ///< contacts/overlaps/held_open.h
    wedged  ///< while another contact of the bodies opposes it: contacts/overlaps/wedged_bodies.h
};

/// A pair of shapes whose fat boxes overlap. The slots of awake contacts are listed.
struct alignas(64) ContactRecord {
    uint32_t shape_a = none, shape_b = none;  ///< shape_a < shape_b
    uint32_t body_a = none, body_b = none;
    uint32_t awake_index = none;
    bool touching = false;  ///< as reported by events
    bool sensor = false;
    bool special = false;  ///< rolling resistance, surface speed or restitution
    bool hit_events = false;
    Skipped skipped = Skipped::no;
    bool curved = false;  ///< a contact of an ellipse: it moves along the rim within the step
    /// Two points: the manifold may be kept; one: its geometry is stored. Edits of a body or its
    /// shapes reset it.
    bool kept = false;
    bool begin_reported = false;  ///< the begin of its touch was reported, and its end will be
    float friction = 0.0f;
    Manifold manifold;
    float restitution = 0.0f, rolling_resistance = 0.0f, surface_speed = 0.0f;
    float rolling_impulse = 0.0f;

    bool acts() const { return manifold.count > 0 && !sensor && skipped == Skipped::no; }
    /// The next step does not begin with the impulses of this one.
    void clear_impulses() {
        for (ManifoldPoint& point : manifold.points)
            point.normal_impulse = point.tangent_impulse = 0.0f;
        rolling_impulse = 0.0f;
    }
    void prefetch() const {
        __builtin_prefetch(this, 1);
        __builtin_prefetch(reinterpret_cast<const char*>(this) + 64, 1);
    }
};
static_assert(sizeof(ContactRecord) == 128);

/// How a manifold of two points was when it was computed: contacts/kept_manifold.h. For one point
/// the same bytes hold a PointGeometry: contacts/moving_point.h.
struct ManifoldPose {
    float angle_a = 0.0f, angle_b = 0.0f;  ///< of the bodies
    float separations[2] = {};
};

/// Data of a contact that few stages of a step read.
struct ContactLinks {
    ListEdge edges[2];   ///< in the lists of a and b, or next free slot
    uint32_t began = 0;  ///< the low bits of the number of the step in which the touch began

    uint32_t& next_free() { return edges[0].next; }
};

inline constexpr size_t joint_type_count = size_t(JointType::rotary_limit) + 1;

struct JointRecord {
    JointType type = JointType::mouse;
    bool enabled = true;
    bool collide = false;         ///< true: the two bodies collide with each other
    bool broken = false;          ///< it does not act until it is repaired
    uint32_t awake_index = none;  ///< place in the list of awake joints of its type
    uint32_t bodies[2] = {0, 0};  ///< 0: the world
    Position anchors[2];          ///< body coordinates
    ListEdge edges[2];            ///< in the lists of a and b, or next free slot
    Vec2 force;                   ///< of the last step, on body b
    float torque = 0.0f;
    float break_force = infinity, break_torque = infinity;    ///< N, N m: it breaks above
    float report_force = infinity, report_torque = infinity;  ///< N, N m: it is reported above
    float constraint_hertz = 0.0f;  ///< of its rigid rows; 0: as the load needs
    float constraint_damping_ratio = 2.0f;
    PlainValue<28 + 2 * sizeof(Position)> settings;  ///< `Settings` of its type
    PlainValue<24> impulses;  ///< `Impulses` of its type, of the last sub-step; all 0 at first
    uint64_t user_data = 0;

    uint32_t& next_free() { return edges[0].next; }
    /// Without bodies: it is tied to the world at both ends.
    bool dormant() const { return bodies[0] == 0 && bodies[1] == 0; }
    bool acts() const { return enabled && !broken; }
    /// It has an effect on its bodies, not on their contacts only.
    bool moves() const { return acts() && type != JointType::filter; }
    bool is_tuned() const { return constraint_hertz > 0.0f; }
    /// Its load is compared with the load that breaks it, or with the one that is reported.
    bool is_measured() const {
        return break_force < infinity || break_torque < infinity || report_force < infinity ||
               report_torque < infinity;
    }
};

struct FieldRecord {
    FieldDef def;
    uint32_t generation = 0;  ///< 0: the slot is free
    uint32_t next = none;     ///< for a free slot: the next free slot

    uint32_t& next_free() { return next; }
};

/// The surface of a segment of a chain that is not that of the chain.
struct SegmentRecord {
    uint32_t shape = none;    ///< the chain
    uint32_t segment = none;  ///< number of the part
    SegmentSurface surface;
};

/// Two shapes that have no contact until they have separated.
struct IgnoredPair {
    ShapeId shape_a, shape_b;
};

/// The body of a mover after its last move.
struct MoverBody {
    BodyId body;
    /// The body on which it stands. If this is the body of another mover, that mover does not give
    /// way to the body on its head.
    BodyId ground;
    Vec2 velocity;     ///< of the mover, m/s; its body is faster while it is pushed out of another
    bool old = false;  ///< the step after the move is over
};

/// The body of a mover and a dynamic body that the mover loads or pushes by itself. They have no
/// contact in the next step, in which the kinematic body would push with an infinite mass.
struct MoverPair {
    BodyId mover, other;
};

/// The weight of a mover on the dynamic body on which it stands, in the next step.
struct MoverWeight {
    BodyId mover;  ///< its body, if it has one
    BodyId body;
    Load load;
};

/// The user data of the contact of two shapes: World::set_contact_data.
struct ContactUserData {
    ShapeId shape_a, shape_b;  ///< in the order of a `ContactId`
    uint64_t user_data = 0;
    bool ended = false;  ///< the shapes separated in the last step
};

/// Bodies that fell asleep together and will wake together; linked through their records.
struct Island {
    uint32_t first = none;
    uint32_t next = none;  ///< for a free slot: the next free slot

    uint32_t& next_free() { return next; }
};

}  // namespace fettle::physics::detail
