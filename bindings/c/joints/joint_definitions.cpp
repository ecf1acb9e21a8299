#include <fettle/physics_c/joint_definitions.h>
#include <fettle/physics_c/world.h>

#include <calls/members.h>

// Definitions of joints.

namespace fettle::physics_c {

using namespace physics;

/// All members but the bodies, whose ids need the world.
template <class InC, JointDefinition Def, class Each>
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

namespace {

template <class Def, auto create, class InC>
fettle_code create_joint(const char* function, fettle_world* world, const InC* def,
                         fettle_id* joint) {
    return guarded(function, [&] {
        World& in = editable(world);
        Def result = from_c<Def>(needed("def", def));
        result.body_a = body_or_world("body_a", world, def->body_a).id();
        result.body_b = body_or_world("body_b", world, def->body_b).id();
        store_id(joint, (in.*create)(result).id());
    });
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics;
using namespace fettle::physics_c;

#define FETTLE_JOINT(name, Def)                                                                 \
    fettle_code fettle_##name##_def_init(fettle_##name##_def* def, size_t size) {               \
        return init_as<Def>(__func__, def, size);                                               \
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
