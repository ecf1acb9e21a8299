#include <fettle/physics_c/joint_definitions.h>
#include <fettle/physics_c/world.h>

#include <calls/calls.h>

// Definitions of joints. The members in C have the names of those of the library; a value that may
// be missing there has a `has_...` here.

using namespace fettle::physics;
using namespace fettle::physics_c;

namespace {

// From the library to C, and back.
struct ToC {
    template <class InC, class Value>
    void operator()(InC& result, const Value& value) const {
        result = converted(value);
    }
    void operator()(bool& has, float& result, const std::optional<float>& value) const {
        has = value.has_value();
        result = value.value_or(0.0f);
    }
};
struct FromC {
    void operator()(const bool& given, bool& result) const { result = flag(given); }
    void operator()(const float& given, float& result) const { result = given; }
    void operator()(const uint64_t& given, uint64_t& result) const { result = given; }
    void operator()(const fettle_vec2& given, Vec2& result) const { result = vector_of(given); }
#ifdef FETTLE_PHYSICS_DOUBLE
    void operator()(const fettle_position& given, Position& result) const {
        result = position_of(given);
    }
#endif
    void operator()(const bool& has, const float& given, std::optional<float>& result) const {
        if (flag(has)) result = given;
    }
};

/// Calls `each` with each member of a definition in C but its bodies, and the one of the library.
template <class InC, class Def, class Each>
void each_member(InC& c, Def& def, const Each& each) {
    each(c.anchor_a, def.anchor_a);
    each(c.anchor_b, def.anchor_b);
    each(c.collide, def.collide);
    each(c.enabled, def.enabled);
    each(c.user_data, def.user_data);
    each(c.break_force, def.break_force);
    each(c.break_torque, def.break_torque);
    each(c.report_force, def.report_force);
    each(c.report_torque, def.report_torque);
    each(c.constraint_hertz, def.constraint_hertz);
    each(c.constraint_damping_ratio, def.constraint_damping_ratio);
#define FETTLE_MEMBER(name) \
    if constexpr (requires { def.name; }) each(c.name, def.name);
#define FETTLE_OPTIONAL_MEMBER(name) \
    if constexpr (requires { def.name; }) each(c.has_##name, c.name, def.name);
    FETTLE_OPTIONAL_MEMBER(length)
    FETTLE_OPTIONAL_MEMBER(reference_angle)
    FETTLE_OPTIONAL_MEMBER(angular_offset)
    FETTLE_OPTIONAL_MEMBER(phase)
    FETTLE_MEMBER(min_length)
    FETTLE_MEMBER(max_length)
    FETTLE_MEMBER(hertz)
    FETTLE_MEMBER(damping_ratio)
    FETTLE_MEMBER(angular_hertz)
    FETTLE_MEMBER(angular_damping_ratio)
    FETTLE_MEMBER(lower_spring_force)
    FETTLE_MEMBER(upper_spring_force)
    FETTLE_MEMBER(motor_speed)
    FETTLE_MEMBER(max_motor_force)
    FETTLE_MEMBER(max_motor_torque)
    FETTLE_MEMBER(lower_angle)
    FETTLE_MEMBER(upper_angle)
    FETTLE_MEMBER(target_angle)
    FETTLE_MEMBER(axis)
    FETTLE_MEMBER(lower_translation)
    FETTLE_MEMBER(upper_translation)
    FETTLE_MEMBER(target_translation)
    FETTLE_MEMBER(linear_velocity)
    FETTLE_MEMBER(angular_velocity)
    FETTLE_MEMBER(max_force)
    FETTLE_MEMBER(max_torque)
    FETTLE_MEMBER(linear_offset)
    FETTLE_MEMBER(ground_a)
    FETTLE_MEMBER(ground_b)
    FETTLE_MEMBER(ratio)
    FETTLE_MEMBER(end)
    FETTLE_MEMBER(tooth)
    FETTLE_MEMBER(backwards)
#undef FETTLE_MEMBER
#undef FETTLE_OPTIONAL_MEMBER
}

template <class Def, class InC>
fettle_code init_joint(const char* function, InC* def, size_t size) {
    InC result{};
    Def defaults;
    each_member(result, defaults, ToC());
    return init(function, def, size, result);
}

template <class Def, auto create, class InC>
fettle_code create_joint(const char* function, fettle_world* world, const InC* def,
                         fettle_id* joint) {
    return guarded(function, [&] {
        World& in = editable(world);
        const InC& given = needed("def", def);
        check_size(given.size, sizeof given);
        Def result;
        result.body_a = body_or_world("body_a", world, given.body_a).id();
        result.body_b = body_or_world("body_b", world, given.body_b).id();
        each_member(given, result, FromC());
        give(joint, (in.*create)(result).id());
    });
}

}  // namespace

#define FETTLE_JOINT(name, Def)                                                                 \
    fettle_code fettle_##name##_def_init(fettle_##name##_def* def, size_t size) {               \
        return init_joint<Def>(__func__, def, size);                                            \
    }                                                                                           \
    fettle_code fettle_world_create_##name(fettle_world* world, const fettle_##name##_def* def, \
                                           fettle_id* joint) {                                  \
        return create_joint<Def, &World::create_##name>(__func__, world, def, joint);           \
    }
FETTLE_JOINT(distance_joint, DistanceJointDef)
FETTLE_JOINT(revolute_joint, RevoluteJointDef)
FETTLE_JOINT(prismatic_joint, PrismaticJointDef)
FETTLE_JOINT(wheel_joint, WheelJointDef)
FETTLE_JOINT(weld_joint, WeldJointDef)
FETTLE_JOINT(motor_joint, MotorJointDef)
FETTLE_JOINT(pulley_joint, PulleyJointDef)
FETTLE_JOINT(gear_joint, GearJointDef)
FETTLE_JOINT(groove_joint, GrooveJointDef)
FETTLE_JOINT(pin_slot_joint, PinSlotJointDef)
FETTLE_JOINT(ratchet_joint, RatchetJointDef)
FETTLE_JOINT(filter_joint, FilterJointDef)
FETTLE_JOINT(rotary_limit_joint, RotaryLimitJointDef)
#undef FETTLE_JOINT
