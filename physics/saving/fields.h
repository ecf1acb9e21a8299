#pragma once

#include <state/member_list.h>
#include <state/world_state.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>
#include <variant>

// The fields of all records of a world. A saved record consists of its fields in this order,
// without gaps: numbers with their lowest byte first, floats as their bits. So the bytes do not
// depend on how a compiler lays out a struct, nor on the byte order of the machine. An optional is
// a flag and a value, a variant a number and all of its alternatives: every record of a type takes
// equally many bytes.

namespace fettle::physics::detail {

/// `One` is `Record` or `const Record`.
template <class One, class Record>
concept Some = std::same_as<std::remove_const_t<One>, Record>;

/// Passes all fields of a record. Each element of an array counts.
template <class Record, class Io, class... Field>
void fields_of(Io& io, Field&... each) {
    static_assert(sizeof...(Field) == count_members<Record>(), "a field is not listed");
    io(each...);
}
/// Passes a value as numbers of four bytes.
template <class Io, class Value>
void numbers_of(Io& io, Value& value) {
    std::array<uint32_t, sizeof(Value) / 4> numbers;
    static_assert(sizeof numbers == sizeof value);
    std::memcpy(&numbers, &value, sizeof value);
    io(numbers);
    if constexpr (!std::is_const_v<Value>)
        std::memcpy(static_cast<void*>(&value), &numbers, sizeof value);
}

// --- Values

void fields(auto& io, Some<Vec2> auto& v) {
    io(v.x, v.y);
}
#ifdef FETTLE_PHYSICS_DOUBLE
void fields(auto& io, Some<Position> auto& v) {
    io(v.x, v.y);
}
#endif
void fields(auto& io, Some<Aabb> auto& box) {
    io(box.min, box.max);
}
void fields(auto& io, Some<Box4> auto& box) {
    io(box.low, box.high);
}
template <class Id>
concept ObjectId = Some<Id, BodyId> || Some<Id, ShapeId> || Some<Id, JointId>;
void fields(auto& io, ObjectId auto& id) {
    io(id.index, id.generation);
}
template <class Io, class T, std::size_t n>
void fields(Io& io, std::array<T, n>& list) {
    for (T& each : list) io(each);
}
template <class Io, class T, std::size_t n>
void fields(Io& io, const std::array<T, n>& list) {
    for (const T& each : list) io(each);
}
template <class Io, class T>
void fields(Io& io, const std::optional<T>& value) {
    bool given = value.has_value();
    T inside = value.value_or(T{});
    io(given, inside);
}
template <class Io, class T>
void fields(Io& io, std::optional<T>& value) {
    bool given = value.has_value();
    T inside = value.value_or(T{});
    io(given, inside);
    value = given ? std::optional<T>(inside) : std::nullopt;
}

/// Figures, and impulses of joints: they consist of numbers of four bytes.
void fields(auto& io, Some<PlainValue<24>> auto& value) {
    numbers_of(io, value);
}

// --- Bodies

void fields(auto& io, Some<Pose> auto& s) {
    fields_of<Pose>(io, s.position, s.angle);
}
void fields(auto& io, Some<BodyState> auto& s) {
    fields_of<BodyState>(io, s.position, s.angle, s.angular_velocity, s.velocity, s.cosine, s.sine);
}
void fields(auto& io, Some<RestPose> auto& s) {
    fields_of<RestPose>(io, s.center, s.angle, s.first_way, s.drawn_time);
}
void fields(auto& io, Some<Stay> auto& s) {
    fields_of<Stay>(io, s.body, s.returns, s.angle, s.center, s.time, s.far, s.back, s.fastest);
}
void fields(auto& io, Some<Load> auto& s) {
    fields_of<Load>(io, s.force, s.torque);
}
void fields(auto& io, Some<BodyFlags> auto& s) {
    fields_of<BodyFlags>(io, s.locked_x, s.locked_y, s.locked_rotation, s.can_sleep, s.bullet,
                         s.never_awake, s.mass_dirty, s.placement_dirty, s.disabled);
}
void fields(auto& io, Some<BodyLists> auto& s) {
    fields_of<BodyLists>(io, s.first_shape, s.last_shape, s.first_contact, s.contact_count,
                         s.touching, s.island, s.next, s.first_joint, s.joint_count);
}
void fields(auto& io, Some<GivenMass> auto& s) {
    fields_of<GivenMass>(io, s.mass, s.inertia, s.center);
}
void fields(auto& io, Some<BodyRecord> auto& s) {
    Mobility mobility = s.mobility;  // these two are parts of one byte
    uint8_t listed = s.listed;
    fields_of<BodyRecord>(io, s.center, s.local_center, s.inverse_mass, s.inverse_inertia,
                          s.gravity_scale, s.linear_damping, s.angular_damping, s.load, s.step_load,
                          s.angle_rest, s.extent, s.thickness, s.sleep_time, s.solver_index,
                          mobility, listed, s.type, s.flags, s.may_be_crowded, s.lists, s.mass,
                          s.inertia, s.given, s.rebuilds, s.traits, s.user_data);
    if constexpr (!std::is_const_v<std::remove_reference_t<decltype(s)>>) {
        s.mobility = mobility;
        s.listed = listed;
    }
}
void fields(auto& io, Some<BodyTraits> auto& s) {
    fields_of<BodyTraits>(io, s.sleep_speed, s.max_speed, s.next, s.name);
}
void fields(auto& io, Some<Island> auto& s) {
    fields_of<Island>(io, s.first, s.next);
}
void fields(auto& io, Some<Slots> auto& s) {
    fields_of<Slots>(io, s.free, s.count);
}

// --- Shapes

void fields(auto& io, Some<ShapeDef> auto& s) {
    fields_of<ShapeDef>(io, s.density, s.friction, s.restitution, s.rolling_resistance,
                        s.surface_speed, s.sensor, s.hit_events, s.contact_events, s.sensor_events,
                        s.category, s.mask, s.group, s.material, s.before_solve, s.user_data);
}
void fields(auto& io, Some<ShapeForm> auto& s) {
    uint32_t count = s.count;  // these two are parts of one word
    FormKind kind = s.kind;
    fields_of<ShapeForm>(io, s.begin, count, kind, s.radius, s.body, s.center, s.angle, s.turn);
    if constexpr (!std::is_const_v<std::remove_reference_t<decltype(s)>>) {
        s.count = count & 0xffffffu;
        s.kind = kind;
    }
}
void fields(auto& io, Some<ShapeRecord> auto& s) {
    fields_of<ShapeRecord>(io, s.surface, s.figure, s.type, s.tree, s.closed, s.geometry_dirty,
                           s.moved, s.listed, s.crowded, s.capacity, s.outline, s.owner,
                           s.first_part, s.next_part, s.proxy, s.previous, s.next, s.touching,
                           s.rebuilds, s.area, s.moment, s.centroid);
}
void fields(auto& io, Some<SegmentSurface> auto& s) {
    fields_of<SegmentSurface>(io, s.friction, s.restitution, s.rolling_resistance, s.surface_speed,
                              s.material);
}
void fields(auto& io, Some<SegmentRecord> auto& s) {
    fields_of<SegmentRecord>(io, s.shape, s.segment, s.surface);
}

// --- Contacts

void fields(auto& io, Some<ManifoldPoint> auto& s) {
    fields_of<ManifoldPoint>(io, s.anchor_a, s.anchor_b, s.separation, s.normal_impulse,
                             s.tangent_impulse, s.feature);
}
void fields(auto& io, Some<Manifold> auto& s) {
    fields_of<Manifold>(io, s.normal, s.count, s.corner, s.points[0], s.points[1]);
}
void fields(auto& io, Some<ContactRecord> auto& s) {
    fields_of<ContactRecord>(io, s.shape_a, s.shape_b, s.body_a, s.body_b, s.awake_index,
                             s.touching, s.sensor, s.special, s.hit_events, s.skipped, s.curved,
                             s.kept, s.begin_reported, s.friction, s.manifold, s.restitution,
                             s.rolling_resistance, s.surface_speed, s.rolling_impulse);
}
void fields(auto& io, Some<ListEdge> auto& s) {
    fields_of<ListEdge>(io, s.previous, s.next);
}
void fields(auto& io, Some<ContactLinks> auto& s) {
    fields_of<ContactLinks>(io, s.edges[0], s.edges[1], s.began);
}
void fields(auto& io, Some<ManifoldPose> auto& s) {
    fields_of<ManifoldPose>(io, s.angle_a, s.angle_b, s.separations[0], s.separations[1]);
}
void fields(auto& io, Some<IgnoredPair> auto& s) {
    fields_of<IgnoredPair>(io, s.shape_a, s.shape_b);
}
void fields(auto& io, Some<MoverBody> auto& s) {
    fields_of<MoverBody>(io, s.body, s.ground, s.velocity, s.old);
}
void fields(auto& io, Some<MoverPair> auto& s) {
    fields_of<MoverPair>(io, s.mover, s.other);
}
void fields(auto& io, Some<MoverWeight> auto& s) {
    fields_of<MoverWeight>(io, s.mover, s.body, s.load);
}
void fields(auto& io, Some<ContactUserData> auto& s) {
    fields_of<ContactUserData>(io, s.shape_a, s.shape_b, s.user_data, s.ended);
}

// --- Joints

/// Settings of a joint: floats, before which some types have the coordinates of points.
template <class Settings>
struct SettingsOf {
    Settings& settings;
    const JointType& type;  ///< read before the settings

    static void fields(auto& io, auto& s) {
        const std::size_t points = s.type == JointType::pulley   ? 2
                                   : s.type == JointType::groove ? 1
                                                                 : 0;
        std::array<WorldCoordinate, 4> coordinates = {};
        std::array<uint32_t, sizeof(Settings) / 4> floats;
        std::memcpy(&coordinates, &s.settings, points * sizeof(Position));
        std::memcpy(&floats, &s.settings, sizeof floats);
        for (std::size_t i = 0; i < 2 * points; ++i) io(coordinates[i]);
        for (std::size_t i = points * sizeof(Position) / 4; i < floats.size(); ++i) io(floats[i]);
        if constexpr (!std::is_const_v<Settings>) {
            std::memcpy(static_cast<void*>(&s.settings), &floats, sizeof floats);
            std::memcpy(static_cast<void*>(&s.settings), &coordinates, points * sizeof(Position));
        }
    }
};
void fields(auto& io, Some<JointRecord> auto& s) {
    SettingsOf<std::remove_reference_t<decltype((s.settings))>> settings = {s.settings, s.type};
    fields_of<JointRecord>(io, s.type, s.enabled, s.collide, s.broken, s.awake_index, s.bodies[0],
                           s.bodies[1], s.anchors[0], s.anchors[1], s.edges[0], s.edges[1], s.force,
                           s.torque, s.break_force, s.break_torque, s.report_force, s.report_torque,
                           s.constraint_hertz, s.constraint_damping_ratio, settings, s.impulses,
                           s.user_data);
}

// --- Fields of force

void fields(auto& io, Some<WindField> auto& s) {
    fields_of<WindField>(io, s.velocity, s.density);
}
void fields(auto& io, Some<DragField> auto& s) {
    fields_of<DragField>(io, s.flow, s.linear, s.quadratic);
}
void fields(auto& io, Some<BuoyancyField> auto& s) {
    fields_of<BuoyancyField>(io, s.level, s.normal, s.density, s.drag, s.flow);
}
void fields(auto& io, Some<AttractorField> auto& s) {
    fields_of<AttractorField>(io, s.center, s.strength, s.falloff, s.core);
}
template <class Io, class... Kind>
void fields(Io& io, const std::variant<Kind...>& value) {
    const auto number = uint8_t(value.index());
    io(number);
    const auto one = [&]<class Of>(Of initial) {
        if (const auto* current = std::get_if<Of>(&value)) initial = *current;
        io(initial);
    };
    (one(Kind{}), ...);
}
template <class Io, class... Kind>
void fields(Io& io, std::variant<Kind...>& value) {
    auto number = uint8_t(value.index());
    io(number);
    std::size_t next = 0;
    const auto one = [&]<class Of>(Of initial) {
        if (const auto* current = std::get_if<Of>(&value)) initial = *current;
        io(initial);
        if (next++ == number) value = initial;
    };
    (one(Kind{}), ...);
    if (number >= sizeof...(Kind)) io.refuse("the number of an alternative is out of range");
}
void fields(auto& io, Some<FieldDef> auto& s) {
    fields_of<FieldDef>(io, s.force, s.region, s.mask, s.enabled, s.user_data);
}
void fields(auto& io, Some<FieldRecord> auto& s) {
    fields_of<FieldRecord>(io, s.def, s.generation, s.next);
}

// --- The world

void fields(auto& io, Some<WorldDef> auto& s) {
    fields_of<WorldDef>(io, s.gravity, s.substeps, s.bounds, s.bounds_friction,
                        s.bounds_restitution, s.sleeping, s.continuous, s.restitution_threshold,
                        s.hit_threshold, s.sleep_speed, s.sleep_delay, s.contact_hertz,
                        s.contact_damping, s.push_speed, s.max_speed, s.friction_mix,
                        s.restitution_mix, s.solver, s.persist_events);
}
/// The seven times are left out: they differ in each run, and worlds with the same history must be
/// saved as the same bytes.
void fields(auto& io, Some<StepStatistics> auto& s) {
    constexpr size_t counts = 13, times = 7;
    static_assert(counts + times == count_members<StepStatistics>(), "a field is not listed");
    io(s.steps, s.bodies, s.awake_bodies, s.shapes, s.joints, s.awake_joints, s.contacts,
       s.awake_contacts, s.touching, s.islands, s.moved_proxies, s.direct_solves,
       s.direct_failures);
}

// --- The broad phase. Its records have no names outside of it.

template <class One>
concept TreeNode = requires(One& s) {
    s.box, s.parent, s.left, s.right, s.moved;
};
void fields(auto& io, TreeNode auto& s) {
    fields_of<std::remove_cvref_t<decltype(s)>>(io, s.box, s.parent, s.left, s.right, s.moved);
}
template <class One>
concept PairOfShapes = requires(One& s) {
    s.lower, s.upper;
};
void fields(auto& io, PairOfShapes auto& s) {
    fields_of<std::remove_cvref_t<decltype(s)>>(io, s.lower, s.upper);
}
template <class One>
concept PairWithContact = requires(One& s) {
    s.pair, s.contact;
};
void fields(auto& io, PairWithContact auto& s) {
    fields_of<std::remove_cvref_t<decltype(s)>>(io, s.pair, s.contact);
}
void fields(auto& io, Some<Strips> auto& strips) {
    numbers_of(io, strips);
}

// --- Events

template <class Event>
concept ContactEvent = Some<Event, ContactBeginEvent> || Some<Event, ContactPersistEvent> ||
    Some<Event, ContactHitEvent>;
void fields(auto& io, ContactEvent auto& s) {
    fields_of<std::remove_cvref_t<decltype(s)>>(
        io, s.shape_a, s.shape_b, s.body_a, s.body_b, s.point, s.normal, s.speed, s.impulse,
        s.friction, s.restitution, s.part_a, s.part_b, s.material_a, s.material_b);
}
void fields(auto& io, Some<ContactEndEvent> auto& s) {
    fields_of<ContactEndEvent>(io, s.shape_a, s.shape_b, s.body_a, s.body_b);
}
void fields(auto& io, Some<SensorEvent> auto& s) {
    fields_of<SensorEvent>(io, s.sensor, s.visitor, s.sensor_body, s.visitor_body);
}
template <class Event>
concept JointEvent = Some<Event, JointBreakEvent> || Some<Event, JointLoadEvent>;
void fields(auto& io, JointEvent auto& s) {
    fields_of<std::remove_cvref_t<decltype(s)>>(io, s.joint, s.body_a, s.body_b, s.force, s.torque);
}

}  // namespace fettle::physics::detail
