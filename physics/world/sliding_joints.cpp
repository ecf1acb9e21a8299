#include <world/live_joint.h>

// The handles of the joints that slide.

namespace fettle::physics {

using namespace detail;

namespace {

/// How far anchor b is from anchor a along a direction in the coordinates of a.
float along(const Joint& joint, const Vec2& direction) {
    const V2 axis = normalized(to_v2(direction));
    const Body a = joint.body_a();
    const Vec2 turned = a ? a.world_vector(to_vec2(axis)) : to_vec2(axis);
    return turned.dot(gap_between(joint));
}

}  // namespace

// What every joint on a rail has, and what those have whose motor drives along it.
#define FETTLE_RAIL(Joint, Data)                                                           \
    FETTLE_JOINT_VECTOR(Joint, Data, axis, rail.axis, check_direction("axis", value))      \
    FETTLE_JOINT_FIELD(Joint, Data, lower_translation, rail.lower,                         \
                       check_limit("lower_translation", value))                            \
    FETTLE_JOINT_FIELD(Joint, Data, upper_translation, rail.upper,                         \
                       check_limit("upper_translation", value))                            \
    FETTLE_JOINT_FIELD(Joint, Data, hertz, rail.hertz, check_not_negative("hertz", value)) \
    FETTLE_JOINT_FIELD(Joint, Data, damping_ratio, rail.damping_ratio,                     \
                       check_not_negative("damping_ratio", value))                         \
    float Joint::translation() const {                                                     \
        return along(*this, axis());                                                       \
    }
#define FETTLE_RAIL_MOTOR(Joint, Data)                                     \
    FETTLE_JOINT_FIELD(Joint, Data, motor_speed, rail.motor_speed,         \
                       check_finite("motor_speed", value))                 \
    FETTLE_JOINT_FIELD(Joint, Data, max_motor_force, rail.max_motor_force, \
                       check_strength("max_motor_force", value))           \
    FETTLE_JOINT_FIELD(Joint, Data, target_translation, rail.target,       \
                       check_finite("target_translation", value))          \
    float Joint::motor_force() const {                                     \
        return per_substep(own<Data>().impulses.rail.motor);               \
    }

FETTLE_RAIL(PrismaticJoint, PrismaticData)
FETTLE_RAIL_MOTOR(PrismaticJoint, PrismaticData)
FETTLE_JOINT_SETTING(PrismaticJoint, PrismaticData, reference_angle,
                     check_finite("reference_angle", value))
float PrismaticJoint::angle() const {
    return angle_between(*this) - reference_angle();
}

FETTLE_RAIL(PinSlotJoint, PinSlotData)
FETTLE_RAIL_MOTOR(PinSlotJoint, PinSlotData)

FETTLE_RAIL(WheelJoint, WheelData)
FETTLE_JOINT_SETTING(WheelJoint, WheelData, motor_speed, check_finite("motor_speed", value))
FETTLE_JOINT_SETTING(WheelJoint, WheelData, max_motor_torque,
                     check_strength("max_motor_torque", value))
float WheelJoint::motor_torque() const {
    return per_substep(own<WheelData>().impulses.motor);
}

FETTLE_JOINT_VECTOR(GrooveJoint, GrooveData, end, end, check_coordinates("end", value))
float GrooveJoint::translation() const {
    return along(*this, end() - anchor_a());
}

}  // namespace fettle::physics
