#pragma once

#include <calls/inside.h>

#include <fettle/physics/physics.h>

#include <concepts>
#include <type_traits>

// Values of the library as values in C, and the other way round.

namespace fettle::physics_c {

// --- Ids: generation (32 bits), kind (4 bits), slot (28 bits)

template <class Id>
inline constexpr uint32_t kind_of = 0;
template <>
inline constexpr uint32_t kind_of<physics::BodyId> = 1;
template <>
inline constexpr uint32_t kind_of<physics::ShapeId> = 2;
template <>
inline constexpr uint32_t kind_of<physics::JointId> = 3;
template <>
inline constexpr uint32_t kind_of<physics::FieldId> = 4;

inline constexpr uint32_t slot_bits = 28;

fettle_id packed(uint32_t index, uint32_t generation, uint32_t kind);
/// The slot of an id; throws Failure if it is 0 or of another kind.
uint32_t unpacked(fettle_id id, uint32_t kind);
/// Throws `Damaged` if the world is damaged: its ids are not valid then, although the objects were
/// not destroyed.
void refuse_if_damaged(physics::World& world);
[[noreturn]] void refuse_stale(fettle_id id, uint32_t kind);
[[noreturn]] void refuse_joint(physics::JointType wanted, physics::JointType is);

template <class Object>
using IdOf = decltype(std::declval<const Object&>().id());

template <class Object>
struct JointTypeOf {};
#define FETTLE_JOINT_TYPE(Name, name)                                         \
    template <>                                                               \
    struct JointTypeOf<physics::Name> {                                       \
        static constexpr physics::JointType value = physics::JointType::name; \
    };
FETTLE_JOINT_TYPE(MouseJoint, mouse)
FETTLE_JOINT_TYPE(DistanceJoint, distance)
FETTLE_JOINT_TYPE(RevoluteJoint, revolute)
FETTLE_JOINT_TYPE(PrismaticJoint, prismatic)
FETTLE_JOINT_TYPE(WheelJoint, wheel)
FETTLE_JOINT_TYPE(WeldJoint, weld)
FETTLE_JOINT_TYPE(MotorJoint, motor)
FETTLE_JOINT_TYPE(PulleyJoint, pulley)
FETTLE_JOINT_TYPE(GearJoint, gear)
FETTLE_JOINT_TYPE(GrooveJoint, groove)
FETTLE_JOINT_TYPE(PinSlotJoint, pin_slot)
FETTLE_JOINT_TYPE(RatchetJoint, ratchet)
FETTLE_JOINT_TYPE(FilterJoint, filter)
FETTLE_JOINT_TYPE(RotaryLimitJoint, rotary_limit)
#undef FETTLE_JOINT_TYPE

/// Handle to the object with an id; throws Failure if there is none of this type.
template <class Object>
Object handle(const fettle_world* world, fettle_id id) {
    using Id = IdOf<Object>;
    physics::World& in = live(world);
    const Id name{unpacked(id, kind_of<Id>), uint32_t(id >> 32)};
    if (!in.is_valid(name)) {
        refuse_if_damaged(in);
        refuse_stale(id, kind_of<Id>);
    }
    const Object object(&in, name);
    if constexpr (requires { JointTypeOf<Object>::value; }) {
        if (object.type() != JointTypeOf<Object>::value)
            refuse_joint(JointTypeOf<Object>::value, object.type());
    }
    return object;
}

/// The body with an id. `name()` returns the text at the start of error messages: the name of the
/// argument, member or element.
template <class Name>
physics::Body body_named(const Name& name, const fettle_world* world, fettle_id id) {
    try {
        return handle<physics::Body>(world, id);
    } catch (Failure& failure) {
        failure.message = std::string(name()) + ": " + failure.message;
        throw;
    }
}

/// An empty body for id 0, which is the world.
physics::Body body_or_world(const char* name, const fettle_world* world, fettle_id id);

template <class Id>
bool lives(const fettle_world* world, fettle_id id) noexcept {
    const uint32_t kind = uint32_t(id) >> slot_bits;
    return world != nullptr && world->world != nullptr && kind == kind_of<Id> &&
           world->world->is_valid(Id{uint32_t(id) & ((1u << slot_bits) - 1), uint32_t(id >> 32)});
}

// --- To C

template <class Value>
requires std::is_arithmetic_v<Value> Value converted(Value value) {
    return value;
}
template <class Value>
requires std::is_enum_v<Value> int32_t converted(Value value) {
    return int32_t(value);
}
template <class Id>
requires(kind_of<Id> != 0) fettle_id converted(const Id& id) {
    return packed(id.index, id.generation, kind_of<Id>);
}
template <class Object>
requires(kind_of<IdOf<Object>> != 0) fettle_id converted(const Object& object) {
    return converted(object.id());
}
inline fettle_vec2 converted(const physics::Vec2& v) {
    return {v.x, v.y};
}
#ifdef FETTLE_PHYSICS_DOUBLE
inline fettle_position converted(const physics::Position& p) {
    return {p.x, p.y};
}
#endif
inline fettle_aabb converted(const physics::Aabb& box) {
    return {converted(box.min), converted(box.max)};
}
inline fettle_pose converted(const physics::Pose& pose) {
    return {converted(pose.position), pose.angle};
}
fettle_body_state converted(const physics::BodyState& state);
fettle_contact converted(const physics::Contact& contact);
fettle_ray_hit converted(const physics::RayHit& hit);
fettle_point_hit converted(const physics::PointHit& hit);
fettle_memory_share converted(const physics::MemoryShare& share);
fettle_contact_share converted(const physics::ContactShare& share);
fettle_joint_share converted(const physics::JointShare& share);
void write_geometry(const physics::Shape& shape, fettle_geometry* geometry);

// --- From C

void check_size(size_t given, size_t expected);
inline physics::Vec2 vector_of(const fettle_vec2& v) {
    return {v.x, v.y};
}
inline physics::Position position_of(const fettle_position& p) {
    return {p.x, p.y};
}
inline physics::Aabb box_of(const fettle_aabb& box) {
    return {position_of(box.min), position_of(box.max)};
}
inline physics::Pose pose_of(const fettle_pose* pose) {
    return pose == nullptr ? physics::Pose{}
                           : physics::Pose{position_of(pose->position), pose->angle};
}
[[noreturn]] void refuse_enumerator(const char* name, int32_t value, int32_t last);
template <class Enum>
Enum enumerator(const char* name, int32_t value, Enum last) {
    if (value < 0 || value > int32_t(last)) refuse_enumerator(name, value, int32_t(last));
    return Enum(value);
}
std::vector<physics::Vec2> points_of(const fettle_vec2* points, uint32_t count);
physics::Geometry geometry_of(const fettle_geometry* geometry);
// A null definition stands for the defaults where the library has such; otherwise it is refused.
physics::WorldDef definition_of(const fettle_world_def* def);
physics::BodyDef definition_of(const fettle_body_def* def);
physics::ShapeDef definition_of(const fettle_shape_def* def);
physics::MouseJointDef definition_of(const fettle_world* world, const fettle_mouse_joint_def* def);
physics::FieldDef definition_of(const fettle_field_def* def);
physics::QueryFilter filter_of(const fettle_world* world, const fettle_query_filter* filter);

}  // namespace fettle::physics_c
